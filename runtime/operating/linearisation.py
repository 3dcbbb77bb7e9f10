"""A linear system about a state: its matrices, modes, responses and state-space forms."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from runtime.contract.errors import ModelError, NoResult
from runtime.contract.model import Model
from runtime.operating.modal import Modal, modal_analysis
from runtime.operating.mode_solver import State

if TYPE_CHECKING:
    from scipy.signal import StateSpace

COUPLED = 1e-7  # relative change of a frequency without an assumed mode that is more than rounding
UNDETERMINED = 1e-9  # share of a force, or of outputs, along motions that nothing resists
POOR_BASIS = 0.01  # change of a frequency without one assumed mode from which the basis is called poor


@dataclass(frozen=True, repr=False)
class Linearisation:
    """M x'' + D x' + K x = B u and y = C (x, x') + D_state u, about a state of a model; all SI.

    x (n): deviations of the coordinates `names` [m, rad]; u (n_u): deviations of the inputs; y (n_y) of the outputs.
    M (n, n), D (n, n) with gyroscopic terms, K (n, n) with geometric and follower terms; B (n, n_u); C (n_y, 2 n);
    names, input_names, output_names and their units; S (n_q, n): motion of all coordinates with x; state: where it
    is; residual (n,): M x'' that the state itself has, zero at an equilibrium; eigenvalues and shapes: see `Modal`;
    controllers: the last so many of x are integrals of controller states, which are left out of the first-order form.
    """

    model: Model
    parameters: np.ndarray
    state: State
    M: np.ndarray
    D: np.ndarray
    K: np.ndarray
    B: np.ndarray
    C: np.ndarray
    D_state: np.ndarray
    names: list[str]
    input_names: list[str]
    output_names: list[str]
    units: dict[str, str]
    S: np.ndarray
    q: np.ndarray
    q_dot: np.ndarray
    residual: np.ndarray
    steady: bool = True
    locked: tuple[str, ...] = field(default=())
    controllers: int = 0

    @cached_property
    def modal(self) -> Modal:
        """The modes with all that is known of them. Raises LinAlgError if M is not positive definite."""
        return modal_analysis(self.M, self.D, self.K, self.controllers)

    @property
    def frequencies(self) -> np.ndarray:
        """(n,) natural frequencies [rad/s], ascending; sqrt(product) of two real eigenvalues; rigid-body modes 0."""
        return self.modal.frequencies

    @property
    def damping_ratios(self) -> np.ndarray:
        """(n,) damping ratios: above 1 overdamped, negative growing."""
        return self.modal.damping_ratios

    @property
    def eigenvalues(self) -> np.ndarray:
        """(n,) one eigenvalue of each mode [1/s], sorted by frequency; `modal.every_eigenvalue` has all."""
        return self.modal.eigenvalues

    @property
    def shapes(self) -> np.ndarray:
        """(n, n) complex mode shapes in x, columns, of modal mass 1, the largest entry real and positive."""
        return self.modal.shapes

    @cached_property
    def mode_names(self) -> list[str]:
        """One name a mode: the coordinate with the largest share of its kinetic energy, `rigid` before it if so."""
        shares = np.abs(self.shapes.conj() * (self.M @ self.shapes))
        return [
            ("rigid " if self.modal.rigid[k] else "") + self.names[int(shares[:, k].argmax())]
            for k in range(shares.shape[1])
        ]

    @cached_property
    def _kept(self) -> np.ndarray:
        """Which of (x, x') make the first-order state."""
        n = len(self.names)
        return np.delete(np.arange(2 * n), np.arange(n - self.controllers, n))

    @property
    def state_names(self) -> list[str]:
        """(2 n - controllers) names of the first-order state: x, then its rates; controller states by their own."""
        own = {
            f"{entry.name}_dot": entry.owner for entry in self.model.description.coordinates if entry.kind == "state"
        }
        names = [*self.names, *(f"{name}_dot" for name in self.names)]
        return [own.get(names[k], names[k]) for k in self._kept]

    @cached_property
    def A_state(self) -> np.ndarray:
        """(2 n, 2 n) of z' = A z + B u with z = (x, x'), less the integrals of controller states."""
        n = len(self.names)
        zero, unit = np.zeros((n, n)), np.eye(n)
        A = np.block([[zero, unit], [-np.linalg.solve(self.M, self.K), -np.linalg.solve(self.M, self.D)]])
        return np.asarray(A[np.ix_(self._kept, self._kept)])

    @cached_property
    def B_state(self) -> np.ndarray:
        """(2 n, n_u)."""
        return np.asarray(np.vstack([np.zeros_like(self.B), np.linalg.solve(self.M, self.B)])[self._kept])

    @property
    def C_state(self) -> np.ndarray:
        """(n_y, 2 n)."""
        return self.C[:, self._kept]

    def frequency_response(self, omega: np.ndarray) -> np.ndarray:
        """(n_omega, n_y, n_u) H(i omega) = C (i omega - A)^-1 B + D, complex, at frequencies [rad/s].

        Solved in second-order form; infinite at an undamped resonance.
        """
        n = len(self.names)
        result = np.zeros((len(np.atleast_1d(omega)), len(self.output_names), len(self.input_names)), dtype=complex)
        for k, w in enumerate(np.atleast_1d(np.asarray(omega, dtype=float))):
            if self.controllers:
                A = self.A_state
                result[k] = self.C_state @ _solved(1j * w * np.eye(len(A)) - A, self.B_state) + self.D_state
                continue
            x = _solved(self.K - w**2 * self.M + 1j * w * self.D, self.B)
            result[k] = self.C[:, :n] @ x + 1j * w * (self.C[:, n:] @ x) + self.D_state
        return result

    def response(self, omega: float, force: np.ndarray) -> np.ndarray:
        """(n_y,) complex amplitudes of the outputs under generalised forces Re(force exp(i omega t)), force (n,).

        Raises NoResult where they grow without bound, or where nothing determines them.
        """
        n, back = len(self.names), np.linalg.inv(np.linalg.cholesky(self.M))
        A = back @ (self.K - omega**2 * self.M + 1j * omega * self.D) @ back.T
        U, s, V = np.linalg.svd(A)
        side = U.conj().T @ back @ np.asarray(force)
        shown = (self.C[:, :n] + 1j * omega * self.C[:, n:]) @ back.T @ V.conj().T
        held = s > n * np.finfo(float).eps * s.max(initial=0.0)
        free = [np.abs(part[..., ~held]).max(initial=0.0) / max(np.abs(part).max(), 1e-300) for part in (side, shown)]
        if max(free) > UNDETERMINED:
            raise NoResult(
                f"the response of model {self.model.name} at {omega:.6g} rad/s",
                "grows without bound" if free[0] > UNDETERMINED else "is not determined: nothing holds these outputs",
                "take another frequency, give damping, or lock what is free (`locked`)",
            )
        return np.asarray(shown[:, held] @ (side[held] / s[held]))

    def shape_of_all(self, mode: int) -> np.ndarray:
        """(n_q,) complex motion of all coordinates in a mode, in the order of model.coordinates."""
        return np.asarray(self.S @ self.shapes[:, mode])

    @cached_property
    def basis_change(self) -> np.ndarray:
        """(n,) how much each frequency changes, relatively, without the stiffest assumed mode that takes part in it.

        A warning of what further modes of the flexible bodies would change; 0 where nothing can be left out. Damping
        and gyroscopic terms are left aside.
        """
        return _basis_change(self)

    def remarks(self) -> list[str]:
        """What a reader should know: not an equilibrium, not steady, unstable, a modal basis that is too small."""
        told = []
        if not self.steady:
            told.append("the forces change with time or along the motion: the system is that of one instant")
        if np.abs(np.linalg.solve(self.M, self.residual)).max(initial=0.0) > 1e-6:
            told.append("the state is not an equilibrium: it accelerates")
        if not self.modal.stable:
            told.append("unstable: at least one mode grows")
        poor = [k for k in range(len(self.basis_change)) if self.basis_change[k] > POOR_BASIS]
        told += [
            f"mode {k + 1} ({self.mode_names[k]}) changes by more than 1 % with one assumed mode less: take more modes"
            for k in poor[:3]
        ]
        return told

    def to_scipy(self) -> StateSpace:
        """scipy.signal.StateSpace of the first-order form."""
        from scipy.signal import StateSpace

        return StateSpace(self.A_state, self.B_state, self.C_state, self.D_state)

    def output(self, name: str) -> int:
        """Row of an output. Raises ModelError for an unknown name."""
        if name not in self.output_names:
            raise ModelError(f"{name!r} is not an output; the outputs are {', '.join(self.output_names)}")
        return self.output_names.index(name)

    def __repr__(self) -> str:
        return (
            f"<Linearisation of {self.model.name}: {len(self.names)} coordinates, {len(self.input_names)} inputs, "
            f"{len(self.output_names)} outputs, {'stable' if self.modal.stable else 'unstable'}>"
        )


def _solved(matrix: np.ndarray, side: np.ndarray) -> np.ndarray:
    try:
        return np.asarray(np.linalg.solve(matrix, side.astype(complex)))
    except np.linalg.LinAlgError:
        return np.full(side.shape, complex(np.inf, np.inf))


def _basis_change(system: Linearisation) -> np.ndarray:
    """Of each mode the change without the stiffest elastic coordinate that is coupled to it."""
    elastic = [k for k, name in enumerate(system.names) if name in system.model.elastic]
    n, change = len(system.names), np.zeros(len(system.mode_names))
    if len(elastic) < 2 or system.controllers:
        return change
    own = np.sqrt(np.abs(np.diag(system.K)) / np.diag(system.M))
    K = 0.5 * (system.K + system.K.T)
    full = modal_analysis(system.M, np.zeros((n, n)), K).frequencies
    for j in sorted(elastic, key=lambda k: own[k]):
        kept = np.ix_(np.delete(np.arange(n), j), np.delete(np.arange(n), j))
        less = modal_analysis(system.M[kept], np.zeros((n - 1, n - 1)), K[kept]).frequencies
        for k in range(n - 1):
            if 0 < full[k] < own[j] and abs(less[k] / full[k] - 1.0) > COUPLED:
                change[k] = abs(less[k] / full[k] - 1.0)
    return change
