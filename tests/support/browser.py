"""A headless browser: what a page becomes after a script has used it, and what it looks like."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from html import unescape
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

NAMES = ("chromium", "chromium-browser", "google-chrome", "chrome")
FLAGS = (
    "--headless --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader --disable-quic --no-first-run "
    "--disable-background-networking --disable-component-update --disable-sync --hide-scrollbars "
    "--virtual-time-budget=4000"
).split()


def _command(folder: Path, *more: str) -> list[str]:
    found = next((path for path in map(shutil.which, NAMES) if path), None)
    if found is None:
        pytest.skip("no browser is installed")
    return [found, *FLAGS, f"--user-data-dir={folder / 'profile'}", *more]


def used(page: str, folder: Path, script: str, state: str = "") -> dict[str, Any]:
    """The data attributes of the page's root after `script` has run in the loaded page; JSON in `probe` is read."""
    path = folder / "used.html"
    path.write_text(page.replace("</body>", f"<script>{script}</script></body>"), encoding="utf-8")
    address = path.as_uri() + (f"#{state}" if state else "")
    done = subprocess.run(
        _command(folder, "--window-size=1366,768", "--dump-dom", address), capture_output=True, text=True, timeout=180
    )
    root = re.search(r"<html[^>]*>", done.stdout)
    assert root, done.stderr
    found: dict[str, Any] = {key: unescape(value) for key, value in re.findall(r'data-(\w+)="([^"]*)"', root.group())}
    if "probe" in found:
        found["probe"] = json.loads(found["probe"])
    return found


def screenshot(page: str, folder: Path, state: str = "", size: tuple[int, int] = (1366, 768)) -> Image.Image:
    """What the page looks like."""
    path, picture = folder / "seen.html", folder / "seen.png"
    path.write_text(page, encoding="utf-8")
    address = path.as_uri() + (f"#{state}" if state else "")
    more = (f"--window-size={size[0]},{size[1]}", f"--screenshot={picture}", address)
    done = subprocess.run(_command(folder, *more), capture_output=True, text=True, timeout=180)
    assert picture.is_file(), done.stderr
    with Image.open(picture) as image:
        return image.convert("RGB")
