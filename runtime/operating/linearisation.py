"""A linear system about a state: its matrices, modes, responses and state-space forms."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from runtime.contract.errors import ModelError, NoResult
from runtime.contract.escapes import words
from runtime.contract.model import EmittedModel
from runtime.operating.mode_solver import State

if TYPE_CHECKING:
    from control import StateSpace as ControlStateSpace
    from scipy.signal import StateSpace

COUPLED = 1e-7  # relative change of a frequency without an assumed mode that is more than rounding
UNDETERMINED = 1e-9  # share of a force, or of outputs, along motions that nothing resists
POOR_BASIS = 0.01  # change of a frequency without one assumed mode from which the basis is called poor


@dataclass(frozen=True, repr=False)
class Linearisation:
    """The equations of a model about a state: M x'' + D x' + K x = B u and y = C (x, x') + D_state u; all SI.

    Attributes
    ----------
    names, input_names, output_names : list of str
        Of the deviations x (n) of coordinates [m, rad], u (n_u) of inputs and y (n_y) of outputs; `units` has theirs.
    M, D, K : (n, n) array
        Mass; damping with gyroscopic terms; stiffness with geometric and follower terms.
    B, C, D_state : (n, n_u), (n_y, 2 n), (n_y, n_u) array
        Inputs and outputs.
    S : (n_q, n) array
        Motion of all coordinates with x.
    state : State
        Where it is; q, q_dot (n_q,) and parameters (n_p,) belong to it.
    residual : (n,) array
        M x'' that the state itself has, zero at an equilibrium.
    controllers : int
        The last so many of x are integrals of controller states, which are left out of the first-order form.

    Notes
    -----
    Eigenvalues and shapes: see `Modal`.
    """

    model: EmittedModel
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
        remarks = []
        if not self.steady:
            remarks.append("the forces change with time or along the motion: the system is that of one instant")
        if np.abs(np.linalg.solve(self.M, self.residual)).max(initial=0.0) > 1e-6:
            remarks.append("the state is not an equilibrium: it accelerates")
        if not self.modal.stable:
            remarks.append("unstable: at least one mode grows")
        poor = [k for k in range(len(self.basis_change)) if self.basis_change[k] > POOR_BASIS]
        remarks += [
            f"mode {k + 1} ({self.mode_names[k]}) changes by more than 1 % with one assumed mode less: take more modes"
            for k in poor[:3]
        ]
        return remarks

    def to_scipy(self) -> StateSpace:
        """scipy.signal.StateSpace of the first-order form."""
        from scipy.signal import StateSpace

        return StateSpace(self.A_state, self.B_state, self.C_state, self.D_state)

    def to_control(self) -> ControlStateSpace:
        """Make a python-control system of the first-order form, with the names of states, inputs and outputs.

        Returns
        -------
        control.StateSpace
            Continuous, SI units. Its signals have our names with _ for what is not a letter or digit, as python-control
            takes no dots: `crank.theta_dot` is `crank_theta_dot`, and a number at the end keeps equal ones apart. An
            input that is a coordinate is a force or torque on it.

        Raises
        ------
        ImportError
            If python-control is not installed (extra `control`).
        """
        try:
            from control import StateSpace
        except ImportError as error:
            raise ImportError(
                "python-control is not installed; install it with: pip install 'symgen[control]'"
            ) from error
        signals = {"states": self.state_names, "inputs": self.input_names, "outputs": self.output_names}
        named = {kind: words(names) for kind, names in signals.items()}
        (name,) = words([self.model.name])
        return StateSpace(self.A_state, self.B_state, self.C_state, self.D_state, name=name, **named)

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


# ---- Modes of M x'' + D x' + K x = 0: any D and K, so damped, gyroscopic and unstable systems too.
#
# With M = L L^T and x = L^-T y, y'' + (L^-1 D L^-T) y' + (L^-1 K L^-T) y = 0. Without D and with K symmetric the modes
# are real and come from a symmetric eigenvalue problem; else from the first-order form of twice the size.

NO_EIGENVALUE = 1e-13  # relative eigenvalue of K below which a direction has no stiffness
NO_RATE = 3e-6  # relative size up to which an eigenvalue of a direction without stiffness is a zero split by rounding
ASYMMETRY_ROUNDING = 1e-11  # relative asymmetry that is rounding
NO_DAMPING = 1e-13  # D against twice the critical one of the fastest mode
GROWING = 1e-9  # real part, relative to the largest eigenvalue, that is more than rounding


@dataclass(frozen=True)
class Modal:
    """The n modes of a system of n coordinates, sorted by frequency.

    eigenvalues (n,) [1/s]: of each conjugate pair the one with a positive imaginary part, of a pair of real ones the
    one that decays slowest; frequencies (n,) [rad/s]: sqrt(|lambda_1 lambda_2|) of the pair, |lambda| if they are
    conjugate; damping_ratios (n,): -(lambda_1 + lambda_2) / (2 frequency), above 1 where overdamped, -1 where a real
    eigenvalue grows, 0 for rigid-body modes; shapes (n, n): complex displacements, columns, of modal mass 1, the
    largest entry real; rigid (n,): is it a motion without stiffness; every_eigenvalue (2 n,).
    """

    eigenvalues: np.ndarray
    frequencies: np.ndarray
    damping_ratios: np.ndarray
    shapes: np.ndarray
    rigid: np.ndarray
    every_eigenvalue: np.ndarray

    @property
    def stable(self) -> bool:
        """Does no mode grow? (Rigid-body modes count as neutral.)"""
        every = self.every_eigenvalue
        return not len(every) or float(every.real.max()) <= GROWING * float(np.abs(every).max(initial=0.0))


def modal_analysis(M: np.ndarray, D: np.ndarray, K: np.ndarray, states: int = 0) -> Modal:
    """Modes of M x'' + D x' + K x = 0 (n x n each), M symmetric positive definite. Raises LinAlgError if it is not.

    states: of the last so many coordinates only the rate counts, the state of a controller. Then there are as many
    modes as conjugate pairs and real eigenvalues, each of which is a mode with ratio 1.
    """
    n = len(M)
    if states:
        return _closed_loop(M, D, K, states)
    if not n:
        none = np.zeros(0)
        return Modal(none, none, none, np.zeros((0, 0)), np.zeros(0, dtype=bool), none)
    L = np.linalg.cholesky(M)
    K_L = np.linalg.solve(L, np.linalg.solve(L, K.T).T)
    D_L = np.linalg.solve(L, np.linalg.solve(L, D.T).T)
    size = float(np.linalg.norm(K_L, 2))
    singular = np.linalg.svd(K_L, compute_uv=False)
    free = int(np.sum(singular <= NO_EIGENVALUE * size)) if size > 0 else n
    symmetric = float(np.abs(K_L - K_L.T).max()) <= ASYMMETRY_ROUNDING * size
    if symmetric and float(np.abs(D_L).max()) <= NO_DAMPING * np.sqrt(size):
        found = _undamped(0.5 * (K_L + K_L.T), free)
    else:
        found = _general(D_L, K_L, free)
    return _normalised(found, np.linalg.inv(L).T)


def _undamped(K: np.ndarray, free: int) -> Modal:
    squares, vectors = np.linalg.eigh(K)
    order = np.argsort(np.abs(squares), kind="stable")
    squares, vectors = squares[order], vectors[:, order]
    squares[:free] = 0.0
    roots = np.sqrt(squares.astype(complex))
    values = np.where(squares >= 0, 1j * np.abs(roots), np.abs(roots))
    ratios = np.where(squares < 0, -1.0, 0.0)
    rigid = np.arange(len(K)) < free
    every = np.concatenate([values, -values])
    return Modal(values, np.abs(roots), ratios, vectors.astype(complex), rigid, every)


def _general(D: np.ndarray, K: np.ndarray, free: int) -> Modal:
    n = len(K)
    A = np.block([[np.zeros((n, n)), np.eye(n)], [-K, -D]])
    values, vectors = np.linalg.eig(A)
    every = values.astype(complex)
    order = np.argsort(np.abs(every), kind="stable")
    every, shapes = every[order], vectors[:n, order].astype(complex)
    fastest = float(np.abs(every).max())
    every[:free] = 0.0
    split = np.arange(2 * n) < 2 * free
    every[split & (np.abs(every) <= NO_RATE * fastest)] = 0.0
    pairs = _pairs(every, shapes)
    pairs.sort(key=lambda pair: _frequency(every, pair))
    lead = [first for first, _ in pairs]
    frequencies = np.array([_frequency(every, pair) for pair in pairs])
    rigid = np.array([every[first] == 0 or every[second] == 0 for first, second in pairs])
    return Modal(
        every[lead], frequencies, np.array([_damping(every, pair) for pair in pairs]), shapes[:, lead], rigid, every
    )


def _closed_loop(M: np.ndarray, D: np.ndarray, K: np.ndarray, states: int) -> Modal:
    n = len(M)
    A = np.block([[np.zeros((n, n)), np.eye(n)], [-np.linalg.solve(M, K), -np.linalg.solve(M, D)]])
    kept = np.delete(np.arange(2 * n), np.arange(n - states, n))
    values, vectors = np.linalg.eig(A[np.ix_(kept, kept)])
    fastest = float(np.abs(values).max(initial=0.0))
    values = np.where(np.abs(values) <= GROWING * fastest, 0.0, values.astype(complex))
    lead = sorted((k for k in range(len(values)) if values[k].imag >= 0), key=lambda k: abs(values[k]))
    found = values[lead]
    rigid = found == 0
    x = vectors[: n - states, lead].astype(complex)
    rates = vectors[len(kept) - states :, lead]
    x = np.vstack([x, np.where(rigid, 0.0, rates / np.where(rigid, 1.0, found))])
    size = np.abs(found)
    ratios = np.where(rigid, 0.0, -found.real / np.where(rigid, 1.0, size))
    mass = np.real(np.einsum("ik,ij,jk->k", x.conj(), M, x))
    shapes = x / np.sqrt(np.maximum(mass, 1e-300))
    largest = shapes[np.abs(shapes).argmax(axis=0), np.arange(len(found))]
    return Modal(found, size, ratios, shapes * (np.abs(largest) / np.where(largest == 0, 1, largest)), rigid, values)


def _pairs(values: np.ndarray, shapes: np.ndarray) -> list[tuple[int, int]]:
    """Conjugate eigenvalues together; real ones by the likeness of their shapes, rigid-body modes first."""
    upper = [k for k in range(len(values)) if values[k].imag > 0]
    lower = {k: min(_others(values, k), key=lambda j: abs(values[j] - values[k].conjugate())) for k in upper}
    pairs = list(lower.items())
    real = sorted((k for k in range(len(values)) if values[k].imag == 0), key=lambda k: abs(values[k]))
    unit = shapes / np.maximum(np.linalg.norm(shapes, axis=0), 1e-300)
    while real:
        first = real.pop(0)
        second = max(real, key=lambda k: abs(np.vdot(unit[:, first], unit[:, k])))
        real.remove(second)
        pairs.append((first, second) if values[first].real >= values[second].real else (second, first))
    return pairs


def _others(values: np.ndarray, k: int) -> list[int]:
    return [j for j in range(len(values)) if values[j].imag < 0]


def _frequency(values: np.ndarray, pair: tuple[int, int]) -> float:
    return float(np.sqrt(np.abs(values[pair[0]]) * np.abs(values[pair[1]])))


def _damping(values: np.ndarray, pair: tuple[int, int]) -> float:
    first, second = values[list(pair)]
    size = _frequency(values, pair)
    if size == 0:
        return 0.0
    return -1.0 if first.imag == 0 and first.real > 0 else float(-(first + second).real / (2 * size))


def _normalised(found: Modal, back: np.ndarray) -> Modal:
    """Shapes of unit modal mass in x = back y, turned so that the largest entry is real and positive."""
    y = found.shapes / np.maximum(np.linalg.norm(found.shapes, axis=0), 1e-300)
    x = back @ y
    largest = x[np.abs(x).argmax(axis=0), np.arange(x.shape[1])]
    x = x * (np.abs(largest) / np.where(largest == 0, 1.0, largest))
    return Modal(found.eigenvalues, found.frequencies, found.damping_ratios, x, found.rigid, found.every_eigenvalue)
