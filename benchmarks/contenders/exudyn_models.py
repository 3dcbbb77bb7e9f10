"""The flexible slider-crank in Exudyn: its rod as ANCF cable elements, which are geometrically exact.

Exudyn is imported on first use and nowhere else; it is the extra `benchmark`.
"""

from __future__ import annotations

import importlib.util
import sys
import time
import warnings
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from symgen.scenes.flexible_slider_crank import J1, L1, L2, M1, M3, RHO, WIDTH, E

SPEED = 150.0  # rad/s
AXIAL_STIFFNESS, BENDING_STIFFNESS, LINE_MASS = E * WIDTH**2, E * WIDTH**4 / 12, RHO * WIDTH**2


def is_installed() -> bool:
    """Can Exudyn be imported?"""
    return importlib.util.find_spec("exudyn") is not None


def exudyn() -> tuple[Any, Any]:
    """(exudyn, exudyn.itemInterface), built without range checks where the processor allows it."""
    sys.exudynFast = True  # type: ignore[attr-defined]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        import exudyn as core
        import exudyn.itemInterface as items
    core.config.printToConsole = False  # runs that fail say so by an error
    return core, items


def version() -> str:
    """Of Exudyn."""
    return str(exudyn()[0].config.Version())


def stretch(s: float) -> list[float]:
    """ANCF coordinates of the rod's point s [m] in elastic equilibrium along its axis, crank angle 0.

    There all accelerations lie along the rod, w^2 (L1 + L1^2 s / L2^2) towards the crank, so that u' = tension / EA.
    """
    near, slope = SPEED**2 * L1, (SPEED * L1 / L2) ** 2
    end = M3 * (near + slope * L2)
    tension = end + LINE_MASS * (near * (L2 - s) + slope / 2 * (L2**2 - s**2))
    integral = end * s + LINE_MASS * (near * (L2 * s - s**2 / 2) + slope / 2 * (L2**2 * s - s**3 / 3))
    return [integral / AXIAL_STIFFNESS, 0.0, tension / AXIAL_STIFFNESS, 0.0]


