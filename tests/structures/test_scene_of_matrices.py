"""Scene.structure of sparse matrices, files, arrays and finite-element bodies; what a run of it leaves."""

from __future__ import annotations

import re
from importlib.util import find_spec

import numpy as np
import pytest
import scipy.io
import scipy.sparse as sp

from runtime import ArgumentError
from runtime.structures import LinearStructure, StructureError, StructureModel
from symgen import Scene, SceneError
from symgen.scenes.plate import FORCE, PULSE, plate
from tests.structures.bars import bar


def driven_bar(**fields) -> StructureModel:
    K, M = bar(np.ones(20))
    names = [f"n{k}" for k in range(1, 21)]
    scene = Scene("bar", title="Bar").parameter("F", 2.0)
    return scene.structure(mass=M, stiffness=K, coordinates=names, **fields).model()


def test_forces_by_name_expression_and_pattern_are_the_same() -> None:
    text = "F * where(t < 3, sin(pi * t / 3)**2, 0)"
    forces = ({"n20": text}, [(np.eye(20)[19], text)], [0] * 19 + [text])
    one, other, third = (driven_bar(force=force).simulate(8.0, dt=0.02, error="off") for force in forces)
    assert np.array_equal(one["n20"], other["n20"]) and np.array_equal(one["n20"], third["n20"])
    momentum = one.rates @ np.r_[np.ones(19), 0.5]  # before the wave has reached the wall: the integral of the force
    assert one.status.name == "completed" and momentum == pytest.approx(3.0, rel=2e-3)


def test_a_constant_force_ends_in_its_static_deflection() -> None:
    model = driven_bar(force={"n20": "F"}, damping={"mass": 0.05, "stiffness": 0.02})
    run = model.simulate(400.0, samples=100)
    assert run["n20"][-1] == pytest.approx(40.0, rel=1e-3)
    assert model.static({"n20": 2.0})[-1] == pytest.approx(40.0, rel=1e-12)


def test_matrices_come_from_files(tmp_path) -> None:
    K, M = bar(np.ones(20))
    scipy.io.mmwrite(tmp_path / "K.mtx", K)
    scipy.io.mmwrite(tmp_path / "M.mtx", sp.diags(M).tocsr())
    model = Scene("bar").structure(mass=tmp_path / "M.mtx", stiffness=str(tmp_path / "K.mtx")).model()
    assert abs(model.structure.stiffness - K).max() == 0 and np.array_equal(model.structure.mass, M)


def test_large_arrays_are_data_and_small_ones_are_equations() -> None:
    K, M = bar(np.ones(100))
    assert isinstance(Scene("bar").structure(mass=np.diag(M), stiffness=K.toarray()).model(), StructureModel)
    K, M = bar(np.ones(3))
    small = Scene("bar").structure(coordinates=["a", "b", "c"], mass=np.diag(M), stiffness=K.toarray()).model()
    assert list(small.q_i) == ["a", "b", "c"]


@pytest.mark.skipif(find_spec("skfem") is None, reason="scikit-fem is not installed")
def test_a_solid_body_with_held_nodes() -> None:
    """The lowest bending frequency of a solid cantilever against the beam's, 1.8751^2 sqrt(EI / (m L^4))."""
    from skfem import MeshHex

    from symgen.fe import FlexibleBody, Material

    mesh = MeshHex.init_tensor(np.linspace(0, 1, 21), np.linspace(0, 0.1, 3), np.linspace(0, 0.1, 3))
    ends = {name: (lambda x, at=at: np.abs(x[:, 0] - at) < 1e-9) for name, at in (("root", 0.0), ("tip", 1.0))}
    body = FlexibleBody.from_mesh(mesh, Material(E=2e11, nu=0.0, rho=7800.0), interface=ends, modes=1)
    scene = Scene("cantilever").structure(body=body, fixed=["root"], lump="diagonal")
    model = scene.model()
    assert model.structure.width == 3 and model.structure.is_lumped
    beam = 1.8751**2 * np.sqrt(2e11 * 0.1**2 / 12 / 7800.0)
    assert model.modes(2)[0] == pytest.approx(beam, rel=0.02)
    assert model.structure.mass.sum() == pytest.approx(3 * 78.0 * (1 - 1 / 80), rel=0.05)


