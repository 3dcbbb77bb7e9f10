"""The symbol table: names of the code, symbols of the paper. Read this file second, after pipeline.py.

Names follow the paper. A velocity ends in `_dot`, an acceleration in `_ddot`; q_d is *dependent*, never a velocity.
L and S name the step size (large, small), not rigid and elastic: which coordinate is in which group is data.
Shapes: n coordinates, n_i independent, n_d dependent, n_c constraint rows, nf modes of a body, n_p parameters,
n_S and n_L in the groups that take a sub-step and in slower ones.

SYMBOLS are the names of the equations and of the emitted functions, FIELDS those of z, the state of a time stepping
scheme as one vector.
"""

from __future__ import annotations

from dataclasses import dataclass

from runtime.contract.tolerance_fields import FIELDS_OF_TOLERANCE


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
    Notation("theta", "theta", "17", "1, 3 or 4", "rad", "angle of a body's frame; Euler angles or parameters e"),
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
    Notation("gamma_b", "gamma", "28", "n_c", "m/s^2, rad/s^2", "gamma with Baumgarte terms"),
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
    Notation("N", "", "", "n_L x n_S", "SI", "M_hat_LL^-1 M_hat_LS: what q_L does when q_S is pushed"),
    Notation("y_ddot", "", "", "n_L", "mixed", "acceleration of q_L + N q_S, M_hat_LL^-1 Q_hat_L"),
    Notation("M_bar_SS", "", "", "n_S x n_S", "SI", "M_hat_SS - M_hat_SL N: inertia of q_S with q_L free"),
    Notation(
        "crossing", "", "", "n_X (1 + n_S)", "mixed", "q'' that the rows of q_S see: of forces, of each unit q_S''"
    ),
    Notation("trunk_ddot", "", "", "n_L", "mixed", "q_L'' of the bodies that carry the fast ones, these not pushing"),
    Notation("X_trunk", "", "", "n_L x n_u", "SI", "what phi adds to it"),
    Notation(
        "interface", "", "", "n_u (1 + n_u)", "mixed", "q'' with which the branches are carried: free, by each phi"
    ),
    Notation("branch_ddot", "", "", "n_L", "mixed", "q_L'' of the branches; zero for the bodies that carry them"),
    Notation("q_S_ddot", "q_S''", "64", "n_S", "mixed", "accelerations of the fast coordinates"),
    Notation("phi", "", "", "n_u", "N, N m", "forces of the branches on the bodies that carry them"),
    Notation("B", "", "", "n_i x n_s", "1", "stiff deflections s = B^T q_i: modes, springs between coordinates"),
    Notation("K_s", "", "", "n_s x n_s", "SI", "stiffness of the stiff deflections"),
    Notation("D_s", "", "", "n_s x n_s", "SI", "damping of the stiff deflections"),
    Notation("X", "", "", "n_i x n_s", "SI", "M_hat^-1 B: accelerations by forces along the stiff deflections"),
    Notation(
        "shift", "", "", "4", "s^2, s", "kappa and delta of M_hat + B (kappa K_s + delta D_s) B^T, real parts first"
    ),
    Notation("push", "", "", "2 n_s", "SI", "forces along the stiff deflections, real parts first"),
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
        "3, 6 or 7 x loads",
        "N, N m",
        "force of a load on the frame of a flexible body",
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

