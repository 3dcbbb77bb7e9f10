"""The command line: every command, exit codes, JSON, and mistakes that must never end in a traceback."""

from __future__ import annotations

import io
import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from runtime import Solution
from symgen.cli import main
from symgen.cli.outcome import Progress

DEMO_FILES = (
    "report.json",
    "motion.gif",
    "motion.png",
    "forces.png",
    "view.html",
    "difference.png",
    "energy.png",
)


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    """A place with a new scene file, and its generated code in ./model_of_it."""
    place = tmp_path_factory.mktemp("cli")
    assert main(["new", "my-rod", "--out", str(place / "my_rod.toml")]) == 0
    assert main(["generate", str(place / "my_rod.toml"), "--out", str(place / "code")]) == 0
    return place


def run(capsys, *words: object) -> tuple[int, dict]:
    """(exit code, the JSON object on standard output)."""
    capsys.readouterr()
    code = main([*map(str, words), "--json"])
    captured = capsys.readouterr()
    data = json.loads(captured.out)
    assert data["exit_code"] == code and captured.err == ""
    return code, data


def test_help_is_fast_and_imports_nothing_heavy() -> None:
    program = (
        "import sys; from symgen.cli import main\n"
        "try: main(['--help'])\n"
        "except SystemExit as end: assert not end.code\n"
        "heavy = {'sympy', 'matplotlib', 'casadi', 'numpy', 'pydantic'} & set(sys.modules)\n"
        "sys.exit(', '.join(heavy) if heavy else 0)"
    )
    result = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
    assert "simulate" in result.stdout


