"""The command line as a table: each command with the function that it calls and the options that it takes.

Help, completion, suggestions and the reading of words come from this table; what a command does is said by its
function. The functions import what they need when they are called, so that `symgen --help` answers at once.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from dataclasses import dataclass, replace
from inspect import getdoc
from typing import Any

from symgen.cli import demo, exchange, pictures, runs, scenes, states, studies, words
from symgen.cli.outcome import EXIT_CODES, Outcome
from symgen.cli.words import Gather, Parser, UsageError, assignment, names, number, positive

FROM_THE_SCENE = "What is not given comes from the scene's [simulation]."


@dataclass(frozen=True)
class Option:
    """An option or a positional word: its names, and what argparse is told of it."""

    names: list[str]
    settings: dict[str, Any]

    def but(self, **settings: Any) -> Option:
        """The same with other settings."""
        return replace(self, settings={**self.settings, **settings})


@dataclass(frozen=True)
class Group:
    """Options that the help lists under a title."""

    title: str
    text: str | None
    options: tuple[Option, ...]


Options = tuple[Option | Group, ...]


def opt(row: str, help: str, read: Callable[[str], Any] | None = None, **more: Any) -> Option:
    """An option such as `--dt SECONDS`: names, and what stands for the value in the help (none: a switch).

    read: from the value's word to the value. more: as for argparse.
    """
    given = row.split()
    names = [word for word in given if word.startswith("-")] or given[:1]
    value = given[len(names) :]
    settings: dict[str, Any] = {"metavar": value[0]} if value else {"action": "store_true"} if not more else {}
    settings |= {"type": read} if read else {}
    return Option(names, {"help": help, **settings, **more})


def pairs(flag: str, dest: str, help: str, read: Callable[[str], Any] = assignment) -> Option:
    """An option NAME=VALUE that may be repeated; all of it becomes a dict."""
    return opt(f"{flag} NAME=VALUE", f"{help}; may be repeated", read, action=Gather, dest=dest, default={})


SCENE_WORD = opt("scene SCENE", "built-in name, .toml file, or generated folder")
WITH = pairs("--with", "made_with", "what a built-in scene is made with, such as links=50 of chain")
SCENE = (SCENE_WORD, WITH)
SCENE_OR_NONE = (SCENE_WORD.but(nargs="?"), WITH)
RESULTS_OR_SCENE = (SCENE_WORD.but(metavar="RESULTS|SCENE", help="results folder, or what names a scene"), WITH)
DT = opt("--dt SECONDS", "the step (dt_L, of the slowest group)", number)
M = opt("--m 10,4", "ratio of each next group's step, slow to fast", words.ratios)
SCHEME = opt("--scheme NAME", "time stepping scheme, such as exponential or single_rate (default: the scene's)")
SCHEME_OPTION = pairs("--option", "options", "a reading or tolerance of it, such as common_update=direct", words.option)
SET = pairs("--set", "parameters", "change a parameter")
MOTION = Group(
    "motion",
    FROM_THE_SCENE,
    (
        opt("--t-end SECONDS", "end of the motion", number),
        SET,
        pairs("--initial", "initial", "change a starting coordinate, or a rate by NAME_dot"),
        opt(
            "--start",
            "elastic coordinates as given or in (stable, or any) equilibrium with the rigid motion; all at rest",
            choices=("given", "quasi_static", "quasi_static_unstable", "equilibrium"),
        ),
    ),
)
ENGINE = opt(
    "--engine",
    "compiled (by LLVM; auto means this where it is there), interpreted (by CasADi), compiled-library (equal to it "
    "bit for bit), c (by the machine's C compiler)",
    choices=("auto", "compiled", "interpreted", "compiled-library"),
    default="auto",
)
SAMPLING = (
    opt("--seen-every SECONDS", "time from sample to sample", number),
    opt("--samples COUNT", "how many samples there are besides the first, instead", int),
)
RUN = (
    MOTION,
    Group(
        "run",
        FROM_THE_SCENE,
        (
            DT,
            M,
            opt(
                "--scheme NAME",
                "such as exponential or single_rate; auto: a method and steps that follow from --tolerance",
            ),
            opt("--tolerance ERROR", "relative error instead of a step (with auto, the default then: 1e-3)", positive),
            SCHEME_OPTION,
            opt("--force", "run although the step is above its limit at the start"),
            *SAMPLING,
            ENGINE,
        ),
    ),
)
MODELLING = opt(
    "--convergence",
    "the error of the model on the page: by half the pieces and elements of beams, by all usual knobs (one to seven "
    "times the run each), or not at all (default: %(default)s)",
    choices=("half", "all", "off"),
    default="half",
)
LONG_RUN = Group(
    "long runs",
    None,
    (
        opt("--checkpoint-every STEPS", "steps between two checkpoints (default: one a minute)", int),
        opt("--stream DIR", "folder that takes the samples instead of memory"),
    ),
)
ACCURACY = (
    opt("--tolerance ERROR", "RMS error over amplitude (default: %(default)s)", positive, default=1e-3),
    opt("--graded NAMES", "coordinates that are graded, by commas (default: all independent ones)", names),
)
STATE = Group(
    "state",
    "The equilibrium that is reached from the scene's initial state.",
    (
        pairs("--held", "held", "clamp a coordinate at a value"),
        pairs("--rate", "rates", "let a coordinate go on at a constant rate, such as hub.omega=6"),
        SET,
        pairs("--initial", "initial", "change a starting coordinate"),
        opt("--time SECONDS", "when loads and motions are taken (default: 0)", number, default=0.0),
    ),
)
LOCKED = opt("--locked NAMES", "coordinates that stay as they are", names)
POINTS = opt("--points COUNT", "values to look at (default: %(default)s)", int)
RESULTS = opt("--out DIR", "folder for the results (default: none are kept)")
EVERY_COMMAND = (
    opt("--json", "write one JSON object to standard output, nothing else"),
    opt("-q --quiet", "write nothing but errors"),
    opt("-v --verbose", "also write what the run counted and took"),
)


class Version(argparse.Action):
    """Prints the version of the installed package: reading it takes longer than all other words."""

    def __call__(self, parser: argparse.ArgumentParser, *_: Any) -> None:
        from importlib.metadata import PackageNotFoundError, version

        try:
            print(f"symgen {version('symgen')}")
        except PackageNotFoundError:
            print("symgen (not installed)")
        parser.exit()


def completion(arguments: argparse.Namespace) -> Outcome:
    """Write a script that completes commands and options.

    For bash: eval "$(symgen completion bash)"; for zsh the same with zsh. Needs the extra `completion`.
    """
    try:
        import shtab
    except ImportError as error:
        raise UsageError("shtab is not installed; install it with: pip install 'symgen[completion]'") from error
    script = shtab.complete(parser(), arguments.shell)
    return Outcome({"shell": arguments.shell, "script": script}, [script])


COMMANDS: dict[str, tuple[Callable[[argparse.Namespace], Outcome], Options]] = {
    "new": (
        scenes.new,
        (
            opt("name NAME", "name of the scene"),
            opt("--out FILE", "the file to write (default: NAME.toml)"),
            opt("--force", "replace a file that is already there"),
        ),
    ),
    "import": (
        exchange.import_robot,
        (
            opt("file URDF", "the robot"),
            opt("--base HOW", "the root link stands or floats", choices=("fixed", "free"), default="fixed"),
            pairs(
                "--flexible", "flexible", "the beam or finite-element body of a scene file for a link", words.file_of
            ),
            opt(
                "--inertia HOW",
                "as_given takes bodies that cannot be",
                choices=("possible", "as_given"),
                default="possible",
            ),
            opt("--kinematics", "joints follow inputs q_JOINT; no link needs inertia"),
            opt("--density KG_M3", "links that have no inertia get that of their shapes, of this density", number),
            opt("--no-damping", "leave out damping of joints"),
            opt("--no-friction", "leave out friction of joints"),
            opt("--no-limits", "leave out ends of joints"),
            opt("--no-effort", "leave out the limits of motors"),
            opt("--no-meshes", "leave out mesh files"),
            opt("--package DIR", "a further folder whose meshes may be read; may be repeated", action="append"),
            opt("--out FILE", "the scene file to write (default: NAME.toml)"),
            opt("--force", "replace a file that is already there"),
        ),
    ),
    "list": (scenes.listing, ()),
    "show": (scenes.show, (*SCENE, opt("--toml", "write the scene as TOML instead"))),
    "generate": (
        scenes.generate,
        (
            *SCENE_OR_NONE,
            opt("--all", "every built-in scene (with --out: DIR/SCENE)"),
            opt("--out DIR", "folder to write to"),
            opt("--check", "write nothing; exit 1 with a unified diff if the code there is not current"),
            opt("--complete", "all functions of a long tree, also those that grow with the square of its length"),
            opt("--functions A,B", "only these functions (large models can go without some)"),
        ),
    ),
    "simulate": (
        runs.simulate,
        (
            *SCENE,
            RESULTS,
            opt(
                "--plots",
                "page.html, motion.png, deformation.png, forces.png, energy.png in --out (unless --no-plots is given)",
                action=argparse.BooleanOptionalAction,
                default=None,
            ),
            *RUN,
            MODELLING,
            opt("--inputs FILE.csv", "samples of inputs: columns t,name,..., held in between"),
            opt("--checkpoint FILE", "file that `symgen resume` goes on from"),
            LONG_RUN,
            opt("--outputs NAMES", "keep only these coordinates, rates, measures or energies, by commas", names),
        ),
    ),
    "resume": (
        runs.resume,
        (
            opt("file FILE", "what simulate --checkpoint wrote"),
            SCENE_WORD.but(nargs="?", help="scene or folder of the run (default: the scene that the checkpoint holds)"),
            RESULTS,
            ENGINE,
            LONG_RUN,
        ),
    ),
    "sweep": (
        studies.sweep,
        (
            *SCENE,
            opt(
                "--over NAME=lin:FROM:TO:COUNT",
                "parameter, coordinate or rate (NAME_dot) and values: lin:, log:, or a list as 1,2,5; may be repeated",
                words.over,
                action="append",
                required=True,
            ),
            opt("--outputs NAMES", "what is kept of each case", names, required=True),
            opt("--reduce HOW", "max, min, peak, mean, rms, end of each output (default: peak,end)", names),
            *SAMPLING,
            opt("--out FILE", "study.csv; the picture is study.png"),
            opt("--workers COUNT", "threads (default: one a processor)", int),
            opt("--processes COUNT", "work in so many processes of this machine; one that dies is replaced", int),
            opt("--folder DIR", "keeps what is done: the same command goes on from there"),
            MOTION,
            Group("run", FROM_THE_SCENE, (DT, M, SCHEME, SCHEME_OPTION)),
        ),
    ),
    "export": (
        exchange.export,
        (
            opt("what WHAT", "what is handed on: %(choices)s", choices=("results", "c", "fmu")),
            opt("source SOURCE", "results: folder that `symgen simulate --out` left; else a scene or generated folder"),
            opt("--out PATH", "results: a .csv, .mat or .parquet; fmu: a .fmu; c: a folder", required=True),
            WITH,
            Group(
                "of c and fmu",
                FROM_THE_SCENE,
                (DT, M, SCHEME, SCHEME_OPTION, SET, opt("--name NAME", "in the code (default: the scene's)")),
            ),
            opt("--fmi VERSION", "fmu: of the standard (default: %(default)s)", choices=("2", "3"), default="2"),
            opt(
                "--platform A,B",
                "fmu: binaries for these of linux64, win64, darwin64, aarch64, aarch64-darwin (default: this machine)",
                names,
                dest="platforms",
            ),
        ),
    ),
    "view": (
        pictures.view,
        (
            *RESULTS_OR_SCENE,
            opt("--out FILE", "the .html to write (default: RESULTS/view.html or SCENE.html)"),
            opt("--beside RESULTS", "a second run, shown pale in the same page"),
            opt("--open", "open it in the browser"),
            *RUN,
        ),
    ),
    "plot": (
        pictures.plot,
        (
            *RESULTS_OR_SCENE,
            opt("--names NAMES", "coordinates, rates or measures, by commas", names),
            opt("--frequencies", "the frequencies along the motion instead"),
            opt("--sections BEAM", "section forces along this beam instead"),
            opt("--stresses BODY", "stresses at the gauges of this body instead"),
            opt("--out DIR", "folder for the pictures (default: RESULTS, or out/SCENE)"),
            *RUN,
        ),
    ),
    "compare": (
        pictures.compare,
        (
            opt("first FIRST", "results folder"),
            opt("second SECOND", "results folder"),
            opt("--names NAMES", "default: the independent coordinates of both", names),
            opt("--out FILE", "the picture (default: FIRST/difference.png)"),
        ),
    ),
    "animate": (
        pictures.animate,
        (
            *RESULTS_OR_SCENE,
            opt("--out FILE", "the .gif or .mp4 to write (default: RESULTS/motion.gif or SCENE.gif)"),
            opt("--frames COUNT", "number of frames (default: %(default)s)", int, default=60),
            opt("--fps RATE", "frames a second (default: %(default)s)", number, default=20.0),
            opt("--exaggeration FACTOR", "of the deformation (default: the largest becomes 5 %% of the size)", number),
            *RUN,
        ),
    ),
    "equilibrium": (
        states.equilibrium,
        (*SCENE, STATE, opt("--moving", "with the rates and accelerations of prescribed motions, not held")),
    ),
    "modes": (states.modes, (*SCENE, STATE, LOCKED, opt("--out DIR", "folder for the motion of each mode"))),
    "campbell": (
        states.campbell,
        (
            *SCENE,
            opt("--over NAME=FROM:TO", "a parameter, or a rate such as hub.omega=0:12", words.span, required=True),
            POINTS.but(default=25),
            STATE,
            LOCKED,
            opt("--out DIR", "folder for campbell.csv and campbell.png"),
        ),
    ),
    "response": (
        states.response,
        (
            *SCENE,
            opt("--input NAMES", "inputs, parameters or coordinates (a force on them)", names, required=True),
            opt("--output NAMES", "measures, coordinates or rates", names),
            opt("--frequencies FROM:TO", "rad/s, spaced logarithmically", words.frequencies, required=True),
            POINTS.but(default=200),
            STATE,
            LOCKED,
            opt("--out DIR", "folder for response.csv"),
        ),
    ),
    "stability": (
        studies.stability,
        (
            *SCENE,
            SCHEME,
            M.but(action="append", help="ratios to look at; may be repeated"),
            opt("--dt-from SECONDS", "smallest step of the fastest group", number),
            opt("--dt-to SECONDS", "largest step of the fastest group", number),
            POINTS.but(default=20),
            opt("--states COUNT", "states along the motion (default: %(default)s)", int, default=16),
            SCHEME_OPTION,
            opt("--out DIR", "folder for stability.csv and stability.png"),
            MOTION,
        ),
    ),
    "periodic": (
        studies.periodic,
        (
            *SCENE,
            opt("--period SECONDS", "the period, or `free` where nothing depends on time", words.period),
            opt("--speed NAME", "the parameter that is the speed [rad/s]: the period is that of its --turns"),
            opt("--turns COUNT", "turns a period (default: %(default)s)", positive, default=1.0),
            opt("--over NAME=FROM:TO", "follow the motion over a parameter, through folds", words.span),
            opt("--resume DIR", "with --over: where points are kept; the same words go on there after the last one"),
            opt("--flips COUNT", "with --over: doublings of the period that are followed", int, default=0),
            opt("--output NAMES", "whose largest values are written and drawn (default: the first coordinate)", names),
            opt("--settle PERIODS", "simulate so many first", int),
            opt("--tolerance ERROR", "relative error (default: %(default)s)", positive, default=1e-6),
            opt("--parts COUNT", "parts that a period is cut into, for very unstable motions", int, default=1),
            SCHEME,
            SET,
            pairs("--initial", "initial", "where the search begins"),
            opt("--out DIR", "folder for the motion of a period, or for branch.csv, branch.png and branch.html"),
        ),
    ),
    "converge": (
        studies.converge,
        (
            *SCENE,
            opt("--outputs NAMES", "measures and coordinates, by commas (default: all measures)", names),
            opt("--reduce HOW", "motion (the default), max, min, peak, mean, rms, end of each output", names),
            opt("--equilibrium", "of the equilibrium instead of the motion"),
            opt("--knobs NAMES", "such as modes,rod.pieces (default: modes, elements, pieces, stiffening)", names),
            opt("--levels COUNT", "how often each is turned; 2 tells the order (default: %(default)s)", int, default=1),
            pairs(
                "--coarser", "coarser", "the scene with half the size, by its knob: rod.mesh=coarse.toml", words.file_of
            ),
            pairs("--finer", "finer", "the scene with double the size, by its knob", words.file_of),
            opt("--tolerance ERROR", "of the steps of all runs (default: %(default)s)", positive, default=1e-5),
            opt("--samples COUNT", "times at which motions are compared (default: %(default)s)", int, default=400),
            MOTION,
            opt("--out FILE", "a table, convergence.csv"),
        ),
    ),
    "advise": (studies.advise, (*SCENE, *ACCURACY, MOTION, opt("--out FILE", "a picture: error against operations"))),
    "report": (
        studies.report,
        (*SCENE, *ACCURACY, MOTION, opt("--out DIR", "folder for methods.md, methods.csv and error_time.png")),
    ),
    "demo": (
        demo.demo,
        (
            SCENE_WORD.but(
                nargs="?",
                default="slider-crank",
                help="slider-crank (flexible, the default), plate, any other built-in scene, or a .toml file",
            ),
            WITH,
            opt("--out DIR", "folder for everything (default: out/SCENE)"),
            *RUN,
            MODELLING.but(default="all"),
        ),
    ),
    "completion": (completion, (opt("shell", "the shell that it is for", choices=("bash", "zsh")),)),
    "cache": (runs.cache, (opt("--clear", "remove all of it"),)),
}


def parser() -> Parser:
    """What reads the words of a command line."""
    root = Parser(
        prog="symgen",
        description="Symbolic code generation and multirate time stepping for flexible multibody dynamics.",
        epilog="Exit codes: " + ", ".join(f"{code} {meaning}" for code, meaning in EXIT_CODES.items()) + ".",
    )
    root.add_argument("--version", action=Version, nargs=0, help="show the version and exit")
    commands = root.add_subparsers(dest="command", required=True, metavar="COMMAND")
    for name, (function, options) in COMMANDS.items():
        said = " ".join((getdoc(function) or "").split())
        command = commands.add_parser(name, help=said.partition(". ")[0].rstrip(".") + ".", description=said)
        _declare(command, (*EVERY_COMMAND, *options))
    return root


def _declare(place: Any, options: Options) -> None:
    for one in options:
        if isinstance(one, Group):
            _declare(place.add_argument_group(one.title, one.text), one.options)
        else:
            place.add_argument(*one.names, **one.settings)