def test_the_plate_of_the_demo() -> None:
    """Its matrices: no strain in rigid motion, the weight; its regions; sub-cycling against one step for all."""
    found = plate(20, 4)
    n = len(found.names)
    assert found.mass[::2].sum() == pytest.approx(7850.0 * (1 - 1 / 40), rel=1e-9)
    inner = np.repeat(found.points[:, 0] > 0.06, 2)
    moved = np.zeros(n)
    moved[0::2], moved[1::2] = -found.points[:, 1], found.points[:, 0]
    assert np.abs((found.stiffness @ moved)[inner]).max() < 1e-9 * abs(found.stiffness).max()
    scene = Scene("plate").parameter("F", FORCE).parameter("T", PULSE)
    pulse = {found.pulled: "F * where(t < T, sin(pi * t / T)**2, 0)"}
    model = scene.structure(
        mass=found.mass, stiffness=found.stiffness, coordinates=found.names, width=2, force=pulse,
        points=found.points, cells=found.cells,
    ).model()  # fmt: skip
    assert len(model.regions().groups) >= 2 and model.stability().stable
    run, right = model.simulate(2e-4, tolerance=0.02), model.simulate(2e-4, scheme="single_rate", tolerance=1e-4)
    assert run.status.name == right.status.name == "completed"
    true = np.abs(run.x - right.x).max() / np.abs(right.x).max()
    assert true < 0.03 and run.error.largest < 0.02


@pytest.mark.long
def test_report_files_pictures_and_saved_run(tmp_path) -> None:
    found = plate(30, 6)
    model = Scene("plate").structure(
        mass=found.mass, stiffness=found.stiffness, coordinates=found.names, width=2,
        force={found.pulled: "1e3 * sin(4e4 * t)"}, points=found.points, cells=found.cells,
    ).model()  # fmt: skip
    report = model.report(1e-4, tmp_path)
    assert {row.method.split(",")[0] for row in report.rows} == {"single_rate", "printed", "generalized_alpha"}
    by = {
        method: [row.error for row in report.rows if row.method == method] for method in {r.method for r in report.rows}
    }
    for errors in by.values():
        assert errors[0] > errors[-1]
    assert {path.name for path in tmp_path.iterdir()} == {"methods.md", "methods.csv", "error_time.png"}
    run = model.simulate(1e-4)
    for name, draw in (("motion", run.plot), ("fields", run.plot_fields), ("regions", run.plot_regions)):
        draw(tmp_path / f"{name}.png")
        assert (tmp_path / f"{name}.png").stat().st_size > 10_000
    with np.load(run.save(tmp_path / "run.npz")) as stored:
        kept = dict(stored)
    assert np.array_equal(kept["values"], run.values) and str(kept["status"]).startswith("completed")


def test_the_page_of_a_run_has_its_figures(tmp_path) -> None:
    """A mass let go at 1 mm on 10 kN/m: the peak is the start, k x^2 / 2 = 5 mJ; and pictures of a plate."""
    structure = LinearStructure(sp.csr_matrix([[1e4]]), np.ones(1), coordinates=["x"], title="<b>Drop")
    run = StructureModel(structure).simulate(0.05, scheme="single_rate", dt=1e-4, initial={"x": 1e-3})
    text = run.page(tmp_path / "page.html").text
    rows = [re.findall(r"<td[^>]*>(.*?)</td>", row) for row in re.findall(r"<tr>(.*?)</tr>", text)]
    by_name = {row[0]: row[1:] for row in rows if row}
    assert by_name["x"][:2] == ["1 mm", "0"] and by_name["total energy"][0] == "5 mJ"
    assert by_name["displacement of the mesh, where fields were kept"][-1] == "node 1"
    assert "<h1>&lt;b&gt;Drop</h1>" in text and ">completed<" in by_name["status"][0]
    assert not re.search(r'(src|href)="(?!data:)|<script', text) and text.count("<img") == 1
    found = plate(6, 2)
    model = Scene("plate").structure(
        mass=found.mass, stiffness=found.stiffness, coordinates=found.names, width=2, points=found.points,
        cells=found.cells,
    ).model()  # fmt: skip
    run = model.simulate(1e-4, initial={found.pulled: 1e-3}, fields=5)
    assert run.page(tmp_path / "page.html").text.count("<img") >= 2


