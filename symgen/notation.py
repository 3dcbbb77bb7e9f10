"""The symbol table: names of the code, symbols of the paper. Read this file second, after pipeline.py.

Names follow the paper. A velocity ends in `_dot`, an acceleration in `_ddot`; q_d is *dependent*, never a velocity.
L and S name the step size (large, small), not rigid and elastic: which coordinate is in which group is data.
Shapes: n coordinates, n_i independent, n_d dependent, n_c constraint rows, nf modes of a body, n_p parameters.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Symbol:
    """One name: in the code, in the paper, the equation it first stands in ("20", "40-43"), shape, SI unit, meaning.

    equation is "" for what the paper does not have. Unit "mixed" means metres or radians (and their rates) by entry.
    """

    code: str
    paper: str
    equation: str
    shape: str
    unit: str
    meaning: str


SYMBOLS: tuple[Symbol, ...] = (
    # coordinates
    Symbol("q", "q", "15", "n", "mixed", "all coordinates: R_o, theta, q_f of each body in scene order"),
    Symbol("R_o", "R^o", "16", "2 or 3", "m", "origin of a body's floating frame in world axes"),
    Symbol("theta", "theta", "17", "1, 3 or 4", "rad", "angle of a body's frame; Euler angles or parameters e"),
    Symbol("q_f", "q_f", "18", "nf", "m", "elastic (modal) coordinates of a body"),
    Symbol("Phi", "phi_k", "19", "2 or 3 x nf", "1", "shape functions at a point of a body"),
    Symbol("q_i", "q_i", "29", "n_i", "mixed", "independent coordinates, in the order of the partition"),
    Symbol("q_d", "q_d", "29", "n_d", "mixed", "dependent coordinates, q_d = f(q_i, t)"),
    Symbol("q_i_dot", "q_i'", "36", "n_i", "mixed", "rates of the independent coordinates"),
    Symbol("q_d_dot", "q_d'", "36", "n_d", "mixed", "rates of the dependent coordinates"),
    Symbol("q_i_ddot", "q_i''", "35", "n_i", "mixed", "accelerations of the independent coordinates"),
    Symbol("q_d_ddot", "q_d''", "35", "n_d", "mixed", "accelerations of the dependent coordinates"),
    Symbol("t", "t", "21", "1", "s", "time"),
    Symbol("p", "", "", "n_p", "SI", "parameters: every physical number of a scene that is not zero"),
    Symbol("c", "", "", "n_const", "SI", "what depends on p only, computed once a run: c = constants(p)"),
    # bodies
    Symbol("M_RR", "m_RR", "20", "2 x 2, 3 x 3", "kg", "translational mass block (its diagonal entry)"),
    Symbol("M_thetatheta", "m_thetatheta", "20", "1", "kg m^2", "rotational inertia at the current q_f"),
    Symbol("M_thetaf", "m_thetaf", "20", "1 x nf", "kg m", "coupling of rotation and deformation"),
    Symbol("M_ff", "m_ff", "20", "nf x nf", "kg", "modal mass matrix"),
    Symbol("K_ff", "K_ff", "20", "nf x nf", "N/m", "modal stiffness matrix"),
    Symbol("D_ff", "", "", "nf x nf", "N s/m", "modal damping matrix (the paper has none)"),
    Symbol("M", "M", "20", "n x n", "SI", "mass matrix in all coordinates"),
    Symbol("Q_star", "Q*", "28", "n", "N, N m", "generalised force Q_F + Q_v - K q in all coordinates"),
    Symbol("S_H", "", "", "nf x nf", "kg/m", "int H dm: foreshortening of a body with geometric stiffening"),
    Symbol("G_H", "", "", "nf x nf", "kg", "int x H dm: its part in the centrifugal stiffness"),
    # constraints
    Symbol("C", "C", "21", "n_c", "m, rad", "constraint rows C(q, t) = 0 in scene order"),
    Symbol("C_q", "C_q", "24", "n_c x n", "SI", "constraint Jacobian"),
    Symbol("C_t", "C_t", "24", "n_c", "m/s, rad/s", "partial time derivative of C (prescribed motions)"),
    Symbol("nu", "nu", "26", "n_c", "m/s, rad/s", "right-hand side at velocity level, nu = -C_t"),
    Symbol("gamma", "gamma", "27", "n_c", "m/s^2, rad/s^2", "right-hand side at acceleration level"),
    Symbol("lam", "lambda", "37", "n_c", "N, N m", "Lagrange multipliers; the constraint force on q is -C_q^T lam"),
    # condensation
    Symbol("M_hat", "M^", "38", "n_i x n_i", "SI", "condensed mass matrix S^T M S"),
    Symbol("Q_hat", "Q^", "38", "n_i", "N, N m", "condensed force S^T (Q* - M s)"),
    Symbol("dQ_hat_dq_i", "", "", "n_i x n_i", "SI", "total derivative of Q_hat by q_i, through q_d"),
    Symbol("dQ_hat_dq_i_dot", "", "", "n_i x n_i", "SI", "total derivative of Q_hat by q_i_dot, through q_d_dot"),
    Symbol("dMa_dq_i", "", "", "n_i x n_i", "SI", "total derivative of M_hat q_i_ddot by q_i at fixed q_i_ddot"),
    Symbol("C_loop", "C", "31", "loops", "m, rad", "loop closure error before a Newton step"),
    Symbol("det_loop", "det C_qd", "31", "loop blocks", "SI", "determinants of the loop blocks, zero if singular"),
    # what functions take and give beside these
    Symbol("q_dot", "q'", "16", "n", "mixed", "rates of all coordinates"),
    Symbol("q_ddot", "q''", "23", "n", "mixed", "accelerations of all coordinates"),
    Symbol("q_d_next", "q_d", "31", "n_d", "mixed", "dependent coordinates after one Newton step"),
    Symbol("K", "K", "20", "n x n", "SI", "stiffness matrix in all coordinates"),
    Symbol("Q_v", "Q_v", "20", "n", "N, N m", "quadratic velocity force in all coordinates"),
    Symbol("Q_F", "Q_F", "28", "n", "N, N m", "force of loads, weight and damping in all coordinates"),
    Symbol("gamma_b", "gamma", "28", "n_c", "m/s^2, rad/s^2", "gamma with Baumgarte terms"),
    Symbol("lam_R", "", "", "n_R", "N, N m", "multipliers of the redundant rows, which no equation determines"),
    Symbol(
        "joint_forces", "", "", "3 or 6 x joints", "N, N m", "world force and moment of a joint on its body b, at b"
    ),
    Symbol("kinetic", "", "", "1", "J", "kinetic energy"),
    Symbol("elastic", "", "", "1", "J", "energy stored in bodies and springs"),
    Symbol("potential", "", "", "1", "J", "potential energy of the weight"),
    Symbol("power_dissipated", "", "", "1", "W", "power lost in dampers, at least zero"),
    Symbol("power_applied", "", "", "1", "W", "power of the loads"),
    Symbol("measures", "", "", "measures", "mixed", "measures of the scene and their rates"),
    Symbol(
        "poses", "", "", "12 x bodies", "m, 1", "origin, then columns of the rotation matrix, of each body that moves"
    ),
    Symbol("positions", "", "", "3 x points", "m", "drawn points in body axes"),
    Symbol("axes", "", "", "9 x points", "1", "columns of the rotation matrix of the marker at a drawn point"),
    Symbol("shapes", "", "", "3 x modes", "1", "displacement of a drawn point by each mode of its body"),
    Symbol("turns", "", "", "3 x modes", "1/m", "rotation at a drawn point by each mode of its body"),
    Symbol("H", "", "", "1 x entries", "1/m", "foreshortening of the drawn points that have it, nf x nf each"),
    Symbol("sections", "", "", "2 x beams", "m", "height and width of a rectangle that stands for a beam's section"),
    Symbol("bounded", "", "", "expressions", "SI", "expressions of the scene that must keep their sign"),
    # groups and steps
    Symbol("M_hat_SS", "M^_SS", "39", "n_S x n_S", "SI", "block of M_hat of the groups that take a sub-step"),
    Symbol("rhs_S", "Q^_S - M^_SL q_L''", "64", "n_S", "N, N m", "right-hand side of a sub-step, slow q'' given"),
    Symbol("q_L_ddot", "q_L''", "59", "n_L", "mixed", "accelerations of the slower groups, frozen over their step"),
    Symbol("dt_L", "Delta t_L", "40-43", "1", "s", "major step: step of the slowest group"),
    Symbol("m", "m", "72", "groups - 1", "1", "ratio of each next group's step; in templates a body's mass"),
    Symbol("h", "Delta t", "72", "groups", "s", "step of each group, slow to fast"),
    Symbol("d", "q^t - q^(t-Delta t)", "40-43", "n_i", "mixed", "last increment, stored instead of the last point"),
    Symbol("eps", "epsilon_L, epsilon_S", "56-57", "groups", "mixed", "tolerances of the sweep, slow to fast"),
)


BY_NAME = {symbol.code: symbol for symbol in SYMBOLS}


def table() -> str:
    """The symbols as a Markdown table (docs/theory/names.md holds it; a test compares)."""
    lines = ["| code | paper | Eq. | shape | unit | meaning |", "|---|---|---|---|---|---|"]
    for symbol in SYMBOLS:
        paper = f"`{symbol.paper}`" if symbol.paper else ""
        equation = f"({symbol.equation})" if symbol.equation else ""
        lines.append(f"| `{symbol.code}` | {paper} | {equation} | {symbol.shape} | {symbol.unit} | {symbol.meaning} |")
    return "\n".join(lines)