@dataclass(frozen=True)
class Cable:
    """The mechanism with so many cable elements (an even number: a node is in the middle) and a solver's settings.

    rho_inf: spectral radius of generalized-alpha (index 3); None is the trapezoidal rule with index 2.
    """

    elements: int
    rho_inf: float | None = None
    modified_newton: bool = True
    sparse: bool = False
    newton_tolerance: float = 1e-8  # relative, Exudyn's default

    @property
    def label(self) -> str:
        """What reports call it."""
        solver = "trapezoidal, index 2" if self.rho_inf is None else f"generalized-alpha {self.rho_inf:g}"
        extra = ("" if self.modified_newton else ", full Newton") + (", sparse" if self.sparse else "")
        extra += "" if self.newton_tolerance == 1e-8 else f", Newton to {self.newton_tolerance:g}"
        return f"Exudyn, {self.elements} cable elements, {solver}{extra}"

    @cached_property
    def system(self) -> tuple[Any, Any, int]:
        """(container, assembled system, sensor of the rod's middle)."""
        core, items = exudyn()
        container = core.SystemContainer()
        mbs = container.AddSystem()
        ground = mbs.AddMarker(items.MarkerBodyPosition(bodyNumber=mbs.AddObject(items.ObjectGround())))
        hub = mbs.AddNode(
            items.NodeRigidBody2D(referenceCoordinates=[L1 / 2, 0, 0], initialVelocities=[0, SPEED * L1 / 2, SPEED])
        )
        crank = mbs.AddObject(
            items.ObjectRigidBody2D(nodeNumber=hub, physicsMass=M1, physicsInertia=J1 - M1 * (L1 / 2) ** 2)
        )
        root, tip = (
            mbs.AddMarker(items.MarkerBodyPosition(bodyNumber=crank, localPosition=[x, 0, 0]))
            for x in (-L1 / 2, L1 / 2)
        )
        nodes = [mbs.AddNode(self._node(items, k)) for k in range(self.elements + 1)]
        for pair in zip(nodes, nodes[1:], strict=False):
            mbs.AddObject(
                items.ObjectANCFCable2D(
                    nodeNumbers=list(pair),
                    physicsLength=L2 / self.elements,
                    physicsMassPerLength=LINE_MASS,
                    physicsBendingStiffness=BENDING_STIFFNESS,
                    physicsAxialStiffness=AXIAL_STIFFNESS,
                )
            )
        mbs.AddObject(items.ObjectMassPoint2D(nodeNumber=nodes[-1], physicsMass=M3))
        start = mbs.AddMarker(items.MarkerNodePosition(nodeNumber=nodes[0]))
        mbs.AddObject(items.RevoluteJoint2D(markerNumbers=[ground, root]))
        mbs.AddObject(items.RevoluteJoint2D(markerNumbers=[tip, start]))
        fixed = mbs.AddMarker(items.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(items.NodePointGround()), coordinate=0))
        height = mbs.AddMarker(items.MarkerNodeCoordinate(nodeNumber=nodes[-1], coordinate=1))
        mbs.AddObject(items.CoordinateConstraint(markerNumbers=[fixed, height]))
        sensor = mbs.AddSensor(
            items.SensorNode(
                nodeNumber=nodes[self.elements // 2],
                storeInternal=True,
                outputVariableType=core.OutputVariableType.Position,
            )
        )
        mbs.Assemble()
        return container, mbs, sensor

    def _node(self, items: Any, k: int) -> Any:
        s = k / self.elements
        return items.NodePoint2DSlope1(
            referenceCoordinates=[L1 + s * L2, 0, 1, 0],
            initialCoordinates=stretch(s * L2),
            initialVelocities=[0, SPEED * L1 * (1 - s), 0, -SPEED * L1 / L2],
        )

    def middle(self, t_end: float, steps: int, period: float) -> tuple[np.ndarray, np.ndarray]:
        """(times, positions of the rod's middle) every `period` seconds, or every step. Raises RuntimeError."""
        self.solve(self.settings(t_end, steps, max(period, t_end / steps)))
        _, mbs, sensor = self.system
        data = np.array(mbs.GetSensorStoredData(sensor))
        return data[:, 0], data[:, 1:3]

    def solve(self, settings: Any) -> float:
        """Run from the initial state; CPU seconds. Raises RuntimeError if the solver gives up."""
        mbs = self.system[1]
        started = time.thread_time()
        done = mbs.SolveDynamic(settings, storeSolver=False)
        seconds = time.thread_time() - started
        if not done:
            raise RuntimeError(f"{self.label} did not finish")
        return seconds

    def settings(self, t_end: float, steps: int, period: float | None = None) -> Any:
        """One thread, no files, no screen output; without a period no sensor stores anything."""
        core, _ = exudyn()
        settings = core.SimulationSettings()
        settings.parallel.numberOfThreads = 1
        settings.solution.file.write = False
        settings.solution.sensors.active = period is not None
        settings.solution.sensors.writePeriod = period or t_end
        settings.linearSolver.reuseAnalyzedPattern = self.sparse
        settings.linearSolver.solverType = (
            core.LinearSolverType.EigenSparse if self.sparse else core.LinearSolverType.EXUdense
        )
        integration = settings.timeIntegration
        integration.endTime, integration.numberOfSteps, integration.verboseMode = t_end, steps, 0
        integration.newton.useModifiedNewton = self.modified_newton
        integration.newton.relativeTolerance = self.newton_tolerance
        solvers = core.DynamicSolverType
        integration.solverType = solvers.TrapezoidalIndex2
        if self.rho_inf is not None:
            integration.solverType = solvers.GeneralizedAlpha
            integration.generalizedAlpha.spectralRadius = self.rho_inf
        return settings
