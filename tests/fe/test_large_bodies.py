"""One factorisation of a body's stiffness: right values, progress, Ctrl-C; too large is said before memory is spent."""

import subprocess
import sys
from typing import Any

import numpy as np
import pytest
import scipy.linalg as la

from symgen.fe import STEEL, FiniteElementError, FlexibleBody

skfem = pytest.importorskip("skfem")

LENGTH = 0.4
ENDS = {"low": lambda p: p[:, 2] < 1e-9, "high": lambda p: p[:, 2] > LENGTH - 1e-9}


def beam(cells: int = 2, **choices: Any) -> FlexibleBody:
    """A block of bricks, slightly tapered so that no two frequencies are equal."""
    across, along = np.linspace(0.0, 0.06, cells + 1), np.linspace(0.0, LENGTH, 4 * cells + 1)
    mesh = skfem.MeshHex.init_tensor(across, 1.3 * across, along)
    choices = {"interface": ENDS, "modes": 6, **choices}
    return FlexibleBody.from_mesh(mesh, STEEL, **choices)


def test_free_and_held_frequencies_are_those_of_dense_matrices() -> None:
    """Against LAPACK on the full matrices: 1,275 rows, several levels of halves."""
    body = beam()
    K, M = body.structure.K.toarray(), body.structure.M.toarray()
    hertz = np.sqrt(np.abs(la.eigh(K, M, eigvals_only=True, subset_by_index=[0, 11]))) / (2.0 * np.pi)
    np.testing.assert_allclose(body.frequencies, hertz[6:], rtol=1e-9)

    free = np.flatnonzero(body.structure.positions[body.structure.node, 2] > 1e-9)
    held = la.eigh(K[np.ix_(free, free)], M[np.ix_(free, free)], eigvals_only=True, subset_by_index=[0, 5])
    mixed = beam(mode_set="mixed", fixed=["low"])
    np.testing.assert_allclose(mixed.frequencies, np.sqrt(held) / (2.0 * np.pi), rtol=1e-9)


def test_static_displacements_are_those_of_dense_matrices() -> None:
    """Inertia relief of forces at an end: the pseudo-inverse in the metric of M, by the full eigenvectors."""
    body = beam()
    value, vector = la.eigh(body.structure.K.toarray(), body.structure.M.toarray())
    force = np.asarray(body.interfaces["high"].average.todense()).T
    expected = vector[:, 6:] @ ((vector[:, 6:].T @ force) / value[6:, None])
    np.testing.assert_allclose(body.modes.elastic(force), expected, rtol=0, atol=1e-8 * np.abs(expected).max())


def test_the_stiffness_is_factorised_once() -> None:
    """For modes, static shapes, stiffening, gauges, struts, stresses and the report."""
    seen: list[tuple[float, float]] = []
    body = beam(stiffening=True, static=["low"], progress=lambda done, total: seen.append((done, total)))
    body.fields(0.01, gauges={"middle": [0.03, 0.0, 0.2]})
    body.equilibrium_stresses([[0.03, 0.0, 0.2]])
    body.report()
    assert sum(done == total for done, total in seen) == 1
    assert all(one[0] < two[0] <= two[1] for one, two in zip(seen, seen[1:], strict=False))


def test_ctrl_c_ends_a_factorisation() -> None:
    """What a progress function raises arrives, after the first of several fronts."""
    seen = []

    def stopped(done: float, _total: float) -> None:
        seen.append(done)
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        beam(progress=stopped)
    assert len(seen) == 1


def test_two_bodies_in_one_mesh_are_told() -> None:
    """Parts that are not connected have twelve zero modes."""
    one = skfem.MeshHex.init_tensor(*[np.linspace(0.0, 0.1, 4)] * 3)
    with pytest.raises(FiniteElementError, match="at least 9 motions.*not connected"):
        FlexibleBody.from_mesh(one + one.translated((0.3, 0.0, 0.0)), STEEL, interface={"low": ENDS["low"]}, modes=1)


CROWDED = """
import resource
from pathlib import Path
import numpy as np, skfem, scipy.linalg, scipy.sparse.linalg
from symgen.fe import STEEL, FiniteElementError, FlexibleBody
mesh = skfem.MeshHex.init_tensor(*[np.linspace(0.0, 1.0, 13)] * 3)
taken = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (taken + 300_000_000,) * 2)
try:
    FlexibleBody.from_mesh(mesh, STEEL, interface={"low": lambda p: p[:, 2] < 1e-9}, modes=3)
except FiniteElementError as error:
    print(error)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="limits of memory are those of Linux")
def test_too_large_is_said_before_memory_is_spent() -> None:
    """46,875 degrees of freedom in 300 MB: what they would take is said."""
    done = subprocess.run([sys.executable, "-c", CROWDED], capture_output=True, text=True, check=True)
    assert "mesh: 46,875 degrees of freedom take" in done.stdout
    assert "GB of memory" in done.stdout and "are free" in done.stdout
