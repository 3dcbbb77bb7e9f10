"""Solid meshes of tetrahedra and hexahedra, assembled by scikit-fem."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import scipy.sparse as sp

from symgen.fe.errors import FiniteElementError
from symgen.fe.material import Material
from symgen.fe.stresses import SolidStress
from symgen.fe.structure import AXES, FEStructure, structure
from symgen.fe.surface import boundary_triangles

# Quadrature of this degree integrates the mass of each element exactly (per direction for hexahedra).
DEGREE = {"P1": 2, "P2": 4, "Q1": 3, "Q2": 5}


def solid_structure(mesh: Any, material: Material, order: int = 2) -> FEStructure:
    """Stiffness and consistent mass of a scikit-fem MeshTet or MeshHex; elements P1/Q1 (order 1) or P2/Q2 (order 2).

    The first node ids are the mesh's vertices 0, 1, ...; order 2 adds nodes on edges, faces and in cells.
    Linear hexahedra bend too stiffly; take them for compact parts only.
    Raises FiniteElementError without scikit-fem, for other meshes and orders, and for cells turned inside out.
    """
    skfem, scalar = _checked_basis(mesh, order)
    gradients = _gradient_products(skfem, scalar)
    mass = material.rho * skfem.BilinearForm(lambda u, v, _: u * v).assemble(scalar)
    K = _elastic(gradients, material)
    n = scalar.N
    # Rows so far: all x, all y, all z. Sort them node by node.
    order_rows = np.arange(AXES * n).reshape(AXES, n).T.ravel()
    K = sp.csr_matrix(K)[order_rows][:, order_rows]
    M = sp.kron(mass, sp.eye(AXES), format="csr")
    body = structure(
        K,
        M,
        np.arange(n),
        np.array(scalar.doflocs.T, dtype=np.float64),
        np.repeat(np.arange(n), AXES),
        np.tile(np.arange(AXES), n),
    )
    return replace(body, facets=boundary_triangles(mesh), stress=SolidStress(scalar, material))


def _checked_basis(mesh: Any, order: int) -> tuple[Any, Any]:
    """(scikit-fem, the scalar basis of the mesh with its quadrature); raises FiniteElementError."""
    try:
        import skfem
    except ImportError as error:
        raise FiniteElementError("scikit-fem", "it is not installed", "pip install 'symgen[fe]'") from error
    kinds = {
        (skfem.MeshTet, 1): ("P1", skfem.ElementTetP1),
        (skfem.MeshTet, 2): ("P2", skfem.ElementTetP2),
        (skfem.MeshHex, 1): ("Q1", skfem.ElementHex1),
        (skfem.MeshHex, 2): ("Q2", skfem.ElementHex2),
    }
    found = [kind for (shape, degree), kind in kinds.items() if isinstance(mesh, shape) and degree == order]
    if not found:
        raise FiniteElementError(
            "mesh",
            f"a {type(mesh).__name__} with elements of order {order}",
            "give a scikit-fem MeshTet or MeshHex and order 1 or 2, or a LineMesh",
        )
    name, element = found[0]
    with np.errstate(divide="ignore", invalid="ignore"):  # flat cells are refused below
        basis = skfem.Basis(mesh, element(), intorder=DEGREE[name])
    volume = np.asarray(basis.mapping.detDF(basis.X))
    bad = np.flatnonzero(volume.min(axis=-1) * volume.max(axis=-1) <= 0.0)
    if bad.size:
        raise FiniteElementError(
            "mesh",
            f"{bad.size} cells have no volume or are turned inside out, the first is {bad[0]}",
            "repair the mesh",
        )
    return skfem, basis


def _gradient_products(skfem: Any, basis: Any) -> list[list[sp.csr_matrix]]:
    """[i][j]: int d_i v d_j u dV, (n, n) each; the lower half by transposition."""
    products: list[list[Any]] = [[None] * AXES for _ in range(AXES)]
    for i in range(AXES):
        for j in range(i, AXES):
            form = skfem.BilinearForm(lambda u, v, _, i=i, j=j: v.grad[i] * u.grad[j])
            products[i][j] = form.assemble(basis)
            products[j][i] = products[i][j].T
    return products


def _elastic(products: list[list[sp.csr_matrix]], material: Material) -> sp.csr_matrix:
    """int lame div u div v + 2 G eps(u) : eps(v) dV from the products of gradients; rows x, then y, then z."""
    diffusion = products[0][0] + products[1][1] + products[2][2]
    blocks = [[material.lame * products[i][j] + material.G * products[j][i] for j in range(AXES)] for i in range(AXES)]
    for i in range(AXES):
        blocks[i][i] = blocks[i][i] + material.G * diffusion
    return sp.csr_matrix(sp.bmat(blocks))