@pytest.mark.skipif(find_spec("meshio") is None, reason="meshio is not installed")
def test_vtk_for_paraview(tmp_path) -> None:
    import meshio

    found = plate(6, 2)
    model = Scene("plate").structure(
        mass=found.mass, stiffness=found.stiffness, coordinates=found.names, width=2, points=found.points,
        cells=found.cells,
    ).model()  # fmt: skip
    run = model.simulate(1e-4, initial={found.pulled: 1e-3}, fields=5)
    with meshio.xdmf.TimeSeriesReader(run.to_vtk(tmp_path / "run.xdmf")) as reader:
        points, cells = reader.read_points_cells()
        assert reader.num_steps == 6 and len(cells[0].data) == len(found.cells)
        t, data, _ = reader.read_data(5)
    assert t == pytest.approx(1e-4)
    assert data["displacement"][:, :2].ravel() == pytest.approx(run.fields[5], rel=1e-9, abs=1e-15)


@pytest.mark.parametrize(
    ("fields", "says"),
    [
        ({"force": {"n21": "1"}}, "structure.force 'n21': is not a coordinate of the structure"),
        ({"force": {"n20": "x + 1"}}, "structure.force 'x + 1'"),
        ({"force": {"n20": "__import__('os')"}}, "structure.force"),
        ({"force": "1"}, "structure.force: '1' is not known"),
        ({"force": [1.0, 2.0]}, "structure.force: has 2 entries for 20 coordinates"),
        ({"damping": {"mas": 1.0}}, "structure.damping.mas"),
        ({"springs": 3}, "structure.springs: is not known"),
        ({"mass": None}, "structure.mass: is missing"),
    ],
)
def test_what_cannot_be_used_is_named(fields: dict, says: str) -> None:
    K, M = bar(np.ones(20))
    names = [f"n{k}" for k in range(1, 21)]
    with pytest.raises((SceneError, StructureError)) as error:
        Scene("bar").structure(**{"mass": M, "stiffness": K, "coordinates": names, **fields}).model()
    assert says in str(error.value)


def test_a_structure_of_matrices_has_no_bodies() -> None:
    K, M = bar(np.ones(20))
    with pytest.raises(SceneError, match="bodies: does not go with a structure"):
        Scene("bar").rigid("a", mass=1.0, inertia=1.0).structure(mass=M, stiffness=K)


def test_a_load_outside_its_domain_is_named_with_its_time() -> None:
    with pytest.raises(StructureError, match=r"load 'sqrt\(1 - t\)': is nan at t = 1\.\d+ s"):
        driven_bar(force={"n20": "sqrt(1 - t)"}).simulate(2.0)