FIELDS: tuple[Notation, ...] = (
    # common to all schemes
    Notation("t0", "", "", "1", "s", "time at the start of the run"),
    Notation("n", "", "", "1", "1", "major steps done"),
    Notation(
        "x",
        "q_i",
        "38",
        "n_i",
        "mixed",
        "q_i reached: of fast groups at their sub-step, of slow ones at their step's end",
    ),
    Notation("loop", "q_d", "31", "loops", "mixed", "guess of the loop unknowns"),
    Notation(
        "inputs", "", "", "numbers of inputs", "SI", "the numbers that the inputs u are made of, as they are held"
    ),
    Notation("closure_error", "", "", "1", "m, rad", "largest C_loop so far"),
    Notation("iterations", "", "", "1", "1", "sweeps or Newton iterations done"),
    Notation("failures", "", "", "1", "1", "steps whose iteration did not converge"),
    Notation(
        "power_sum",
        "",
        "",
        "1",
        "W",
        "sum of the powers of loads, dampers and drives, one a step; times the step it is their work",
    ),
    Notation("power", "", "", "1", "W", "the last of them"),
    Notation("power_change", "", "", "1", "W", "its difference to the one before"),
    Notation("power_bends", "", "", "1", "W", "sum of the magnitudes of their second differences"),
    Notation("power_mid", "", "", "1", "W", "power at the midpoint of a step"),
    Notation(
        "work", "", "", "1", "J", "work of loads, dampers and drives until the state that is seen, of steps that vary"
    ),
    Notation("work_from", "", "", "1", "J", "the same at the start of the running step"),
    Notation("power_to", "", "", "1", "W", "power at the end of the last step"),
    Notation("pending", "", "", "1", "s", "length of an accepted step whose work is not in work_from yet"),
    Notation("bends", "", "", "1", "J", "sum of the differences of Simpson's and the trapezoidal rule"),
    Notation("event_values", "", "", "events", "any", "what passes zero at events, at the end of the last step"),
    Notation("event_step", "", "", "1", "1", "the first step in which an event happened, since it was last looked"),
    Notation("turn", "", "", "1", "rad", "largest turn of Euler angles in a step near their singular orientation"),
    Notation("angles_before", "", "", "2 a body", "rad", "first and third Euler angle after the last step"),
    Notation("det_low", "", "", "loop blocks", "SI", "smallest det_loop since whoever runs the scheme reset it"),
    Notation("det_high", "", "", "loop blocks", "SI", "largest det_loop since then"),
    *(Notation(code, "", "", *rest) for code, *rest in FIELDS_OF_TOLERANCE),
    # single_rate, printed; a, s, loop_old and loop_dot also coupled, decoupled
    Notation("d", "q^t - q^(t-Delta t)", "40-43", "n_i", "mixed", "last increment, stored instead of the last point"),
    Notation("a", "q_i''", "40-43", "n_i", "mixed", "last q_i_ddot"),
    Notation("s", "(j-1) Delta t_S", "63", "1", "s", "time since the start of the running major step"),
    Notation("q_L", "q_L", "63", "n_i", "mixed", "slow coordinates at the start of their running step"),
    Notation("q_L_dot", "q_L'", "60", "n_i", "mixed", "their rates there"),
    Notation("q_L_ddot", "q_L''", "59", "n_i", "mixed", "their accelerations there"),
    Notation("t_L", "", "", "groups", "s", "start of each group's running step, since that of the major step"),
    Notation("unconverged", "", "", "1", "1", "positive until the iteration of a step has converged"),
    Notation("change", "", "", "groups", "mixed", "largest change of q_ddot of each group by the last sweep"),
    Notation("loop_old", "", "", "loops", "mixed", "loop unknowns one finest step ago"),
    Notation("loop_dot", "q_d'", "36", "loops", "mixed", "rates of the loop unknowns"),
    Notation(
        "chart", "", "", "4 x orientations", "1", "unit quaternions from which the turns in x are rotation vectors"
    ),
    # one-step schemes
    Notation("v", "q_i'", "36", "n_i", "mixed", "q_i_dot reached"),
    # coupled, decoupled
    Notation(
        "hold_q", "", "", "n_i", "mixed", "where slow coordinates are held: ahead, at the middle of the sub-steps"
    ),
    Notation("x_last", "", "", "n_i", "mixed", "x at the last hold: the secant's other end"),
    Notation("v_last", "", "", "n_i", "mixed", "v at the last hold"),
    Notation("hold_v", "", "", "n_i", "mixed", "rates there, as the rows of q_S of a large tree see them"),
    Notation("N", "", "", "n_L x n_S", "SI", "M_hat_LL^-1 M_hat_LS at the middle"),
    Notation("y_ddot", "", "", "n_L", "mixed", "acceleration of q_L + N q_S, M_hat_LL^-1 Q_hat_L"),
    Notation("y_last", "", "", "n_L", "mixed", "the y_ddot of the major step before"),
    Notation("y_before", "", "", "n_L", "mixed", "that of the one before"),
    Notation(
        "crossing", "", "", "n_X (1 + n_S)", "mixed", "accelerations that cross to the rows of q_S of a large tree"
    ),
    Notation("trunk_ddot", "", "", "n_L", "mixed", "q_L'' of the bodies that carry the branches with fast coordinates"),
    Notation("X_trunk", "", "", "n_L x n_u", "SI", "what forces phi of the branches add to it"),
    Notation(
        "interface", "", "", "n_u (1 + n_u)", "mixed", "q'' with which the branches are carried: free, by each phi"
    ),
    Notation("phi", "", "", "n_u", "N, N m", "forces of the branches at the last sub-step"),
    Notation("phi_sum", "", "", "n_u", "N, N m", "their sum over the sub-steps of the major step"),
    Notation("phi_sums", "", "", "n_u", "N, N m", "sum of those sums before each sub-step"),
    Notation("branch_sum", "", "", "n_B", "mixed", "sum of q_L'' of the branches' slow coordinates"),
    Notation("branch_sums", "", "", "n_B", "mixed", "sum of those sums before each sub-step"),
    # linearised, exponential; M and lu_k also radau
    Notation("w", "", "", "n_i", "mixed", "q_i - x since the start of the major step"),
    Notation("u", "", "", "n_i", "mixed", "q_i_dot at the sub-step"),
    Notation("tau", "", "", "1", "s", "time since the start of the major step"),
    Notation("G0", "", "", "n_i", "N, N m", "force on the linear system: G0 + G1 tau + G2 tau^2 / 2"),
    Notation("G1", "", "", "n_i", "N/s, N m/s", "its first derivative at the start"),
    Notation("G2", "", "", "n_i", "N/s^2, N m/s^2", "its second derivative"),
    Notation("M", "M^", "38", "non-zeros", "SI", "M_hat of the linear system"),
    Notation("J_q", "", "", "non-zeros", "SI", "J_q of the linear system"),
    Notation("J_v", "", "", "non-zeros", "SI", "J_v of the linear system"),
    Notation("lu_0", "", "", "non-zeros", "SI", "factors of r^2 M - r h J_v - h^2 J_q for the real r"),
    Notation("lu_1", "", "", "2 x non-zeros", "SI", "the same for the complex r, real parts first"),
    Notation(
        "acceleration", "", "", "n_i", "mixed", "w'' of the last sub-step, where sub-steps are central differences"
    ),
    Notation("x_start", "", "", "n_i", "mixed", "x at the start of the running step"),
    Notation("x_mid", "", "", "n_i", "mixed", "predicted q_i at the middle of the next step"),
    Notation("v_mid", "", "", "n_i", "mixed", "predicted q_i_dot there"),
    Notation("x_end", "", "", "n_i", "mixed", "last iterate of q_i at the end of the step"),
    Notation("v_end", "", "", "n_i", "mixed", "last iterate of q_i_dot there"),
    Notation("response", "", "", "n_i (1 + n_s)", "mixed", "its forces: accelerations without K and D, M_hat^-1 B"),
    # radau
    Notation("K", "", "", "3 x n_i", "mixed", "accelerations of the three stages"),
    Notation("loop_stages", "", "", "3 x loops", "mixed", "loop unknowns of the stages"),
    Notation("loop_last", "", "", "loops", "mixed", "loop unknowns at the start of the last step"),
    Notation("stage_error", "", "", "1", "m, rad", "largest C_loop of the stages"),
    Notation("eta", "", "", "1", "1", "theta / (1 - theta), theta the ratio of two corrections"),
    Notation("correction", "", "", "1", "mixed", "largest entry of the last correction"),
    # generalized_alpha, hht
    Notation("q", "q", "15", "n", "mixed", "all coordinates"),
    Notation("q_dot", "q'", "24", "n", "mixed", "their rates"),
    Notation("q_ddot", "q''", "25", "n", "mixed", "their accelerations"),
    Notation("q_ddot_old", "q''", "25", "n", "mixed", "those at the start of the running step"),
    Notation("a_alpha", "", "", "n", "mixed", "Arnold and Bruls's algorithmic acceleration"),
    Notation("lam", "lambda", "37", "kept rows", "N, N m", "multipliers"),
)


BY_NAME = {entry.code: entry for entry in SYMBOLS}


def table(entries: tuple[Notation, ...]) -> str:
    """Names as a Markdown table (docs/theory/names.md holds both; a test compares)."""
    lines = ["| code | paper | Eq. | shape | unit | meaning |", "|---|---|---|---|---|---|"]
    for entry in entries:
        paper, equation = entry.paper and f"`{entry.paper}`", entry.equation and f"({entry.equation})"
        lines.append(f"| `{entry.code}` | {paper} | {equation} | {entry.shape} | {entry.unit} | {entry.meaning} |")
    return "\n".join(lines)
