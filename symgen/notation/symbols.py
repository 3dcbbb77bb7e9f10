"""The symbol table: names of the code, symbols of the paper. Read this file second, after pipeline.py.

Names follow the paper. A velocity ends in `_dot`, an acceleration in `_ddot`; q_d is *dependent*, never a velocity.
L and S name the step size (large, small), not rigid and elastic: which coordinate is in which group is data.
Shapes: n coordinates, n_i independent, n_d dependent, n_c constraint rows, nf modes of a body, n_p parameters,
n_S and n_L in the groups that take a sub-step and in slower ones.

SYMBOLS are the names of the equations and of the emitted functions; those of z, the state of a time stepping scheme as
one vector, are in fields.py.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Notation:
    """One name: in the code, in the paper, the equation it first stands in ("20", "40-43"), shape, SI unit, meaning.

    equation is "" for what the paper does not have. Unit "mixed" means metres or radians (and their rates) by entry.
    """

    code: str
    paper: str
    equation: str
    shape: str
    unit: str
    meaning: str


SYMBOLS: tuple[Notation, ...] = (
    # coordinates
    Notation("q", "q", "15", "n", "mixed", "all coordinates: R_o, theta, q_f of each body in scene order"),
    Notation("q_dot", "q'", "16", "n", "mixed", "rates of all coordinates"),
    Notation("q_ddot", "q''", "23", "n", "mixed", "accelerations of all coordinates"),
    Notation("R_o", "R^o", "16", "2 or 3", "m", "origin of a body's floating frame in world axes"),
    Notation("theta", "theta", "17", "1 or 4", "rad", "angle of a body's frame, in space its Euler parameters e"),
    Notation("q_f", "q_f", "18", "nf", "m", "elastic (modal) coordinates of a body"),
    Notation("Phi", "phi_k", "19", "2 or 3 x nf", "1", "shape functions at a point of a body"),
    Notation("q_i", "q_i", "29", "n_i", "mixed", "independent coordinates, in the order of the partition"),
    Notation("q_d", "q_d", "29", "n_d", "mixed", "dependent coordinates, q_d = f(q_i, t)"),
    Notation("q_i_dot", "q_i'", "36", "n_i", "mixed", "rates of the independent coordinates"),
    Notation("q_d_dot", "q_d'", "36", "n_d", "mixed", "rates of the dependent coordinates"),
    Notation("q_i_ddot", "q_i''", "35", "n_i", "mixed", "accelerations of the independent coordinates"),
    Notation("q_d_ddot", "q_d''", "35", "n_d", "mixed", "accelerations of the dependent coordinates"),
    Notation("t", "t", "21", "1", "s", "time"),
    Notation("u", "", "", "n_u", "SI", "inputs: what comes from outside during a run, with rates where they have them"),
    Notation("side", "", "", "n_side", "any", "added to what a load jumps by: 0, or -1e300 or 1e300 to hold its side"),
    Notation(
        "chart", "", "", "4 x orientations", "1", "unit quaternions from which the turns in q_i are rotation vectors"
    ),
    Notation("p", "", "", "n_p", "SI", "parameters: every physical number of a scene that is not zero"),
    Notation("c", "", "", "n_const", "SI", "what depends on p only, computed once a run: c = constants(p)"),
    # bodies
    Notation("M_RR", "m_RR", "20", "2 x 2, 3 x 3", "kg", "translational mass block (its diagonal entry)"),
    Notation("M_Rtheta", "m_Rtheta", "20", "2 x 1", "kg m", "coupling of translation and rotation"),
    Notation("M_Rf", "m_Rf", "20", "2 or 3 x nf", "kg", "coupling of translation and deformation"),
    Notation("M_thetatheta", "m_thetatheta", "20", "1", "kg m^2", "rotational inertia at the current q_f"),
    Notation("M_thetaf", "m_thetaf", "20", "1 x nf", "kg m", "coupling of rotation and deformation"),
    Notation("M_ff", "m_ff", "20", "nf x nf", "kg", "modal mass matrix"),
    Notation("K_ff", "K_ff", "20", "nf x nf", "N/m", "modal stiffness matrix"),
    Notation("D_ff", "", "", "nf x nf", "N s/m", "modal damping matrix (the paper has none)"),
    Notation("M", "M", "20", "n x n", "SI", "mass matrix in all coordinates"),
    Notation("Q_star", "Q*", "28", "n", "N, N m", "generalised force Q_F + Q_v - K q in all coordinates"),
    Notation("K", "K", "20", "n x n", "SI", "stiffness matrix in all coordinates"),
    Notation("Q_v", "Q_v", "20", "n", "N, N m", "quadratic velocity force in all coordinates"),
    Notation("Q_F", "Q_F", "28", "n", "N, N m", "force of loads, weight and damping in all coordinates"),
    Notation("S_H", "", "", "nf x nf", "kg/m", "int H dm: foreshortening of a body with geometric stiffening"),
    Notation("G_H", "", "", "nf x nf", "kg", "int x H dm: its part in the centrifugal stiffness"),
    # constraints
    Notation("C", "C", "21", "n_c", "m, rad", "constraint rows C(q, t) = 0 in scene order"),
    Notation("C_q", "C_q", "24", "n_c x n", "SI", "constraint Jacobian"),
    Notation("C_t", "C_t", "24", "n_c", "m/s, rad/s", "partial time derivative of C (prescribed motions)"),
    Notation("nu", "nu", "26", "n_c", "m/s, rad/s", "right-hand side at velocity level, nu = -C_t"),
    Notation("gamma", "gamma", "27", "n_c", "m/s^2, rad/s^2", "right-hand side at acceleration level"),
    Notation("lam", "lambda", "37", "n_c", "N, N m", "Lagrange multipliers; the constraint force on q is -C_q^T lam"),
    Notation("lam_R", "", "", "n_R", "N, N m", "multipliers of the redundant rows, which no equation determines"),
    # condensation
    Notation("M_hat", "M^", "38", "n_i x n_i", "SI", "condensed mass matrix S^T M S"),
    Notation("Q_hat", "Q^", "38", "n_i", "N, N m", "condensed force S^T (Q* - M s)"),
    Notation("S", "", "", "n x n_i", "SI", "q_dot = S q_i_dot + ...: [1; -C_qd^-1 C_qi], in the order (q_i, q_d)"),
    Notation("J_q", "", "", "n_i x n_i", "SI", "total derivative of Q_hat - M_hat a by q_i at fixed a = q_i_ddot"),
    Notation("J_v", "", "", "n_i x n_i", "SI", "the same as dQ_hat_dq_i_dot, in a linear system"),
    Notation("dQ_hat_dq_i", "", "", "n_i x n_i", "SI", "total derivative of Q_hat by q_i, through q_d"),
    Notation("dQ_hat_dq_i_dot", "", "", "n_i x n_i", "SI", "total derivative of Q_hat by q_i_dot, through q_d_dot"),
    Notation("C_loop", "C", "31", "loops", "m, rad", "loop closure error before a Newton step"),
    Notation("q_d_next", "q_d", "31", "n_d", "mixed", "dependent coordinates after one Newton step"),
    Notation("det_loop", "det C_qd", "31", "loop blocks", "SI", "determinants of the loop blocks, zero if singular"),
    # groups and steps
    Notation("M_hat_SS", "M^_SS", "39", "n_S x n_S", "SI", "block of M_hat of the groups that take a sub-step"),
    Notation("M_hat_LL", "M^_LL", "39", "n_L x n_L", "SI", "block of M_hat of the slower groups"),
    Notation("M_hat_LS", "M^_LS", "39", "n_L x n_S", "SI", "block of M_hat that couples them"),
    Notation("M_hat_SL", "M^_SL", "39", "n_S x n_L", "SI", "its transpose"),
    Notation("Q_hat_L", "Q^_L", "39", "n_L", "N, N m", "part of Q_hat of the slower groups"),
    Notation("Q_hat_S", "Q^_S", "39", "n_S", "N, N m", "part of Q_hat of the groups that take a sub-step"),
    Notation("rhs_S", "Q^_S - M^_SL q_L''", "64", "n_S", "N, N m", "right-hand side of a sub-step, slow q'' given"),
    Notation("B", "", "", "n_i x n_s", "1", "stiff deflections s = B^T q_i: modes, springs between coordinates"),
    Notation("K_s", "", "", "n_s x n_s", "SI", "stiffness of the stiff deflections"),
    Notation("D_s", "", "", "n_s x n_s", "SI", "damping of the stiff deflections"),
    Notation("X", "", "", "n_i x n_s", "SI", "M_hat^-1 B: accelerations by forces along the stiff deflections"),
    Notation(
        "shift", "", "", "4", "s^2, s", "kappa and delta of M_hat + B (kappa K_s + delta D_s) B^T, real parts first"
    ),
    Notation("push", "", "", "2 n_s", "SI", "forces along the stiff deflections, real parts first"),
    Notation("v_rel", "", "", "n_e", "m/s, rad/s", "rates of the directions that may stick"),
    Notation("G", "", "", "n_e x n_i", "mixed", "v_rel = G q_i'"),
    Notation("G_bias", "", "", "n_e", "m/s^2, rad/s^2", "what G leaves of v_rel'"),
    Notation("holds", "", "", "n_e", "N, N m", "the largest force that keeps such a direction stuck"),
    Notation("slides", "", "", "n_e", "N, N m", "the force against such a direction once it slides"),
    Notation(
        "Q_hat_R", "", "", "n_i x n_r", "mixed", "what Q_hat gains with each reaction R that friction is a share of"
    ),
    Notation("holds_R", "", "", "n_e x n_r", "1, m", "what holds gains with each of them"),
    Notation("F_0", "", "", "2 or 3 n_r", "N", "force of each such joint, R its size, without accelerations and R"),
    Notation("F_a", "", "", "2 or 3 n_r x n_i", "mixed", "what it gains with q_i_ddot"),
    Notation("F_R", "", "", "2 or 3 n_r x n_r", "1", "what it gains with R"),
    Notation("F_f", "", "", "2 or 3 n_r x n_e", "1, 1/m", "what it gains with the forces f on the directions v_rel"),
    Notation("shares", "", "", "n_e", "N, N m", "by which joints share what they hold together: `holds` for R = 1 N"),
    Notation(
        "margin", "", "", "n_r", "1", "1/2 less what R gains with R: below zero, accelerations may be two or none"
    ),
    Notation("f_rel", "", "", "n_e", "N, N m", "forces on such directions, by their laws where they slide"),
    Notation(
        "mode_left",
        "",
        "",
        "n_m",
        "mixed",
        "by mode: holds - |f_rel| stuck, |v_rel| sliding; of stops the gap, or what presses",
    ),
    Notation("gap", "", "", "n_stop", "m, rad", "distance to each rigid stop"),
    Notation(
        "restitution", "", "", "n_stop", "1", "of each rigid stop: ratio of the speeds after and before an impact"
    ),
    Notation("x_re", "", "", "n_i", "mixed", "what they do beside the shift, real parts"),
    Notation("x_im", "", "", "n_i", "mixed", "imaginary parts"),
    Notation("q_L_ddot", "q_L''", "59", "n_L", "mixed", "accelerations of the slower groups, frozen over their step"),
    Notation("dt_L", "Delta t_L", "40-43", "1", "s", "major step: step of the slowest group"),
    Notation("m", "m", "72", "groups - 1", "1", "ratio of each next group's step; in templates a body's mass"),
    Notation("h", "Delta t", "72", "groups", "s", "step of each group, slow to fast"),
    Notation("eps", "epsilon_L, epsilon_S", "56-57", "groups", "mixed", "tolerances of the sweep, slow to fast"),
    Notation("z", "", "", "fields", "mixed", "state of a scheme: its fields one after another"),
    # what else the emitted functions give
    Notation(
        "joint_forces", "", "", "3 or 6 x joints", "N, N m", "world force and moment of a joint on its body b, at b"
    ),
    Notation(
        "load_forces",
        "",
        "",
        "3 to 10 x loads",
        "N, N m",
        "force of a load on the frame of a flexible body, and of the second half of a linear one",
    ),
    Notation(
        "load_actions", "", "", "3 or 6 x loads", "N, N m", "world force and moment of a load on its marker, or b"
    ),
    Notation("kinetic", "", "", "1", "J", "kinetic energy"),
    Notation("elastic", "", "", "1", "J", "energy stored in bodies and springs"),
    Notation("potential", "", "", "1", "J", "potential energy of the weight"),
    Notation("power_dissipated", "", "", "1", "W", "power lost in dampers, at least zero"),
    Notation("power_applied", "", "", "1", "W", "power of the loads"),
    Notation("measures", "", "", "measures", "mixed", "measures of the scene and their rates"),
    Notation(
        "acceleration_measures",
        "",
        "",
        "acceleration measures",
        "mixed",
        "measures that follow from accelerations: stresses of beams with a normal force by equilibrium",
    ),
    Notation("events", "", "", "events", "any", "values of the scene's events, which happen where they pass zero"),
    Notation("actions", "", "", "actions", "SI", "values that inputs get by events, event by event"),
    Notation("switching", "", "", "conditions in t", "SI", "zero where a load or a prescribed motion jumps or kinks"),
    Notation(
        "poses", "", "", "12 x bodies", "m, 1", "origin, then columns of the rotation matrix, of each body that moves"
    ),
    Notation("positions", "", "", "3 x points", "m", "drawn points in body axes"),
    Notation("axes", "", "", "9 x points", "1", "columns of the rotation matrix of the marker at a drawn point"),
    Notation("shapes", "", "", "3 x modes", "1", "displacement of a drawn point by each mode of its body"),
    Notation("turns", "", "", "3 x modes", "1/m", "rotation at a drawn point by each mode of its body"),
    Notation("H", "", "", "1 x entries", "1/m", "foreshortening of the drawn points that have it, nf x nf each"),
    Notation("sections", "", "", "2 x beams", "m", "height and width of a rectangle that stands for a beam's section"),
    Notation("rigidities", "", "", "2 x beams", "N m^2", "E I of a beam for bending along y and along z"),
    Notation("bounded", "", "", "expressions", "SI", "expressions of the scene that must keep their sign"),
)

BY_NAME = {entry.code: entry for entry in SYMBOLS}


def table(entries: tuple[Notation, ...]) -> str:
    """Names as a Markdown table (docs/theory/names.md holds it; a test compares)."""
    lines = ["| code | paper | Eq. | shape | unit | meaning |", "|---|---|---|---|---|---|"]
    for entry in entries:
        paper, equation = entry.paper and f"`{entry.paper}`", entry.equation and f"({entry.equation})"
        lines.append(f"| `{entry.code}` | {paper} | {equation} | {entry.shape} | {entry.unit} | {entry.meaning} |")
    return "\n".join(lines)