@pytest.mark.parametrize(
    ("fields", "says"),
    [
        ({"mass": np.full(20, 1.0 + 1j)}, "mass: has entries of type complex128; give real numbers"),
        ({"mass": np.full(20, True)}, "mass: has entries of type bool"),
        ({"mass": object()}, "mass: has entries of type object"),
        ({"stiffness": 1j * sp.eye(20, format="csr")}, "stiffness: has entries of type complex128"),
        ({"points": np.zeros((3, 2))}, "points: have shape (3, 2); give (20, 2 or 3), a row a node"),
        ({"points": np.full((20, 2), np.nan)}, "points: hold a number that is not finite"),
        ({"cells": [[0, 1, 20]]}, "cells: cell 0 has node 20 of 20"),
        ({"cells": [[0, 1, 2], [0, -1, 2]]}, "cells: cell 1 has node -1 of 20"),
        ({"cells": [[0, 0.5, 2]]}, "cells: cell 0 has node 0.5 of 20"),
        ({"cells": [[0, 1, 2], [0, 1]]}, "cells: cannot be read"),
        ({"coordinates": list(range(20))}, "structure.coordinates[0]: cannot be 0; give text"),
        ({"coordinates": ["a\nb", *map(str, range(19))]}, "structure.coordinates[0]: its character 2, U+000A"),
        ({"coordinates": 3}, "coordinates: cannot be 3"),
        ({"width": True}, "width: True coordinates a node"),
        ({"lump": 3}, "structure.lump: cannot be 3"),
        ({"fixed": [1]}, "structure.fixed: belongs to a body"),
        ({"force": [("a", "1")]}, "structure.force[0]: the pattern is 'a'"),
    ],
)
def test_data_of_a_wrong_kind_is_named(fields: dict, says: str) -> None:
    K, M = bar(np.ones(20))
    with pytest.raises((SceneError, StructureError)) as error:
        Scene("bar").structure(**{"mass": M, "stiffness": K, **fields}).model()
    assert says in str(error.value)


def test_a_title_of_two_lines_is_refused_and_one_of_markdown_is_data(tmp_path) -> None:
    K, M = bar(np.ones(4))
    with pytest.raises(SceneError, match=r"title: its character 2, U\+000A"):
        Scene("bar", title="a\nb").structure(mass=M, stiffness=K)
    Scene("bar", title="<script>[x](y)").structure(mass=M, stiffness=K, force={"x3": "sin(t)"}).model().report(
        0.5, tmp_path
    )
    assert "<script>" not in (tmp_path / "methods.md").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("call", "says"),
    [
        (lambda m: m.simulate(1.0, dt="x"), "dt: cannot be 'x'; give a finite number"),
        (lambda m: m.simulate(1.0, dt=1e-300), "more than 1e+09 steps"),
        (lambda m: m.simulate(10**400), "t_end: "),
        (lambda m: m.simulate(1.0, m=2.5), "m: cannot be 2.5"),
        (lambda m: m.simulate(1.0, groups=3), "groups: cannot be 3"),
        (lambda m: m.simulate(1.0, groups={"a": ["n3"], "b": ["n3"]}), "groups: n3 is in 'a' and in 'b'"),
        (lambda m: m.simulate(1.0, tolerance="x"), "tolerance: cannot be 'x'"),
        (lambda m: m.simulate(1.0, fields=10**9), "fields: 1000000000 would take all memory; give at most 10000"),
        (lambda m: m.simulate(1.0, initial={"n1": "a"}), "initial: cannot be {'n1': 'a'}"),
        (lambda m: m.simulate(1.0, tend=1.0), "tend: simulate has no such argument; did you mean t_end?"),
        (lambda m: m.simulate(1.0, scheme="generalized_alpha", rho_inf="x"), "rho_inf: cannot be 'x'"),
        (lambda m: m.modes("x"), "count: cannot be 'x'"),
        (lambda m: m.static(3), "force: cannot be 3"),
        (lambda m: m.stability(points=-1), "points: stability has no such argument"),
        (lambda m: m.simulate(1.0).save(3), "path: cannot be 3"),
    ],
)
def test_arguments_of_a_wrong_kind_are_named(call, says: str) -> None:
    with pytest.raises((ArgumentError, StructureError)) as error:
        call(driven_bar())
    assert says in str(error.value)


def test_more_samples_than_steps_are_those_of_all_steps() -> None:
    run = driven_bar().simulate(1.0, samples=10**12, error="off")
    assert len(run.t) == run.stats["steps"] + 1
