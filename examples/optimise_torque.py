"""Minimum-effort rest-to-rest swing of a hub with a flexible beam: a generated model in a CasADi Opti problem.

Trapezoidal collocation; the torque, the input u, is a decision variable.
"""

import sys
from pathlib import Path

import casadi as ca
from matplotlib.figure import Figure

from runtime import Model
from symgen import Scene

T_END, ANGLE = 1.5, 1.0  # s, rad


def build():
    """A hub in the horizontal plane with a 1 m aluminium beam."""
    builder = Scene("arm").input("torque", 0.0, "N m").rigid("hub", mass=1.0, inertia=0.02).beam(
        "beam", length=1.0, density=2700.0, area=4e-5, second_moment=1.3e-11, youngs_modulus=7e10,
        lateral={"ends": "clamped-free", "modes": 2})
    builder.revolute("pivot", "ground.origin", "hub.origin").weld("clamp", "hub.origin", "beam.start")
    return builder.torque("motor", "hub.origin", "torque").independent("hub.theta", "beam.q1", "beam.q2").build()


def residual(model: Model, q: ca.MX, v: ca.MX, a: ca.MX, torque: ca.MX) -> ca.MX:
    """M_hat a - Q_hat at (q_i, q_i_dot, q_i_ddot), through q_d and q_d_dot (a tree: in closed form)."""
    p = [entry.default for entry in model.description.parameters]
    values = {"q_i": q, "q_i_dot": v, "t": 0, "u": torque, "p": p}
    for key, name in (("q_d", "closure"), ("q_d_dot", "velocities"), ("M_hat", "condensed")):
        function = model.function(name)  # unused arguments were dropped when the function was emitted
        values[key], *rest = function.call([values[given] for given in function.name_in()])
    return ca.mtimes(values["M_hat"], a) - rest[0]  # rest of condensed: Q_hat


def main(picture: Path | None = None, intervals: int = 60) -> None:
    """IPOPT solves it with exact second derivatives."""
    model = build().model()
    n, h, opti = len(model.q_i), T_END / intervals, ca.Opti()
    q, v, a, u = (opti.variable(rows, intervals + 1) for rows in (n, n, n, 1))
    opti.subject_to(ca.horzcat(*(residual(model, q[:, k], v[:, k], a[:, k], u[k]) for k in range(intervals + 1))) == 0)
    for x, rate in ((q, v), (v, a)):
        opti.subject_to(x[:, 1:] == x[:, :-1] + h / 2 * (rate[:, 1:] + rate[:, :-1]))
    opti.subject_to(ca.vertcat(q[:, 0], v[:, 0], v[:, -1], q[:, -1]) == ca.vertcat(ca.DM.zeros(3 * n), ANGLE, 0, 0))
    opti.minimize(h * (ca.sumsqr(u) - (u[0] ** 2 + u[-1] ** 2) / 2))
    opti.solver("ipopt", {"print_time": False}, {"print_level": 0, "sb": "yes"})
    solution = opti.solve()
    print(solution.stats()["return_status"], f"effort {solution.value(opti.f):.6f} N^2 m^2 s")
    for k in range(0, intervals + 1, intervals // 4):
        print(f"t = {k * h:.3f} s   theta {solution.value(q[0, k]):.4f} rad   torque {solution.value(u[k]): .4f} N m")
    if picture:
        ax = (figure := Figure(figsize=(8, 3.5), layout="constrained", dpi=120)).subplots()
        times = [k * h for k in range(intervals + 1)]
        ax.plot(times, ca.DM(solution.value(u)).full().ravel(), label="torque [N m]")
        ax.plot(times, ca.DM(solution.value(q[0, :])).full().ravel(), label="angle of the hub [rad]")
        ax.plot(times, 10 * ca.DM(solution.value(q[1, :])).full().ravel(), label="10 x deflection of the tip [m]")
        ax.set(xlabel="time [s]", title="from rest to rest with the least torque")
        ax.legend(frameon=False)
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