def test_new_writes_a_scene_and_keeps_what_is_there(capsys, folder, tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    code, data = run(capsys, "new", "swing")
    assert code == 0 and Path(data["file"]).read_text().count("#") > 20
    assert run(capsys, "new", "swing")[0] == 2
    assert run(capsys, "new", "swing", "--force")[0] == 0
    assert run(capsys, "new", "no good name")[0] == 2
    assert run(capsys, "new", "swing", "--out", "swing.txt")[0] == 2


def test_list_and_show(capsys, folder) -> None:
    code, data = run(capsys, "list")
    names = [entry["name"] for entry in data["scenes"]]
    assert code == 0 and "flexible_slider_crank" in names and all(entry["description"] for entry in data["scenes"])
    code, data = run(capsys, "show", "double-pendulum")
    assert code == 0 and data["scene"] == "double_pendulum" and len(data["independent"]) == 2
    code, data = run(capsys, "show", folder / "my_rod.toml")
    assert data["groups"]["fast"] == ["rod.q1", "rod.q2"]
    code, data = run(capsys, "show", "chain", "--with", "links=3")
    assert code == 0 and len(data["independent"]) == 3
    assert main(["show", str(folder / "my_rod.toml"), "--toml"]) == 0
    assert 'name = "my_rod"' in capsys.readouterr().out


def test_check_passes_fails_with_a_diff_and_names_the_mending_command(capsys, folder, tmp_path) -> None:
    target = tmp_path / "code"
    words = ("generate", folder / "my_rod.toml", "--out", target)
    assert run(capsys, *words)[0] == 0
    assert run(capsys, *words, "--check")[0] == 0
    text = (target / "model.py").read_text()
    (target / "model.py").write_text(text.replace("def energy", "def energie"))
    code, data = run(capsys, *words, "--check")
    assert code == 1 and "-def energie" in data["checked"][0]["diff"] and "+def energy" in data["checked"][0]["diff"]
    assert main(list(map(str, (*words, "--check")))) == 1
    assert f"mend with: {data['mend']}" in capsys.readouterr().out
    assert run(capsys, "simulate", target)[0] == 2  # edited code is not run
    assert main(data["mend"].split()[1:]) == 0 and (target / "model.py").read_text() == text
    assert run(capsys, "generate", target, "--check")[0] == 0  # a generated folder names its own scene


@pytest.mark.long
def test_a_console_that_lacks_a_sign_shows_its_escape(tmp_path: Path) -> None:
    """Code page 1252, as of many Windows consoles, has no mu of Greek and no Chinese sign."""
    title = "W\u00e4lzlager \u03bc \u6f22"
    text = (
        f'name = "bearing"\ntitle = "{title}"\n'
        '[[bodies]]\ntype = "rigid"\nname = "arm"\nmass = 1.0\ninertia = 1.0\n'
        '[[joints]]\ntype = "revolute"\nname = "pin"\nmarker_a = "ground.origin"\nmarker_b = "arm.origin"\n'
    )
    (tmp_path / "bearing.toml").write_text(text, encoding="utf-8")
    run_it = [sys.executable, "-m", "symgen", "simulate", "bearing.toml", "--t-end", "0.01", "-q", "--out", "run"]
    environment = {**os.environ, "PYTHONIOENCODING": "cp1252"}
    for words in (run_it, [sys.executable, "-m", "symgen", "show", "bearing.toml"]):
        done = subprocess.run(words, cwd=tmp_path, capture_output=True, env=environment)
        assert done.returncode == 0, done.stderr
    assert title.encode("cp1252", "backslashreplace") in done.stdout
    assert title in (tmp_path / "run" / "page.html").read_text(encoding="utf-8")


def test_generate_only_some_functions(capsys, folder, tmp_path) -> None:
    words = ("generate", folder / "my_rod.toml", "--out", tmp_path, "--functions", "condensed,energy")
    assert run(capsys, *words)[0] == 0
    functions = json.loads((tmp_path / "manifest.json").read_text())["functions"]
    assert [entry["name"] for entry in functions] == ["constants", "condensed", "energy"]
    assert run(capsys, *words, "--check")[0] == 0


def test_simulate_and_animate(capsys, folder, tmp_path) -> None:
    changes = ("--set", "torque=0.2", "--initial", "rod.theta=-0.5", "--seen-every", 1e-3)
    code, data = run(
        capsys,
        "simulate",
        folder / "code",
        "--t-end",
        0.1,
        "--engine",
        "interpreted",
        *changes,
        "--out",
        tmp_path / "run",
    )
    assert code == 0 and data["report"]["status"]["ok"]
    assert data["report"]["parameters"]["torque"]["value"] == 0.2
    solution = Solution.load(tmp_path / "run" / "solution.npz")
    assert solution["rod.theta"][0] == pytest.approx(-0.5) and len(solution.t) == 101
    assert json.loads((tmp_path / "run" / "report.json").read_text()) == data["report"]
    assert (tmp_path / "run" / "energy.png").is_file()
    assert ">completed<" in (tmp_path / "run" / "page.html").read_text(encoding="utf-8")
    code, data = run(capsys, "animate", tmp_path / "run", "--frames", 5, "--exaggeration", 2)
    assert code == 0 and Path(data["file"]) == tmp_path / "run" / "motion.gif" and data["exaggeration"] == 2.0
    assert run(capsys, "animate", folder / "code", "--t-end", 0.02, "--frames", 3, "--out", tmp_path / "a.gif")[0] == 0


def test_a_toml_scene_is_simulated_without_leaving_code(capsys, folder, tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    code, data = run(capsys, "simulate", folder / "my_rod.toml", "--t-end", 0.01, "--engine", "interpreted")
    assert code == 0 and data["report"]["time"]["end"] == pytest.approx(0.01)
    assert list(tmp_path.iterdir()) == []


def test_the_last_line_tells_orientations_by_euler_parameters(capsys) -> None:
    """Their turns are coordinates of one step, which no user knows of."""
    assert main(["simulate", "tumbling_body", "--t-end", "0.1"]) == 0
    last = capsys.readouterr().out.splitlines()[-1]
    assert "body.e0 = " in last and "turn" not in last


def test_no_energy_balance_is_claimed_where_the_samples_were_not_kept(capsys, folder) -> None:
    words = ["simulate", str(folder / "code"), "--t-end", "0.1", "--engine", "interpreted"]
    assert main(words) == 0
    assert "largest energy balance error" in capsys.readouterr().out
    assert main([*words, "--outputs", "kinetic"]) == 0
    printed = capsys.readouterr().out
    assert "no energy balance: only the first and the last state were kept" in printed
    assert "balance is off" not in printed


def test_a_run_that_fails_exits_with_one_and_keeps_its_report(capsys, folder, tmp_path) -> None:
    code, data = run(
        capsys,
        "simulate",
        folder / "code",
        "--dt",
        0.5,
        "--t-end",
        500,
        "--engine",
        "interpreted",
        "--out",
        tmp_path,
        "--no-plots",
    )
    assert code == 1 and not data["report"]["status"]["ok"] and data["report"]["status"]["advice"]
    assert main(["simulate", str(folder / "code"), "--dt", "0.5", "--t-end", "500", "--engine", "interpreted"]) == 1
    assert data["report"]["status"]["name"] in capsys.readouterr().out


@pytest.mark.long
def test_demo_leaves_everything(capsys, tmp_path, monkeypatch) -> None:
    page = (Path(__file__).parents[2] / "docs" / "guide" / "cli.md").read_text()
    monkeypatch.chdir(tmp_path)
    (words,) = re.findall(r"^symgen (demo .*)$", page, re.MULTILINE)
    code, data = run(capsys, *words.split())
    assert code == 0 and data["report"]["model"]["name"] == "flexible_slider_crank"
    assert all((tmp_path / "demo" / name).stat().st_size > 500 for name in DEMO_FILES)
    assert (tmp_path / "demo" / "model" / "model.py").is_file()


MISTAKES = [
    [],
    ["nonsense"],
    ["show"],
    ["show", "no_such_scene"],
    ["show", "missing.toml"],
    ["show", "."],
    ["show", "chain", "--with", "links=2.5"],
    ["show", "chain", "--with", "lynx=3"],
    ["show", "chain", "--with", "x"],
    ["generate"],
    ["generate", "pendulum", "--all"],
    ["generate", "pendulum", "--functions", "nothing"],
    ["generate", "pendulum", "--out", "/proc/nowhere/x"],
    ["generate", "{code}", "--with", "a=1"],
    ["simulate", "{code}", "--dt", "0"],
    ["simulate", "{code}", "--dt", "nan"],
    ["simulate", "{code}", "--dt", "fast"],
    ["simulate", "{code}", "--t-end", "-1"],
    ["simulate", "{code}", "--m", "2.5"],
    ["simulate", "{code}", "--m", "1,2,3", "--scheme", "printed"],
    ["simulate", "{code}", "--scheme", "euler"],
    ["simulate", "{code}", "--samples", "0"],
    ["simulate", "{code}", "--set", "torque"],
    ["simulate", "{code}", "--set", "torque=inf"],
    ["simulate", "{code}", "--set", "mass=1"],
    ["simulate", "{code}", "--initial", "rod.q9=1"],
    ["simulate", "{code}", "--engine", "warp"],
    ["simulate", "{code}", "--plots"],
    ["simulate", "{place}"],
    ["simulate", "{code}", "--t-end", "0.001", "--out", "/proc/nowhere"],
    ["animate", "{code}", "--t-end", "0.001", "--out", "a.avi"],
    ["animate", "{code}", "--t-end", "0.001", "--frames", "0"],
    ["demo", "no_such_scene"],
    ["new", "class-9", "--out", "/proc/nowhere/a.toml"],
]


@pytest.mark.parametrize("words", MISTAKES, ids=lambda words: " ".join(words) or "nothing")
def test_a_mistake_is_a_message_and_exit_code_two(words, capsys, folder, tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    words = [word.format(code=folder / "code", place=folder) for word in words]
    code, data = run(capsys, *words)
    assert code == 2 and len(data["error"]["message"]) > 10
    assert main(words) == 2
    captured = capsys.readouterr()
    assert captured.out == "" and captured.err.startswith("symgen: ") and "Traceback" not in captured.err


def test_interrupt_exits_with_130(capsys, folder, monkeypatch) -> None:
    def interrupt(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("symgen.cli.runs.run_model", interrupt)
    assert run(capsys, "simulate", folder / "code")[0] == 130


def test_progress_writes_on_a_terminal_only() -> None:
    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    for stream, expected in ((io.StringIO(), False), (Terminal(), True)):
        with Progress("run", stream) as progress:
            progress(0.5, 1.0)
            progress.note("drawing")
        assert bool(stream.getvalue()) is expected
