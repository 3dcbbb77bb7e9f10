"""Running an example as a user does."""

from __future__ import annotations

import runpy
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
SMALLER: dict[str, dict[str, Any]] = {"optimise_torque": {"intervals": 20}, "parameter_study": {"t_end": 0.05}}


@pytest.fixture
def said(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Any:
    """What an example prints as it draws its picture; it leaves nothing else in the folder where it runs."""

    def run(name: str, **settings: Any) -> str:
        (tmp_path / "empty").mkdir()
        monkeypatch.chdir(tmp_path / "empty")
        picture = tmp_path / f"{name}.png"
        runpy.run_path(str(EXAMPLES / f"{name}.py"), run_name=name)["main"](
            picture, **SMALLER.get(name, {}), **settings
        )
        assert not list(Path.cwd().iterdir()), "an example leaves files only where it is told to"
        with Image.open(picture) as image:
            assert image.width > 600 and len(set(image.convert("L").resize((60, 40)).tobytes())) > 10
        return capsys.readouterr().out

    return run
