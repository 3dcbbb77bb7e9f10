"""Each bad scene is a good one with one edit, and names its item, its problem and a remedy."""

from __future__ import annotations

import copy
import tomllib
from pathlib import Path
from typing import Any

import pytest

from symgen.scene import SceneError, SceneRecord

GOOD = {path.stem: tomllib.loads(path.read_text()) for path in (Path(__file__).parent / "good").glob("*.toml")}
DELETE = object()
CRANK = {"type": "rigid", "name": "twin", "mass": 1, "inertia": 1}
EYE3 = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]


def joint(type: str, a: str, b: str, **fields: Any) -> dict[str, Any]:
    return {"type": type, "name": "extra", "marker_a": a, "marker_b": b, **fields}


def edited(base: str, path: str, value: Any) -> dict[str, Any]:
    """The good scene ``base`` with the entry at ``path`` (slashes; numbers index lists; + appends) replaced."""
    data = copy.deepcopy(GOOD[base])
    *steps, last = path.split("/")
    place: Any = data
    for step in steps:
        place = place[int(step) if isinstance(place, list) else step]
    if last == "+":
        place.append(value)
    elif value is DELETE:
        del place[int(last) if isinstance(place, list) else last]
    else:
        place[int(last) if isinstance(place, list) else last] = value
    return data


