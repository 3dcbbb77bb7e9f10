"""A headless browser: what a page becomes after a script has used it, and what it looks like.

One browser serves all pages of a test process, told what to do by the DevTools protocol over two pipes: starting one
takes longer than a page does.
"""

from __future__ import annotations

import base64
import io
import itertools
import json
import os
import select
import shutil
import subprocess
import tempfile
import time
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

NAMES = ("chromium", "chromium-browser", "google-chrome", "chrome")
FLAGS = (
    "--headless --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader --disable-quic --no-first-run "
    "--disable-background-networking --disable-component-update --disable-sync --hide-scrollbars "
    "--remote-debugging-pipe"
).split()
SIZE = (1366, 768)
PATIENCE = 180.0  # s for an answer
BUDGET = 4000  # ms of the page's own time before it is looked at
READ = "Object.fromEntries([...document.documentElement.attributes].map(one => [one.name, one.value]))"


class Browser:
    """A running browser; `ask` sends a command and waits for its result, `until` for an event."""

    def __init__(self, command: str) -> None:
        self._profile = tempfile.mkdtemp(prefix="browser-")
        # it reads commands from descriptor 3 and writes answers to descriptor 4
        pipes = 'exec "$@" 3<&0 4>&1 0</dev/null 1>/dev/null 2>/dev/null'
        self._process = subprocess.Popen(
            ["sh", "-c", pipes, "sh", command, *FLAGS, f"--user-data-dir={self._profile}"],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0,
        )  # fmt: skip
        assert self._process.stdin and self._process.stdout
        self._told, self._heard, self._rest = self._process.stdin.fileno(), self._process.stdout.fileno(), b""
        self._numbers = itertools.count(1)
        self._events: list[dict[str, Any]] = []

    def ask(self, method: str, session: str = "", **parameters: Any) -> dict[str, Any]:
        """The result of a command, to the browser or to a page of it."""
        number = next(self._numbers)
        message = {"id": number, "method": method, "params": parameters, **({"sessionId": session} if session else {})}
        sent = json.dumps(message).encode() + b"\0"
        while sent:
            sent = sent[os.write(self._told, sent) :]
        while (answer := self._message()).get("id") != number:
            self._events.append(answer)
        assert "error" not in answer, (method, answer)
        return dict(answer["result"])

    def until(self, method: str, session: str) -> None:
        """Wait for an event of a page."""
        while not any(one.get("method") == method and one.get("sessionId") == session for one in self._events):
            self._events.append(self._message())

    def forget(self) -> None:
        """Events until now are of no interest."""
        self._events.clear()

    def _message(self) -> dict[str, Any]:
        end = time.monotonic() + PATIENCE
        while b"\0" not in self._rest:
            ready, _, _ = select.select([self._heard], [], [], max(0.0, end - time.monotonic()))
            found = os.read(self._heard, 2**20) if ready else b""
            assert found, "the browser does not answer"
            self._rest += found
        text, _, self._rest = self._rest.partition(b"\0")
        return dict(json.loads(text))

    def close(self) -> None:
        """End it, and remove what it left."""
        self._process.terminate()
        self._process.communicate(timeout=PATIENCE)
        shutil.rmtree(self._profile, ignore_errors=True)


_running: list[Browser] = []


def _browser() -> Browser:
    """The browser of this process, started when it is first asked for."""
    if not _running:
        found = next((path for path in map(shutil.which, NAMES) if path), None)
        if found is None:
            pytest.skip("no browser is installed")
        _running.append(Browser(found))
    return _running[0]


def leave() -> None:
    """End the browser if it was started."""
    while _running:
        _running.pop().close()


class _Page:
    """A page, as it is when `BUDGET` of its own time is over."""

    def __init__(self, text: str, folder: Path, state: str, size: tuple[int, int]) -> None:
        browser = _browser()
        path = folder / "page.html"
        path.write_text(text, encoding="utf-8")
        self._browser = browser
        browser.forget()
        # a context of its own: nothing of other pages is there
        self._context = browser.ask("Target.createBrowserContext")["browserContextId"]
        where = {"browserContextId": self._context, "width": size[0], "height": size[1]}
        self._target = browser.ask("Target.createTarget", url="about:blank", **where)["targetId"]
        self._session = browser.ask("Target.attachToTarget", targetId=self._target, flatten=True)["sessionId"]
        given = {"width": size[0], "height": size[1], "deviceScaleFactor": 1, "mobile": False}
        self.ask("Emulation.setDeviceMetricsOverride", **given)
        self.ask("Page.enable")
        self.ask("Page.navigate", url=path.as_uri() + (f"#{state}" if state else ""))
        browser.until("Page.loadEventFired", self._session)
        policy = {"policy": "pauseIfNetworkFetchesPending", "budget": BUDGET}
        self.ask("Emulation.setVirtualTimePolicy", **policy)
        browser.until("Emulation.virtualTimeBudgetExpired", self._session)

    def ask(self, method: str, **parameters: Any) -> dict[str, Any]:
        """The result of a command to the page."""
        return self._browser.ask(method, self._session, **parameters)

    def close(self) -> None:
        """Leave it."""
        self._browser.ask("Target.closeTarget", targetId=self._target)
        self._browser.ask("Target.disposeBrowserContext", browserContextId=self._context)


def used(page: str, folder: Path, script: str, state: str = "") -> dict[str, Any]:
    """The data attributes of the page's root after `script` has run in the loaded page; JSON in `probe` is read."""
    seen = _Page(page.replace("</body>", f"<script>{script}</script></body>"), folder, state, SIZE)
    attributes = seen.ask("Runtime.evaluate", expression=READ, returnByValue=True)["result"]["value"]
    seen.close()
    found = {key.removeprefix("data-"): value for key, value in attributes.items() if key.startswith("data-")}
    if "probe" in found:
        found["probe"] = json.loads(found["probe"])
    return found


def screenshot(page: str, folder: Path, state: str = "", size: tuple[int, int] = SIZE) -> Image.Image:
    """What the page looks like."""
    seen = _Page(page, folder, state, size)
    picture = base64.b64decode(seen.ask("Page.captureScreenshot", format="png")["data"])
    seen.close()
    with Image.open(io.BytesIO(picture)) as image:
        return image.convert("RGB")
