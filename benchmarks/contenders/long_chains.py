"""The hanging chain of rigid links, in a plane or in space, stepped by several programs in steps of one length.

Each maker builds the chain of N links and makes the first step; `advance(n)` makes n more. All take the classical
Runge-Kutta method, but Exudyn, whose explicit methods know no constraints: it takes generalized-alpha. Each maker
imports its own program, this project among them: what is imported is part of the time to the first step. The others are
the extra `benchmark`.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from runtime.model import Model
    from runtime.running.stepping import ModelStepper

GRAVITY, START, DT = 9.81, -1.2, 1e-4  # m/s^2, rad, s
LENGTH, MASS = 0.5, 0.078  # of a link in the plane
INERTIA = MASS * LENGTH**2 / 12  # about its centre
SPACE_LENGTH, SPACE_SIDE, SPACE_DENSITY = 0.2, 0.008, 2700.0
SPACE_MASS = SPACE_DENSITY * SPACE_SIDE**2 * SPACE_LENGTH
SPACE_ACROSS = SPACE_SIDE**2 / 12
SPACE_INERTIA = SPACE_MASS * np.array([2, 1, 1]) * SPACE_ACROSS + SPACE_MASS * SPACE_LENGTH**2 / 12 * np.array(
    [0, 1, 1]
)


@dataclass(frozen=True)
class ChainRun:
    """A chain after its first step. advance(n): n more; angles: absolute ones of the links now [rad], in a plane."""

    advance: Callable[[int], None]
    angles: Callable[[], np.ndarray]


def ours(links: int) -> ChainRun:
    """This project, `rk4`, steps as native code."""
    from symgen.scenes.pendulums import chain

    return _ours(chain(links).model())


def ours_in_space(links: int) -> ChainRun:
    """This project, spherical joints, `rk4`."""
    from symgen.scenes.spatial import spatial_chain

    return _ours(spatial_chain(links).model())


def _ours(model: Model) -> ChainRun:
    first = model.simulate(scheme="rk4", dt=DT, t_end=DT, error="off")
    if not first.status.ok:
        raise RuntimeError(str(first.status))
    stepper: list[ModelStepper] = []

    def advance(n: int) -> None:
        if not stepper:
            stepper.append(model.stepper(scheme="rk4", dt=DT, engine="compiled"))
            stepper[0].step()
        stepper[0].step(n=n)

    def angles() -> np.ndarray:
        state = stepper[0].state if stepper else first.initial_values()
        return np.array([state[name] for name in model.q_i])

    return ChainRun(advance, angles)


def mujoco(links: int) -> ChainRun:
    """MuJoCo, hinges."""
    return _mujoco(links, LENGTH, "mjJNT_HINGE", MASS, [INERTIA] * 3, [0, -GRAVITY, 0], START)


def mujoco_in_space(links: int) -> ChainRun:
    """MuJoCo, ball joints."""
    inertia = SPACE_INERTIA.tolist()
    return _mujoco(links, SPACE_LENGTH, "mjJNT_BALL", SPACE_MASS, inertia, [0, 0, -GRAVITY], None)


def _mujoco(
    links: int, length: float, joint: str, mass: float, inertia: list[float], gravity: list[float], start: float | None
) -> ChainRun:
    """By its records: XML may not be nested as deeply."""
    import mujoco as program

    spec = program.MjSpec()
    spec.option.timestep, spec.option.gravity = DT, gravity
    spec.option.integrator = program.mjtIntegrator.mjINT_RK4
    spec.option.disableflags = program.mjtDisableBit.mjDSBL_CONTACT | program.mjtDisableBit.mjDSBL_CONSTRAINT
    body = spec.worldbody
    for k in range(links):
        body = body.add_body(
            pos=[length if k else 0.0, 0, 0], mass=mass, ipos=[length / 2, 0, 0], inertia=inertia, explicitinertial=True
        )
        body.add_joint(type=getattr(program.mjtJoint, joint), axis=[0, 0, 1])
    model = spec.compile()
    data = program.MjData(model)
    if start is None:
        data.qvel[0] = 1.0
    else:
        data.qpos[0] = start
    program.mj_step(model, data)
    return ChainRun(lambda n: program.mj_step(model, data, nstep=n), lambda: np.cumsum(data.qpos))


def pinocchio(links: int) -> ChainRun:
    """Pinocchio, `aba` called from Python, the sums of the method by NumPy."""
    import pinocchio as program

    inertia = program.Inertia(MASS, np.array([LENGTH / 2, 0, 0]), np.diag([INERTIA] * 3))
    model = _pinocchio(program, links, LENGTH, program.JointModelRZ, inertia, np.array([0, -GRAVITY, 0]))
    q, v = np.zeros(links), np.zeros(links)
    q[0] = START
    return _by_aba(program, model, q, v)


def pinocchio_in_space(links: int) -> ChainRun:
    """Pinocchio, spherical joints."""
    import pinocchio as program

    inertia = program.Inertia(SPACE_MASS, np.array([SPACE_LENGTH / 2, 0, 0]), np.diag(SPACE_INERTIA))
    down = np.array([0, 0, -GRAVITY])
    model = _pinocchio(program, links, SPACE_LENGTH, program.JointModelSpherical, inertia, down)
    v = np.zeros(3 * links)
    v[0] = 1.0
    return _by_aba(program, model, program.neutral(model), v)


def _pinocchio(program: Any, links: int, length: float, joint: Any, inertia: Any, gravity: np.ndarray) -> Any:
    model, parent = program.Model(), 0
    model.gravity.linear = gravity
    for k in range(links):
        place = program.SE3(np.eye(3), np.array([length if k else 0.0, 0, 0]))
        parent = model.addJoint(parent, joint(), place, f"joint{k}")
        model.appendBodyToJoint(parent, inertia, program.SE3.Identity())
    return model


def _by_aba(program: Any, model: Any, q: np.ndarray, v: np.ndarray) -> ChainRun:
    data, rest, state = model.createData(), np.zeros(model.nv), [q, v]

    def slope(q: np.ndarray, v: np.ndarray) -> np.ndarray:
        return np.array(program.aba(model, data, q, v, rest))

    def advance(n: int) -> None:
        for _ in range(n):
            q, v = state
            a = slope(q, v)
            v2 = v + DT / 2 * a
            b = slope(program.integrate(model, q, DT / 2 * v), v2)
            v3 = v + DT / 2 * b
            c = slope(program.integrate(model, q, DT / 2 * v2), v3)
            v4 = v + DT * c
            d = slope(program.integrate(model, q, DT * v3), v4)
            state[:] = (
                program.integrate(model, q, DT / 6 * (v + 2 * v2 + 2 * v3 + v4)),
                v + DT / 6 * (a + 2 * b + 2 * c + d),
            )

    advance(1)
    return ChainRun(advance, lambda: np.cumsum(state[0]))


def numpy_and_scipy(links: int) -> ChainRun:
    """What one writes by hand: the full M of absolute angles, solved by SciPy's Cholesky factorisation."""
    from scipy.linalg import solve

    beyond = links - np.arange(links) - 0.5  # links that hang on the end of each, and half of its own
    shared = MASS * LENGTH**2 * np.minimum(beyond[:, None], beyond)  # of two links, that of the outer one
    np.fill_diagonal(shared, INERTIA + MASS * LENGTH**2 * (beyond - 0.25))
    weight = MASS * GRAVITY * LENGTH * beyond

    def slope(y: np.ndarray) -> np.ndarray:
        theta, rate = y
        apart = theta[:, None] - theta
        side = -weight * np.cos(theta) - (shared * np.sin(apart)) @ rate**2
        return np.array([rate, solve(shared * np.cos(apart), side, assume_a="pos")])

    state = [np.array([np.full(links, START), np.zeros(links)])]

    def advance(n: int) -> None:
        for _ in range(n):
            y = state[0]
            a = slope(y)
            b = slope(y + DT / 2 * a)
            c = slope(y + DT / 2 * b)
            state[0] = y + DT / 6 * (a + 2 * b + 2 * c + slope(y + DT * c))

    advance(1)
    return ChainRun(advance, lambda: state[0][0])


