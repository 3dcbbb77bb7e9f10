"""The symbol table of z, the state of a time stepping scheme as one vector: what each of its fields is."""

from __future__ import annotations

from symgen.notation.symbols import Notation

# The fields of z of steps that follow from a tolerance: code, shape, unit, meaning.
FIELDS_OF_TOLERANCE = (
    ("q_from", "n_i", "mixed", "q_i at the start of a step whose length follows from a tolerance"),
    ("v_from", "n_i", "mixed", "q_i_dot there"),
    ("loop_from", "loops", "mixed", "loop unknowns there"),
    ("t_from", "1", "s", "time there"),
    ("a_from", "n_i", "mixed", "q_i_ddot there"),
    ("q_to", "n_i", "mixed", "q_i at its end"),
    ("v_to", "n_i", "mixed", "q_i_dot there"),
    ("loop_to", "loops", "mixed", "loop unknowns there"),
    ("t_to", "1", "s", "time there"),
    ("a_to", "n_i", "mixed", "q_i_ddot there"),
    ("loop_dot_to", "loops", "mixed", "rates of the loop unknowns there"),
    ("X", "n_i x n_s", "SI", "M_hat^-1 B at the start of the step"),
    ("b1", "n_i", "mixed", "accelerations beside the stiff part: a_from + b1 tau + b2 tau^2 / 2"),
    ("b2", "n_i", "mixed", "their second derivative"),
    ("q_low", "n_i", "mixed", "smallest q_i so far, at the ends of steps"),
    ("q_high", "n_i", "mixed", "largest q_i so far"),
    ("q_seen", "n_i", "mixed", "q_i that ranges are told of, at the end of the last step, where turns have charts"),
    ("weight", "n_i", "mixed", "what squares of estimated errors are multiplied by"),
    ("range_limit", "1", "1", "weighted squares of the ranges from which on weights are formed anew"),
    ("range_grew", "1", "1", "positive where the ranges have come so far"),
    ("q_error", "n_i", "mixed", "estimated error of q_to"),
    ("v_error", "n_i", "mixed", "estimated error of v_to"),
    ("h_next", "1", "s", "step that the error allows"),
    ("h_try", "1", "s", "step to try, shorter before a time of `breakpoints`"),
    ("t_try", "1", "s", "time at its end"),
    ("t_bound", "1", "s", "time that it must not cross"),
    ("error_peak", "1", "1", "square of the largest estimated error over the tolerance lately"),
    ("needs_judgement", "1", "1", "positive where the last attempt has to be judged"),
    ("before_attempt", "mixed", "mixed", "closure_error and determinants before the last attempt"),
    ("accepted", "1", "1", "positive where the last step was accepted, so that the next one begins at its end"),
    ("restart", "1", "1", "positive where its start is to be evaluated anew"),
    ("remaining", "1", "s", "way to the time that is to be seen, while steps can be made"),
    ("breakpoints", "4", "s", "next times that no step crosses"),
    ("side_offset", "1", "s", "how far from them forces are evaluated"),
    ("on_output", "1", "1", "positive where steps end on every state that is seen"),
    ("closure_limit", "n_loop > 0", "m or rad", "C of a loop before the last Newton step up to which a step is taken"),
    ("closure_missed", "n_loop > 0", "m or rad", "the largest C of a loop in the step that was tried"),
    ("min_step_hit", "1", "1", "positive where the least step did not meet the tolerance"),
    ("accepted_steps", "1", "1", "accepted steps so far"),
    ("counted_steps", "1", "1", "those that h_least and h_largest tell of"),
    ("rejected_steps", "1", "1", "rejected steps so far"),
    ("h_least", "1", "s", "shortest accepted step so far"),
    ("h_largest", "1", "s", "longest accepted step so far"),
    ("det_now", "loop blocks", "SI", "det_loop of the last accepted evaluation"),
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
        "event_values", "", "", "events", "any", "what passes zero at events and kinks, at the end of the last step"
    ),
    Notation("event_step", "", "", "1", "1", "the first step in which an event happened, since it was last looked"),
    Notation("event_before", "", "", "events", "any", "the same at its start, of steps that vary"),
    Notation("event_change", "", "", "events", "any", "by what values changed in the last step"),
    Notation("event_near", "", "", "1", "-", "may a value come to zero soon?"),
    Notation("event_slopes", "", "", "events", "any/s", "their rates where one may, of steps of one length"),
    Notation("side", "", "", "n_side", "-", "sides of jumps by the motion that the step from here holds, or 0"),
    Notation("side_before", "", "", "n_side", "-", "those that the step held which led here"),
    Notation("event_quiet", "", "", "events", "s", "until when an event is not looked for: its cool-down"),
    Notation("det_low", "", "", "loop blocks", "SI", "smallest det_loop since whoever runs the scheme reset it"),
    Notation("det_high", "", "", "loop blocks", "SI", "largest det_loop since then"),
    *(Notation(code, "", "", *rest) for code, *rest in FIELDS_OF_TOLERANCE),
    # single_rate, printed; a, s, loop_old and loop_dot also coupled
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
    Notation("loop_bend", "", "", "loops", "mixed", "their second rates at the start of the major step"),
    Notation(
        "chart", "", "", "4 x orientations", "1", "unit quaternions from which turns in x and loop unknowns count"
    ),
    # one-step schemes
    Notation("v", "q_i'", "36", "n_i", "mixed", "q_i_dot reached"),
    # coupled
    Notation(
        "hold_q", "", "", "n_i", "mixed", "where slow coordinates are held: ahead, at the middle of the sub-steps"
    ),
    Notation("x_last", "", "", "n_i", "mixed", "x at the last hold: the secant's other end"),
    Notation("v_last", "", "", "n_i", "mixed", "v at the last hold"),
    Notation("a_middle", "", "", "n_i", "mixed", "q_i_ddot seen in the middle of the last step"),
    Notation("a_before", "", "", "n_i", "mixed", "q_i_ddot at the start of the last step"),
    Notation("s_middle", "", "", "n_s", "mixed", "stiff deflections in the middle of the last step"),
    Notation("s_middle_dot", "", "", "n_s", "mixed", "their rates there"),
    Notation("s_before", "", "", "n_s", "mixed", "stiff deflections at the start of the last step"),
    Notation("s_before_dot", "", "", "n_s", "mixed", "their rates there"),
    Notation("loop_third", "", "", "loops", "mixed", "third rates of the loop unknowns in the last step"),
    # exponential; M and lu_k also radau
    Notation("w", "", "", "n_i", "mixed", "q_i - x since the start of the major step"),
    Notation("u", "", "", "n_i", "mixed", "q_i_dot at the sub-step"),
    Notation("tau", "", "", "1", "s", "time since the start of the major step"),
    Notation("G0", "", "", "n_i", "N, N m", "force on the linear system: G0 + G1 tau + G2 tau^2 / 2 + G3 tau^3 / 6"),
    Notation("G1", "", "", "n_i", "N/s, N m/s", "its first derivative at the start"),
    Notation("G2", "", "", "n_i", "N/s^2, N m/s^2", "its second derivative"),
    Notation("G3", "", "", "n_i", "N/s^3, N m/s^3", "its third derivative"),
    Notation("M", "M^", "38", "non-zeros", "SI", "M_hat of the linear system"),
    Notation("J_q", "", "", "non-zeros", "SI", "J_q of the linear system"),
    Notation("J_v", "", "", "non-zeros", "SI", "J_v of the linear system"),
    Notation("lu_0", "", "", "non-zeros", "SI", "factors of r^2 M - r h J_v - h^2 J_q for the real r"),
    Notation("lu_1", "", "", "2 x non-zeros", "SI", "the same for the complex r, real parts first"),
    # radau
    Notation("K", "", "", "3 x n_i", "mixed", "accelerations of the three stages"),
    Notation("loop_stages", "", "", "3 x loops", "mixed", "loop unknowns of the stages"),
    Notation("loop_last", "", "", "loops", "mixed", "loop unknowns at the start of the last step"),
    Notation("stage_error", "", "", "1", "m, rad", "largest C_loop of the stages"),
    Notation("eta", "", "", "1", "1", "theta / (1 - theta), theta the ratio of two corrections"),
    Notation("correction", "", "", "1", "mixed", "largest entry of the last correction"),
)
