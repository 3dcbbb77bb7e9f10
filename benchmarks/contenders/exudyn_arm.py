"""The hanging arm of benchmarks/scenes/arm.py in Exudyn: rigid links, the last one of ANCF cable elements."""

from __future__ import annotations

import time
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np

from benchmarks.contenders.exudyn_models import exudyn
from benchmarks.scenes.arm import LENGTH, MASS

GRAVITY = 9.81
DENSITY, AREA, SECOND_MOMENT, MODULUS = 7800.0, 2e-5, 1e-11, 2e11  # of the last link


@dataclass(frozen=True)
class ExudynArm:
    """angles (N,) of the links at the start [rad], at rest; the last link has so many cable elements.

    stiffening: factor on its modulus. rho_inf: spectral radius of generalized-alpha; None: trapezoidal rule, index 2.
    newton: relative tolerance of its iteration, which at Exudyn's default of 1e-8 fails on arms of more than 8 links.
    """

    angles: tuple[float, ...]
    stiffening: float
    elements: int = 2
    rho_inf: float | None = None
    sparse: bool = False
    newton: float = 1e-6

    @property
    def label(self) -> str:
        """What reports call it."""
        solver = "trapezoidal, index 2" if self.rho_inf is None else f"generalized-alpha {self.rho_inf:g}"
        sparse = ", sparse" if self.sparse else ""
        return f"Exudyn, {self._body}, {solver}{sparse}, Newton to {self.newton:g}"

    @property
    def _body(self) -> str:
        return f"{self.elements} cable elements"

    @cached_property
    def system(self) -> tuple[Any, Any, list[int]]:
        """(container, assembled system, sensors of the angles of the rigid links)."""
        core, items = exudyn()
        container = core.SystemContainer()
        mbs = container.AddSystem()
        before = mbs.AddMarker(items.MarkerBodyPosition(bodyNumber=mbs.AddObject(items.ObjectGround())))
        place, sensors = np.zeros(2), []
        for angle in self.angles[:-1]:
            along = LENGTH * np.array([np.cos(angle), np.sin(angle)])
            node = mbs.AddNode(items.NodeRigidBody2D(referenceCoordinates=[*(place + along / 2), angle]))
            body = mbs.AddObject(
                items.ObjectRigidBody2D(nodeNumber=node, physicsMass=MASS, physicsInertia=MASS * LENGTH**2 / 12)
            )
            start, end = (
                mbs.AddMarker(items.MarkerBodyPosition(bodyNumber=body, localPosition=[x, 0, 0]))
                for x in (-LENGTH / 2, LENGTH / 2)
            )
            mbs.AddObject(items.RevoluteJoint2D(markerNumbers=[before, start]))
            middle = mbs.AddMarker(items.MarkerBodyPosition(bodyNumber=body))
            mbs.AddLoad(items.LoadForceVector(markerNumber=middle, loadVector=[0, -MASS * GRAVITY, 0]))
            sensors.append(
                mbs.AddSensor(
                    items.SensorNode(
                        nodeNumber=node, storeInternal=True, outputVariableType=core.OutputVariableType.Coordinates
                    )
                )
            )
            before, place = end, place + along
        first = self._last_link(mbs, items, place)
        mbs.AddObject(
            items.RevoluteJoint2D(markerNumbers=[before, mbs.AddMarker(items.MarkerNodePosition(nodeNumber=first))])
        )
        mbs.Assemble()
        return container, mbs, sensors

    def _last_link(self, mbs: Any, items: Any, place: np.ndarray) -> int:
        """The last link from a place on; its first node."""
        slope = np.array([np.cos(self.angles[-1]), np.sin(self.angles[-1])])
        size = LENGTH / self.elements
        nodes = [
            mbs.AddNode(items.NodePoint2DSlope1(referenceCoordinates=[*(place + k * size * slope), *slope]))
            for k in range(self.elements + 1)
        ]
        for pair in pairwise(nodes):
            cable = mbs.AddObject(
                items.ObjectANCFCable2D(
                    nodeNumbers=list(pair),
                    physicsLength=size,
                    physicsMassPerLength=DENSITY * AREA,
                    physicsBendingStiffness=MODULUS * self.stiffening * SECOND_MOMENT,
                    physicsAxialStiffness=MODULUS * self.stiffening * AREA,
                )
            )
            mass = mbs.AddMarker(items.MarkerBodyMass(bodyNumber=cable))
            mbs.AddLoad(items.LoadMassProportional(markerNumber=mass, loadVector=[0, -GRAVITY, 0]))
        return int(nodes[0])

    def run(self, t_end: float, steps: int, samples: int = 0) -> tuple[float, np.ndarray]:
        """(CPU seconds, (samples + 1, N - 1) angles of the rigid links from the start on). Raises RuntimeError."""
        core, _ = exudyn()
        _, mbs, sensors = self.system
        settings = core.SimulationSettings()
        settings.parallel.numberOfThreads = 1
        settings.solution.file.write = False
        settings.solution.sensors.active = samples > 0
        settings.solution.sensors.writePeriod = t_end / max(1, samples)
        settings.linearSolver.reuseAnalyzedPattern = self.sparse
        solvers = core.LinearSolverType
        settings.linearSolver.solverType = solvers.EigenSparse if self.sparse else solvers.EXUdense
        integration = settings.timeIntegration
        integration.endTime, integration.numberOfSteps, integration.verboseMode = t_end, steps, 0
        integration.newton.useModifiedNewton, integration.adaptiveStep = True, False
        integration.newton.relativeTolerance = self.newton
        integration.solverType = core.DynamicSolverType.TrapezoidalIndex2
        if self.rho_inf is not None:
            integration.solverType = core.DynamicSolverType.GeneralizedAlpha
            integration.generalizedAlpha.spectralRadius = self.rho_inf
        began = time.thread_time()
        done = mbs.SolveDynamic(settings, storeSolver=False)
        seconds = time.thread_time() - began
        if not done:
            raise RuntimeError(f"{self.label} did not finish {steps} steps")
        told = [np.array(mbs.GetSensorStoredData(one))[:, 3] for one in sensors] if samples else []
        return seconds, np.array(told).T