def exudyn_redundant(links: int) -> ChainRun:
    """Exudyn, three coordinates a link and two constraints a hinge, sparse, generalized-alpha 0.9."""
    from benchmarks.contenders.exudyn_models import exudyn

    core, items = exudyn()
    container = core.SystemContainer()
    mbs = container.AddSystem()
    before = mbs.AddMarker(items.MarkerBodyPosition(bodyNumber=mbs.AddObject(items.ObjectGround())))
    along, place, sensors = LENGTH * np.array([np.cos(START), np.sin(START)]), np.zeros(2), []
    for _ in range(links):
        node = mbs.AddNode(items.NodeRigidBody2D(referenceCoordinates=[*(place + along / 2), START]))
        body = mbs.AddObject(items.ObjectRigidBody2D(nodeNumber=node, mass=MASS, inertia=INERTIA))
        start, end = (
            mbs.AddMarker(items.MarkerBodyPosition(bodyNumber=body, localPosition=[x, 0, 0]))
            for x in (-LENGTH / 2, LENGTH / 2)
        )
        mbs.AddObject(items.RevoluteJoint2D(markerNumbers=[before, start]))
        middle = mbs.AddMarker(items.MarkerBodyPosition(bodyNumber=body))
        mbs.AddLoad(items.LoadForceVector(markerNumber=middle, loadVector=[0, -MASS * GRAVITY, 0]))
        sensors.append(node)
        before, place = end, place + along
    mbs.Assemble()
    settings = core.SimulationSettings()
    settings.parallel.numberOfThreads = 1
    settings.solution.file.write = False
    settings.linearSolver.solverType = core.LinearSolverType.EigenSparse
    settings.linearSolver.reuseAnalyzedPattern = True
    integration = settings.timeIntegration
    integration.verboseMode, integration.adaptiveStep = 0, False
    integration.newton.useModifiedNewton, integration.newton.relativeTolerance = True, 1e-6
    integration.generalizedAlpha.spectralRadius = 0.9
    done = [0]

    def advance(n: int) -> None:
        integration.startTime, integration.endTime, integration.numberOfSteps = done[0] * DT, (done[0] + n) * DT, n
        if not mbs.SolveDynamic(settings, solverType=core.DynamicSolverType.GeneralizedAlpha, updateInitialValues=True):
            raise RuntimeError(f"Exudyn did not finish {n} steps")
        done[0] += n

    def angles() -> np.ndarray:
        kind = core.OutputVariableType.Coordinates
        return START + np.array([mbs.GetNodeOutput(node, kind)[2] for node in sensors])

    advance(1)
    return ChainRun(advance, angles)


OURS = "this project"
IN_A_PLANE: dict[str, tuple[str, Callable[[int], ChainRun]]] = {  # name: (module that it needs, maker)
    OURS: ("runtime", ours),
    "MuJoCo": ("mujoco", mujoco),
    "Pinocchio": ("pinocchio", pinocchio),
    "Exudyn": ("exudyn", exudyn_redundant),
    "NumPy and SciPy": ("scipy", numpy_and_scipy),
}
IN_SPACE: dict[str, tuple[str, Callable[[int], ChainRun]]] = {
    OURS: ("runtime", ours_in_space),
    "MuJoCo": ("mujoco", mujoco_in_space),
    "Pinocchio": ("pinocchio", pinocchio_in_space),
}
FAMILIES = {"chain in a plane": IN_A_PLANE, "chain in space": IN_SPACE}


def installed(family: str) -> list[str]:
    """Programs of a family that can be imported."""
    return [name for name, (needs, _) in FAMILIES[family].items() if importlib.util.find_spec(needs) is not None]