# name of the case, base scene, path to edit, new value, item, phrase of the problem
S, M, L = "slider_crank", "modal", "structure"
BAD: list[tuple[str, str, str, Any, str, str]] = [
    # keys and kinds of values
    ("unknown key", S, "bodies/0/mas", 1, "bodies[0] 'crank'.mas", "unknown key"),
    ("unknown section", S, "bodeis", [], "bodeis", "unknown key"),
    ("missing key", S, "bodies/0/mass", DELETE, "bodies[0] 'crank'.mass", "is missing"),
    ("unknown body type", S, "bodies/0/type", "rigd", "bodies[0] 'crank'.type", "unknown type"),
    ("no body type", S, "bodies/0/type", DELETE, "bodies[0] 'crank'.type", "is missing"),
    ("unknown joint type", S, "joints/0/type", "hinge", "joints[0] 'hinge'.type", "unknown type"),
    ("body is a number", S, "bodies/0", 3, "bodies[0]", "not a table"),
    ("bodies is a number", S, "bodies", 3, "bodies", "not a list"),
    ("mass is true", S, "bodies/0/mass", True, "bodies[0] 'crank'.mass", "neither a number nor"),
    ("mass is NaN", S, "bodies/0/mass", float("nan"), "bodies[0] 'crank'.mass", "not a finite number"),
    ("mass is infinite", S, "bodies/0/mass", float("inf"), "bodies[0] 'crank'.mass", "not a finite number"),
    ("mass is huge", S, "bodies/0/mass", 10**400, "bodies[0] 'crank'.mass", "not a finite number"),
    ("mass too long to print", S, "bodies/0/mass", 10**5000, "bodies[0] 'crank'.mass", "not a finite number"),
    ("free is text", S, "bodies/0/free", "yes", "bodies[0] 'crank'.free", "not true or false"),
    ("three components", S, "gravity", [0, 0, 0], "gravity", "has 3 components"),
    ("one component", S, "gravity", [0], "gravity", "has 1 components"),
    ("bad name", S, "bodies/0/name", "2nd body", "bodies[0] '2nd body'.name", "not a valid name"),
    ("reserved word", S, "name", "class", "name", "reserved word"),
    ("bad ends", S, "bodies/1/lateral/ends", "pined-pinned", "bodies[1] 'rod'.lateral.ends", "not a possible"),
    ("modes not whole", S, "bodies/1/lateral/modes", 2.5, "bodies[1] 'rod'.lateral.modes", "not a whole number"),
    ("too many modes", S, "bodies/1/lateral/modes", 10**9, "bodies[1] 'rod'.lateral.modes", "out of range"),
    # names and references
    ("body twice", S, "bodies/2/name", "crank", "bodies[2] 'crank'", "taken by bodies[0]"),
    ("body named ground", S, "bodies/2/name", "ground", "bodies[2] 'ground'", "only the ground"),
    ("own marker", S, "bodies/0/markers/center", {}, "bodies[0] 'crank'.markers.center", "its own marker"),
    ("parameter named t", S, "parameters/t", {"default": 1}, "parameters.t", "already used"),
    ("measure is parameter", S, "measures/0/name", "g", "measures[0] 'g'", "already used"),
    ("unknown body", S, "joints/0/marker_b", "crnk.tip", "joints[0] 'hinge'.marker_b", "no body 'crnk'"),
    ("unknown marker", S, "joints/1/marker_a", "crank.tipp", "joints[1] 'pin'.marker_a", "no marker 'tipp'"),
    ("not a marker", S, "joints/0/marker_b", "crank", "joints[0] 'hinge'.marker_b", "does not name a marker"),
    ("unknown load marker", S, "loads/0/marker", "crank.x", "loads[0] 'motor'.marker", "no marker 'x'"),
    ("key of no measure", S, "measures/0/marker_b", "crank.origin", "measures[0] 'speed'.marker_b", "unknown key"),
    ("unknown measure marker", S, "measures/0/of", "a.b", "measures[0] 'speed'.of", "no body 'a'"),
    ("joint to itself", S, "joints/0/marker_a", "crank.tip", "joints[0] 'hinge'", "to itself"),
    ("joint on the ground", M, "joints/0/marker_b", "ground.rail", "joints[0] 'drive'", "both markers are on"),
    ("load on the ground", M, "loads/0/marker", "ground.rail", "loads[0] 'push'.marker", "no effect"),
    ("spring to itself", S, "loads/1/marker_b", "ground.origin", "loads[1] 'buffer'", "both ends are"),
    # connections
    ("loose body", S, "bodies/+", CRANK, "bodies[3] 'twin'", "joined to nothing"),
    ("loose group", S, "joints", [joint("revolute", "crank.tip", "rod.start")], "bodies[0] 'crank'", "no connection"),
    ("nothing moves", S, "bodies", [], "bodies", "nothing in this scene can move"),
    ("structure and bodies", L, "bodies", [CRANK], "bodies", "structure has no bodies"),
    ("structure with gravity", L, "gravity", [0, -9.81], "gravity", "no effect on a structure"),
    # values
    ("negative mass", S, "bodies/0/mass", -1, "bodies[0] 'crank'.mass", "must be not negative"),
    ("negative by expression", S, "bodies/0/mass", "minus*2", "bodies[0] 'crank'.mass", "must be not negative"),
    ("negative inertia", S, "bodies/0/inertia", -1, "bodies[0] 'crank'.inertia", "must be not negative"),
    ("negative length", S, "bodies/1/length", -0.3, "bodies[1] 'rod'.length", "must be positive"),
    ("division by zero", S, "bodies/1/length", "1/zero", "bodies[1] 'rod'.length", "no finite value"),
    ("root of negative", S, "bodies/1/area", "sqrt(minus)", "bodies[1] 'rod'.area", "no finite value"),
    ("negative damping", S, "joints/0/damping", -1, "joints[0] 'hinge'.damping", "must be not negative"),
    ("marker off the beam", S, "bodies/1/markers/middle/at", 1.5, "bodies[1] 'rod'.markers.middle.at", "outside"),
    ("beam without modes", S, "bodies/1/lateral", DELETE, "bodies[1] 'rod'", "no modes"),
    # matrices
    ("M_ff not square", M, "bodies/1/M_ff/0", [0.5], "bodies[1] 'arm'.M_ff[0]", "has 1 entries"),
    ("K_ff too large", M, "bodies/1/K_ff", EYE3, "bodies[1] 'arm'.K_ff", "has 3 rows instead of 2"),
    ("M_ff not symmetric", M, "bodies/1/M_ff/0/1", 0.2, "bodies[1] 'arm'.M_ff", "not symmetric"),
    ("M_ff indefinite", M, "bodies/1/M_ff", [[1, 2], [2, 1]], "bodies[1] 'arm'.M_ff", "not positive definite"),
    ("M_ff zero", M, "bodies/1/M_ff", [[0, 0], [0, 0]], "bodies[1] 'arm'.M_ff", "not positive definite"),
    ("K_ff negative", M, "bodies/1/K_ff/0/0", -1, "bodies[1] 'arm'.K_ff", "negative eigenvalue"),
    ("phi_cross not skew", M, "bodies/1/phi_cross_phi/0/1", 9, "bodies[1] 'arm'.phi_cross_phi", "skew"),
    ("inconsistent integrals", M, "bodies/1/first_moment", [9, 0], "bodies[1] 'arm'", "mass matrix"),
    ("shape too short", M, "bodies/1/markers/tip/slope", [1], "bodies[1] 'arm'.markers.tip.slope", "instead of 2"),
    ("structure mass", L, "parameters/c/default", 2, "structure.mass", "not positive definite"),
    ("structure stiffness", L, "structure/stiffness/0/1", 1, "structure.stiffness", "not symmetric"),
    ("structure force", L, "structure/force", [1], "structure.force", "has 1 entries"),
    ("coordinate twice", L, "structure/coordinates", ["x", "x"], "structure.coordinates[1]", "appears twice"),
    # expressions
    ("unknown name", S, "bodies/1/length", "2*l2", "bodies[1] 'rod'.length", "unknown name 'l2'"),
    ("time in a mass", S, "bodies/0/mass", "1 + t", "bodies[0] 'crank'.mass", "t is not available"),
    ("unknown measure", S, "loads/0/value", "sped", "loads[0] 'motor'.value", "unknown name 'sped'"),
    ("measure in a motion", M, "joints/0/motion", "push", "joints[0] 'drive'.motion", "unknown name"),
    ("infinite at the start", M, "joints/0/motion", "1/t", "joints[0] 'drive'.motion", "no finite value"),
    ("huge power", S, "bodies/0/mass", "9**9**9", "bodies[0] 'crank'.mass", "no finite value"),
    # partition, initial state, simulation
    ("unknown start", S, "initial/coordinates/rod.q3", 0, "initial.coordinates['rod.q3']", "no coordinate"),
    ("unknown start rate", S, "initial/rates/crank.phi", 0, "initial.rates['crank.phi']", "no coordinate"),
    ("start is text", S, "initial/coordinates/rod.q1", "0", "initial.coordinates['rod.q1'].value", "not a number"),
    ("unknown independent", S, "partition/independent", ["rod.q9"], "partition.independent[0]", "no coordinate"),
    ("empty pattern", S, "partition/groups/1/coordinates", ["rood.*"],
     "partition.groups[1] 'fast'.coordinates[0]", "matches no coordinate"),
    ("in two groups", S, "partition/groups/1/coordinates", ["crank.*"],
     "partition.groups[1] 'fast'.coordinates[0]", "'slow' already"),
    ("not independent", S, "partition/independent", ["rod.q1", "rod.q2"],
     "partition.groups[0] 'slow'.coordinates[0]", "is not independent"),
    ("too few ratios", S, "simulation/m", [], "simulation.m", "0 step ratios for 2 groups"),
    ("too many ratios", S, "simulation/m", [2, 2], "simulation.m", "2 step ratios for 2 groups"),
    ("ratio not whole", S, "simulation/m", [2.5], "simulation.m[0]", "not a whole number"),
    ("ratio zero", S, "simulation/m", [0], "simulation.m[0]", "out of range"),
    ("ratio huge", S, "simulation/m", [10**12], "simulation.m[0]", "out of range"),
    ("step zero", S, "simulation/dt", 0, "simulation.dt", "not positive"),
    ("step negative", S, "simulation/dt", -1e-4, "simulation.dt", "not positive"),
    ("end negative", S, "simulation/t_end", -1, "simulation.t_end", "not positive"),
    ("too many steps", S, "simulation/dt", 1e-300, "simulation.dt", "more than"),
    ("seen never", S, "simulation/seen_every", -1, "simulation.seen_every", "out of range"),
]  # fmt: skip


