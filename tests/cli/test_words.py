"""Words on the command line: what was probably meant, in one line; quiet, verbose, completion; a quick answer."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from runtime import ModelError, SchemeError, simulate
from symgen.cli import main
from symgen.cli.table import parser
from symgen.scene import SceneError, SceneRecord

SPRING = '[[loads]]\ntype = "force"\nname = "push"\nmarker = "box.origin"\ncomponents = [1.0, 0.0]\n'


@pytest.mark.parametrize(
    "words, said",
    [
        ("simulat pendulum", "there is no command 'simulat'; did you mean 'simulate'?"),
        ("simulate pendulum --tend 1", "simulate has no option --tend; did you mean '--t-end'?"),
        ("simulate pendulum --t-end 1s", "'1s' is not a number"),
        ("simulate pendulm", "did you mean 'pendulum'?"),
        ("advise pendulum --start quasi_statc", "--start takes no 'quasi_statc'; did you mean 'quasi_static'?"),
        ("simulate crane.py", "is a Python program, which is not run here; in it write scene.to_toml('NAME.toml')"),
        ("list further", "'further' is one word too many"),
    ],
)
def test_a_slip_is_answered_in_one_line_with_what_was_meant(capsys, words: str, said: str) -> None:
    assert main(words.split()) == 2
    captured = capsys.readouterr()
    assert said in captured.err and captured.err.count("\n") == 1 and captured.out == ""


def test_quiet_and_verbose(capsys) -> None:
    assert main(["simulate", "pendulum", "--t-end", "0.01", "-q"]) == 0
    captured = capsys.readouterr()
    assert captured.out == "" and captured.err == ""
    assert main(["simulate", "pendulum", "--t-end", "0.01", "-v"]) == 0
    assert "full evaluations: " in capsys.readouterr().out


def test_the_package_runs_as_a_module() -> None:
    done = subprocess.run([sys.executable, "-m", "symgen", "--version"], capture_output=True, text=True)
    assert done.returncode == 0 and done.stdout.startswith("symgen ")


def test_help_brings_in_nothing_heavy() -> None:
    program = (
        "import sys; from symgen.cli.table import parser; parser().format_help(); "
        "print(sorted({'numpy', 'casadi', 'sympy', 'matplotlib', 'scipy', 'pydantic'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.stdout.strip() == "[]", done.stderr


@pytest.mark.long
def test_advice_prints_a_command_that_works_for_what_was_given(capsys, tmp_path: Path, monkeypatch) -> None:
    from symgen.scenes import SCENES

    monkeypatch.chdir(tmp_path)
    (tmp_path / "two springs.toml").write_text(SCENES["two_oscillators"]().to_toml())
    assert main(["advise", "two springs.toml", "--t-end", "2", "--set", "c=0.1"]) == 0
    import shlex

    words = shlex.split(capsys.readouterr().out.rpartition("run it with: ")[2])
    assert words[:3] == ["symgen", "simulate", "two springs.toml"]
    assert main([*words[1:], "--quiet"]) == 0


def test_a_number_with_its_unit_is_told_from_an_expression() -> None:
    text = 'name = "a"\n[[bodies]]\ntype = "rigid"\nname = "box"\nmass = "3.0 kg"\ninertia = 1.0\nfree = true\n'
    with pytest.raises(SceneError, match="all are in SI units .* here 3.0"):
        SceneRecord.from_toml_text(text)
    with pytest.raises(SceneError, match="line 5.*'mass = 3.0 kg'; write the number alone.* here 3.0"):
        SceneRecord.from_toml_text(text.replace('"3.0 kg"', "3.0 kg"))


def test_an_error_of_the_toml_shows_its_line() -> None:
    with pytest.raises(SceneError, match="line 2.*'mass = = 3'"):
        SceneRecord.from_toml_text('name = "a"\nmass = = 3\n')


def test_a_parameter_that_is_zero_in_the_scene_is_explained(built_in) -> None:
    with pytest.raises(ModelError, match=r"declare it in \[parameters\] with default 0"):
        simulate(built_in("pendulum"), parameters={"hinge.damping": 0.1})


def test_a_missing_ratio_is_explained_without_the_words_of_the_code(built_in) -> None:
    with pytest.raises(
        SchemeError, match="m must hold one number, how many sub-steps exponential takes in one step dt"
    ):
        simulate(built_in("pendulum"), scheme="exponential", m=[], t_end=0.01)


def test_completion_knows_every_command(capsys) -> None:
    pytest.importorskip("shtab")
    for shell in ("bash", "zsh"):
        assert main(["completion", shell]) == 0
        script = capsys.readouterr().out
        commands = next(action.choices for action in parser()._actions if action.dest == "command")
        assert all(command in script for command in commands) and "--t-end" in script
