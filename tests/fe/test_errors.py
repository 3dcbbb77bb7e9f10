"""Finite-element data that are wrong: each is refused with what, why and a remedy."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import scipy.sparse as sp
import skfem

from symgen.fe import STEEL, FEStructure, FiniteElementError, FlexibleBody, LineMesh, Material, Section
from symgen.fe.frame import frame_structure

N = 11
SECTION = Section.rectangle(0.02, 0.01)
NODES = [(0.05 * k, 0.005 * k * k, 0.0) for k in range(N)]
LINES = [(k, k + 1) for k in range(N - 1)]
ENDS: dict[str, Any] = {"pin": [0], "slot": [N - 1]}
TABLE = np.column_stack([np.arange(N), np.array(NODES)])
MODEL = frame_structure(LineMesh(NODES, LINES, SECTION), STEEL)
CUBE = skfem.MeshHex.init_tensor(*[np.linspace(0.0, 0.1, 3)] * 3)
FACES = {"low": lambda places: places[:, 2] < 1e-9, "high": lambda places: places[:, 2] > 0.0999}


def matrices(K: Any = MODEL.K, M: Any = MODEL.M, nodes: Any = TABLE, **choices: Any) -> FlexibleBody:
    return FlexibleBody.from_matrices(K, M, nodes, **{"dofs": 6, "interface": ENDS, "modes": 3, **choices})


def cube(**choices: Any) -> FlexibleBody:
    return FlexibleBody.from_mesh(CUBE, STEEL, **{"interface": FACES, "modes": 3, "order": 1, **choices})


def frame(nodes: Any = NODES, lines: Any = LINES, section: Any = SECTION) -> FlexibleBody:
    return FlexibleBody.from_mesh(LineMesh(nodes, lines, section), STEEL, interface=ENDS, modes=3)


def changed(matrix: sp.csr_matrix, entries: dict[tuple[int, int], float]) -> sp.csr_matrix:
    result = matrix.tolil()
    for place, value in entries.items():
        result[place] = value
    return result.tocsr()


def hinged(directions: int) -> FEStructure:
    """Two beams of which the second repeats node 2; the two nodes share translations and 3 - `directions` rotations."""
    nodes = [*NODES[:3], *NODES[2:]]
    two = frame_structure(LineMesh(nodes, [(k, k + 1) for k in range(N) if k != 2], SECTION), STEEL)
    spring = np.zeros((6, two.n_dof))
    spring[np.arange(6), 12 + np.arange(6)], spring[np.arange(6), 18 + np.arange(6)] = 1.0, -1.0
    spring = 1e4 * spring[: 6 - directions]
    return replace(two, K=sp.csr_matrix(two.K + sp.csr_matrix(spring.T @ spring)))


def hinge(directions: int) -> FlexibleBody:
    return FlexibleBody.from_structure(hinged(directions), interface={"pin": [0], "slot": [N]}, modes=3)


def uneven_mass() -> sp.csr_matrix:
    """Positive definite, yet the rows of node 0 sum to less than nothing."""
    heavy = {(6 + k, 6 + k): 10.0 for k in range(3)}
    coupled = {place: -2.0 for k in range(3) for place in ((k, 6 + k), (6 + k, k))}
    return changed(sp.eye(MODEL.n_dof), {**heavy, **coupled})


SUPPORTED = {(k, k): 2.0 * MODEL.K[k, k] for k in range(3)}
CASES: dict[str, tuple[Callable[[], object], str, str]] = {
    "size": (lambda: matrices(MODEL.K[:-1, :-1]), "stiffness", "65 x 65, the nodes have 66 dofs"),
    "dofs per node": (lambda: matrices(dofs=3), "stiffness", "the nodes have 33 dofs"),
    "other dofs per node": (lambda: matrices(dofs=4), "dofs", "4 per node"),
    "triangle": (lambda: matrices(sp.triu(MODEL.K)), "stiffness", "not symmetric"),
    "unsymmetric mass": (lambda: matrices(M=changed(MODEL.M, {(0, 6): 1.0})), "mass", "not symmetric"),
    "nan": (lambda: matrices(changed(MODEL.K, {(3, 3): np.nan})), "stiffness", "not a finite number"),
    "negative mass": (lambda: matrices(M=changed(MODEL.M, {(3, 3): -1.0})), "mass", "row 4 has a negative diagonal"),
    "no mass": (lambda: matrices(M=0.0 * MODEL.M), "mass", "singular"),
    "mass on a line": (
        lambda: matrices(M=sp.diags(np.tile([1.0, 1, 1, 0, 0, 0], N)), nodes=TABLE * [1, 1, 0, 0]),
        "mass",
        "singular",
    ),
    "indefinite mass": (
        lambda: matrices(M=changed(MODEL.M, {(0, 6): 40.0, (6, 0): 40.0})),
        "mass",
        "not positive definite",
    ),
    "negative stiffness": (
        lambda: matrices(changed(MODEL.K, {(3, 9): -1e9, (9, 3): -1e9})),
        "stiffness",
        "not positive definite",
    ),
    "empty row": (
        lambda: matrices(
            sp.block_diag([MODEL.K, sp.csr_matrix((6, 6))]),
            sp.block_diag([MODEL.M, sp.csr_matrix((6, 6))]),
            [*TABLE, (99, 0, 0, 0)],
        ),
        "stiffness",
        "6 rows have neither stiffness nor mass, the first is component 1 of node 99",
    ),
    "node table": (lambda: matrices(nodes=TABLE[:, :2]), "nodes", r"shape \(11, 2\)"),
    "node place": (lambda: matrices(nodes=np.where(TABLE == 3.0, np.nan, TABLE)), "nodes", "not a whole number"),
    "node twice": (lambda: matrices(nodes=TABLE[[*range(N - 1), 0]]), "nodes", "twice"),
    "dof map node": (lambda: matrices(dofs=[(k // 6 + 1, k % 6 + 1) for k in range(66)]), "dofs", r"nodes \[11\]"),
    "dof map component": (lambda: matrices(dofs=[(k // 6, k % 6 + 2) for k in range(66)]), "dofs", "not 1 ... 6"),
    "dof map twice": (lambda: matrices(dofs=[(k // 6, 1) for k in range(66)]), "dofs", "appears twice"),
    "dof map shape": (lambda: matrices(dofs=np.ones((66, 3))), "dofs", r"shape \(66, 3\)"),
    "dof map short": (lambda: matrices(dofs=[(k // 6, k % 6 + 1) for k in range(60)]), "stiffness", "66 x 66"),
    "order of nodes": (lambda: matrices(nodes=TABLE[[1, 0, *range(2, N)]]), "nodes", "rigid motions built from"),
    "millimetres": (lambda: matrices(nodes=TABLE * [1, 1e3, 1e3, 1e3]), "nodes", "rigid motions built from"),
    "supports": (lambda: matrices(changed(MODEL.K, SUPPORTED)), "stiffness", "^stiffness: 3 motions without strain"),
    "hinge": (lambda: hinge(1), "stiffness", "^stiffness: 7 motions without strain"),
    "ball": (lambda: hinge(2), "stiffness", "^stiffness: 8 motions without strain.*mechanism.*near node"),
    "apart": (lambda: hinge(6), "stiffness", "^stiffness: at least 9 motions"),
    "unknown node": (lambda: matrices(interface={"pin": [0, 77]}), "interface 'pin'", r"nodes \[77\]"),
    "node named twice": (lambda: matrices(interface={"pin": [1, 1]}), "interface 'pin'", "twice"),
    "no node": (lambda: cube(interface={"pin": lambda places: places[:, 0] > 9.0}), "interface 'pin'", "empty"),
    "no interface": (lambda: matrices(interface={}), "interface", "no interface"),
    "one solid node": (lambda: cube(interface={"pin": [0]}), "interface 'pin'", "on one line"),
    "line of nodes": (
        lambda: cube(interface={"pin": lambda p: np.hypot(p[:, 0], p[:, 1]) < 1e-9}),
        "interface 'pin'",
        "on one line",
    ),
    "too many modes": (lambda: matrices(modes=61), "modes", "61 modes asked for, the model has 60"),
    "negative modes": (lambda: matrices(modes=-1), "modes", "-1 modes"),
    "lumping": (lambda: matrices(M=uneven_mass(), mass="lumped"), "mass", "gives node 0 a negative mass"),
    "coarse": (lambda: matrices(modes=40), "mass", "masses lumped at the nodes"),
    "mode set": (lambda: matrices(mode_set="fre"), "mode_set", "'fre' is not known"),
    "mass kind": (lambda: matrices(mass="lump"), "mass", "'lump' is not known"),
    "mixed without": (lambda: matrices(mode_set="mixed"), "fixed", "needs an interface"),
    "mixed unknown": (lambda: matrices(mode_set="mixed", fixed=["pon"]), "fixed", "'pon' is not known"),
    "fixed in free": (lambda: matrices(fixed=["pin"]), "fixed", "held in a mixed set"),
    "shared node": (
        lambda: matrices(mode_set="fixed_interface", interface={"a": [0], "b": [0, 1]}),
        "interface 'b'",
        "node 0 is also of 'a'",
    ),
    "rigid only": (lambda: matrices(mode_set="fixed_interface", interface={"a": [0]}, modes=0), "modes", "rigid"),
    "origin": (lambda: matrices(origin=(0.0, 1.0)), "origin", "not a point"),
    "origin name": (lambda: matrices(origin="pon"), "origin", "'pon' is not known"),
    "marker": (lambda: matrices(marker_positions={"pon": (0, 0, 0)}), "marker_positions", "'pon' is not known"),
    "damping": (lambda: matrices().fields(-0.1), "damping_ratio", "-0.1"),
    "damping count": (lambda: matrices().fields([0.1, 0.1]), "damping_ratio", "one per mode"),
    "density": (lambda: Material(2e11, 0.3, 0.0), "material.rho", "not a positive number"),
    "poisson": (lambda: Material(2e11, 0.5, 1.0), "material.nu", "not between"),
    "lines": (lambda: frame(lines=[(0, 99)]), "mesh.lines", "not pairs"),
    "no length": (lambda: frame(nodes=[NODES[1], *NODES[1:]]), "mesh.lines", "no length"),
    "sections": (lambda: frame(section=[SECTION]), "mesh.section", "1 sections for 10 lines"),
    "axis": (lambda: frame(nodes=np.array(NODES)[:, [1, 0, 2]] * [0, 1, 1]), "section.y_axis", "along a beam"),
    "mesh": (lambda: FlexibleBody.from_mesh(skfem.MeshTri(), STEEL, interface=FACES, modes=1), "mesh", "MeshTri"),
    "order": (lambda: cube(order=3), "mesh", "order 3"),
    "twisted cell": (
        lambda: FlexibleBody.from_mesh(
            skfem.MeshHex(CUBE.p, CUBE.t[[1, 0, *range(2, 8)]]), STEEL, interface=FACES, modes=1
        ),
        "mesh",
        "turned inside out",
    ),
    "flat cell": (
        lambda: FlexibleBody.from_mesh(
            skfem.MeshTet(CUBE.p * [[1], [1], [0]], skfem.MeshTet().t), STEEL, interface=FACES, modes=1
        ),
        "mesh",
        "no volume",
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_wrong_data_are_refused(name: str) -> None:
    make, item, text = CASES[name]
    with pytest.raises(FiniteElementError, match=text) as caught:
        make()
    assert caught.value.item == item
    assert caught.value.problem and caught.value.remedy
    assert str(caught.value) == f"{item}: {caught.value.problem}; {caught.value.remedy}"


def test_the_data_that_the_cases_spoil_are_good() -> None:
    assert matrices().nf == cube().nf == frame().nf == hinge(0).nf == 3


def test_paths_are_no_matrices() -> None:
    with pytest.raises(FiniteElementError, match="stiffness: not a table of numbers.*mmread"):
        matrices("K.mtx")


def test_masses_of_points_without_rotary_inertia_will_do() -> None:
    """Rows of rotations without mass are static; the count of modes knows."""
    diagonal = np.tile([0.2, 0.2, 0.2, 0.0, 0.0, 0.0], N)
    made = matrices(M=sp.diags(diagonal), modes=12)
    assert made.nf == 12 and made.integrals.mass == pytest.approx(0.2 * N)
    with pytest.raises(FiniteElementError, match="28 modes asked for, the model has 27"):
        matrices(M=sp.diags(diagonal), modes=28)