@pytest.mark.parametrize("name", GOOD)
def test_the_good_scenes_are_good(name: str) -> None:
    SceneRecord.from_dict(GOOD[name])


@pytest.mark.parametrize(
    ("base", "path", "value", "item", "phrase"), [case[1:] for case in BAD], ids=[case[0] for case in BAD]
)
def test_bad_scene(base: str, path: str, value: Any, item: str, phrase: str) -> None:
    with pytest.raises(SceneError) as caught:
        SceneRecord.from_dict(edited(base, path, value))
    error = caught.value
    assert (error.item, error.remedy != "") == (item, True)
    assert phrase in error.problem
    assert str(error) == f"{error.item}: {error.problem}; {error.remedy}"


HOSTILE = [
    "__import__('os').system('true')", "l1.__class__", "l1.real", "().__class__", "l1[0]", "lambda: 1",
    "[1 for x in l1]", "{l1}", "l1 if 1 < 2",
    "f'{l1}'", "(x := 1)", "'text'", "sin(x=1)", "sin(1, 2)", "sin()", "where(1, 2, 3)", "1 < 2", "1 if l1 else 2",
    "l1 and 1", "not l1", "1j", "True", "None", "...", "sin", "eval(1)", "*l1", "sin(*l1)", "l1; l1", "l1 = 2",
    "", "  ",
    "1 +", "((1)", "l1 // 2", "2 ^ 3", "~1", "min(1)", "1e999", "1" + "0" * 400, "1" * 5000, "l1\x00", "ﬁ",
    "1" + "+1" * 200,
    "(" * 300 + "1" + ")" * 300, "-" * 9000 + "1", "1+" * 6000 + "1", "await l1", "yield", "@",
    "# only a comment", "exp(1e9)",
]  # fmt: skip


@pytest.mark.parametrize("text", HOSTILE, ids=lambda text: ascii(text[:20]))
def test_hostile_expressions_are_refused(text: str) -> None:
    with pytest.raises(SceneError) as caught:
        SceneRecord.from_dict(edited("slider_crank", "bodies/1/length", text))
    assert caught.value.item == "bodies[1] 'rod'.length"
    assert caught.value.remedy


def test_all_errors_of_a_stage_are_reported() -> None:
    data = edited("slider_crank", "bodies/0/mass", -1)
    data["joints"][0]["marker_b"] = "crank.typ"
    with pytest.raises(SceneError) as caught:
        SceneRecord.from_dict(data)
    assert caught.value.remedy == "did you mean 'tip'?"
    assert [error.item for error in caught.value.also] == ["bodies[0] 'crank'.mass"]


@pytest.mark.parametrize(
    ("content", "phrase"),
    [
        (b"name = ", "not valid TOML"),
        (b"name = 'a'\nname = 'b'", "not valid TOML"),
        (b"\xff\xfe", "not UTF-8"),
        (b"name = " + b"[" * 5000, "nested too deeply"),
        (b"name = " + b"1" * 5000, "not valid TOML"),
    ],
    ids=["no value", "key twice", "not UTF-8", "deep", "long integer"],
)
def test_bad_files(tmp_path: Path, content: bytes, phrase: str) -> None:
    path = tmp_path / "scene.toml"
    path.write_bytes(content)
    with pytest.raises(SceneError) as caught:
        SceneRecord.from_toml(path)
    assert "scene.toml" in caught.value.item
    assert phrase in caught.value.problem


def test_files_that_cannot_be_read(tmp_path: Path) -> None:
    with pytest.raises(SceneError, match="does not exist"):
        SceneRecord.from_toml(tmp_path / "none.toml")
    (tmp_path / "pumpjack.toml").touch()
    with pytest.raises(SceneError, match="did you mean 'pumpjack.toml'"):
        SceneRecord.from_toml(tmp_path / "pumpjak.toml")
    with pytest.raises(SceneError, match="cannot be read"):
        SceneRecord.from_toml(tmp_path)


def test_a_rate_among_places_is_told_where_it_stands() -> None:
    with pytest.raises(SceneError, match=r"a rate stands by its coordinate: .*\[initial.rates\] 'rod.x'"):
        SceneRecord.from_dict(edited(S, "initial/coordinates/rod.x_dot", 1.0))
