"""Sub-steps of the linear system  M w'' = G(tau) + J_q w + J_v w',  G(tau) = G0 + G1 tau + G2 tau^2 / 2.

With A = [0 1; M^-1 J_q, M^-1 J_v] and y = (w, w'), one sub-step h is, for constant A exactly,

    y(tau + h) = y + h phi_1(h A) y'(tau) + h^2 phi_2(h A) (0, M^-1 G'(tau)) + h^3 phi_3(h A) (0, M^-1 G2).

phi_k is replaced by its rational approximation with the denominator of the diagonal Pade approximation of exp:
of order 2 FRACTION_DEGREE, |R(i x)| = 1 for undamped modes and bounded for damped ones however stiff, so that the
price does not grow with the stiffness. A numerator of one degree less lets stiff decays die out at once, at the
price of a little damping of undamped modes (order 5). In partial fractions each sub-step is one real and
(FRACTION_DEGREE - 1) / 2 complex solves with

    r^2 M - r h J_v - h^2 J_q,

whose factors serve all sub-steps of a major step. A part of a sub-step is had from the same factors: the numerator for
exp(part z) is cut off at degree FRACTION_DEGREE, which makes it of order FRACTION_DEGREE only.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Sequence

import casadi as ca

from runtime.contract.model import EmittedModel
from runtime.engine.kept_programs import kept_function, key_of
from runtime.engine.program import Fields
from runtime.schemes.options import SchemeError
from runtime.schemes.partial_fractions import FRACTION_DEGREE, Pole, poles
from runtime.schemes.sparse_lu import Cells, Number, factor, filled, pattern, solve
from runtime.schemes.stage_equations import LinearSystem, StageEquations

Factors = tuple[Number, ...]


def factors_of(system: LinearSystem, h: ca.SX, shifts: tuple[complex, ...] | None = None) -> Factors:
    """Factors of r^2 M - r h J_v - h^2 J_q for every r in shifts, by default the poles of a sub-step h."""
    chosen = tuple(pole.r for pole in poles()) if shifts is None else shifts
    return tuple(factor(_shifted(system, h, r)) for r in chosen)


def _shifted(system: LinearSystem, h: ca.SX, r: complex) -> Number:
    m, k, d = ca.sparsify(system.M_hat), h * h * ca.sparsify(system.J_q), h * ca.sparsify(system.J_v)
    square = r * r
    return Number(square.real * m - r.real * d - k, square.imag * m - r.imag * d if r.imag else None)


def propagate(
    system: LinearSystem,
    factors: Factors,
    w: ca.SX,
    u: ca.SX,
    G: Sequence[ca.SX],
    tau: ca.SX,
    h: ca.SX,
    part: float = 1.0,
    decaying: bool = False,
    echo: tuple[float, ca.SX] | None = None,
    free: Collection[int] = (),
) -> tuple[ca.SX, ca.SX]:
    """(w, w') after a part of a sub-step h from (w, u) at tau; G: G0, G1, ... The factors are of these poles.

    echo: (share, bend); adds what a force bend tau^2 / 2 does from rest in that share of a sub-step. free: coordinates
    whose even motion is summed apart, so that changes of w' are no differences of large numbers, whose rounding would
    grow with the number of steps: turns of bodies. What is stiff is much smaller than an even motion, and is not.
    """
    slopes = [polynomial(G[k:], tau) for k in range(len(G))]
    slopes[0] = slopes[0] + ca.mtimes(system.J_q, w)  # M a less J_v rest
    even, rest = (ca.vertcat(*(u[k] if (k in free) == own else 0 for k in range(u.numel()))) for own in (True, False))
    slopes[0] = slopes[0] + ca.mtimes(system.J_v, even)
    Mu, pull = ca.mtimes(system.M_hat, rest), ca.mtimes(system.J_q, even)
    new_w, new_u = w + part * h * even, u
    echoes = poles(FRACTION_DEGREE, 1.0 if echo is None else echo[0], decaying)
    for pole, echoing, entries in zip(poles(FRACTION_DEGREE, part, decaying), echoes, factors, strict=True):
        r, w1 = pole.r, pole.weights[0]

        def side(part: str, pole: Pole = pole, echoing: Pole = echoing) -> ca.SX:
            def of(value: complex) -> float:
                return float(getattr(value, part))

            found, power = of(pole.r * pole.weights[0]) * h * Mu + of(pole.weights[0] / pole.r) * h**3 * pull, h
            for weight, slope in zip(pole.weights, slopes, strict=False):
                power = power * h
                found = found + of(weight) * power * slope
            return found if echo is None else found + of(echoing.weights[2]) * h**4 * echo[1]

        # (r - h A)^-1 (p, s) with p = h w1 u and M s = h w1 M a + h^2 w2 G' + h^3 w3 G'' + ..., of the even part less
        # p / r in x, which of all poles together is part h u, and nothing in y; powers of h are made once a run
        x, turned = solve_shifted(entries, r, side("real"), side("imag") if r.imag else None)
        turned = r.real * x - r.imag * turned if r.imag else r.real * x
        new_w, new_u = new_w + pole.share * x, new_u + pole.share * (turned / h - w1.real * rest)
    return new_w, new_u


def polynomial(G: Sequence[ca.SX], tau: ca.SX) -> ca.SX:
    """G0 + G1 tau + G2 tau^2 / 2 + ..."""
    power, value = ca.SX(1), G[0]
    for k, term in enumerate(G[1:], start=1):
        power = power * tau / k
        value = value + power * term
    return value


def solve_shifted(factors: Number, r: complex, re: ca.SX, im: ca.SX | None) -> tuple[ca.SX, ca.SX]:
    """Real and imaginary part of the solution for the right-hand side re + i im; r tells whether it is complex."""
    if im is None or not r.imag:
        return solve(factors, Number(ca.densify(re))).re, ca.SX.zeros(re.numel())
    x = solve(factors, Number(ca.densify(re), ca.densify(im)))
    assert x.im is not None
    return x.re, x.im


# A linear system kept in fields of z between the stages of a major step: sparse, so that zeros cost nothing.

MOST_FACTOR_OPERATIONS = 2_000_000  # of the factors: some minutes to compile, and gigabytes
MATRICES = {"M": "M_hat", "J_q": "J_q", "J_v": "J_v"}  # names in z and of a LinearSystem


class StoredSystem:
    """Patterns of M_hat, J_q, J_v and of the factors, and how they lie in z.

    shifts: see factors_of; () for no factors. matrices: those that are kept beside the factors.
    """

    def __init__(
        self,
        model: EmittedModel,
        shifts: tuple[complex, ...] | None = None,
        matrices: Collection[str] = tuple(MATRICES),
    ) -> None:
        self._complex = [bool(r.imag) for r in (shifts if shifts is not None else (pole.r for pole in poles()))]
        found = kept_function(key_of(model, "patterns"), lambda: _patterns(model))
        patterns = {name: found.sparsity_out(k) for k, name in enumerate((*MATRICES, "factors"))}
        self._sparsity, self._factors = {name: patterns[name] for name in matrices}, patterns["factors"]

    def sizes(self) -> dict[str, int]:
        """Sizes of the fields of z."""
        sizes = self.matrix_sizes()
        for k, is_complex in enumerate(self._complex):
            sizes[f"lu_{k}"] = self._factors.nnz() * (2 if is_complex else 1)
        return sizes

    def matrix_sizes(self) -> dict[str, int]:
        """Sizes of those of the matrices that are kept."""
        return {name: sparsity.nnz() for name, sparsity in self._sparsity.items()}

    def pack(self, system: LinearSystem) -> dict[str, ca.SX]:
        """Fields of the matrices."""
        return {name: _entries(getattr(system, MATRICES[name]), sparsity) for name, sparsity in self._sparsity.items()}

    def pack_factors(self, factors: Factors) -> dict[str, ca.SX]:
        """Fields of the factors."""
        return {
            f"lu_{k}": ca.vertcat(*(_entries(part, self._factors) for part in (one.re, one.im) if part is not None))
            for k, one in enumerate(factors)
        }

    def unpack(self, z: Fields) -> LinearSystem:
        """All three matrices."""
        return LinearSystem(*self.unpack_matrices(z).values())

    def unpack_matrices(self, z: Fields) -> dict[str, ca.SX]:
        """The matrices that are kept."""
        return {name: ca.SX(sparsity, z[name]) for name, sparsity in self._sparsity.items()}

    def unpack_factors(self, z: Fields) -> Factors:
        """The factors."""
        found = []
        for k, is_complex in enumerate(self._complex):
            values, size = z[f"lu_{k}"], self._factors.nnz()
            found.append(
                Number(ca.SX(self._factors, values[:size]), ca.SX(self._factors, values[size:]) if is_complex else None)
            )
        return tuple(found)


def _patterns(model: EmittedModel) -> ca.Function:
    """() -> M_hat, J_q, J_v and the factors, 1 where they are not zero. Raises SchemeError where factors are long."""
    n = len(model.q_i)
    q, v, t = ca.SX.sym("q", n), ca.SX.sym("v", n), ca.SX.sym("t")
    equations = StageEquations(model, ca.SX.sym("c", model.c_size + 1))
    motion = equations.close(q, ca.SX.sym("loop", len(model.loop_unknowns)), t, 1)
    if 4 * n**3 > MOST_FACTOR_OPERATIONS:  # else even dense factors are short
        _require_short(model, pattern(equations.condensed(motion, v)[0]))
    found = equations.linearised(motion, v)
    cells = [pattern(one) for one in (found.M_hat, found.J_q, found.J_v)]
    places = (sorted(one) for one in (*cells, filled(set().union(*cells), n)))
    shapes = [ca.Sparsity.triplet(n, n, [i for i, _ in own], [j for _, j in own]) for own in places]
    return ca.Function("patterns", [], [ca.SX(shape, 1) for shape in shapes])


def _require_short(model: EmittedModel, cells: Cells) -> None:
    """Raises SchemeError where the factors of a matrix with these cells take too many operations."""
    n = len(model.q_i)
    factors = filled(cells, n)
    below, right = Counter(j for i, j in factors if i < j), Counter(i for i, j in factors if j < i)
    count = sum(below[k] * right[k] for k in range(n)) * sum(8 if pole.r.imag else 2 for pole in poles())
    if count > MOST_FACTOR_OPERATIONS:
        raise SchemeError(
            f"{model.name}: {n} independent coordinates",
            f"a scheme that factorises their mass matrix and Jacobians takes {count / 1e6:.0f} million operations "
            f"a step, more than the {MOST_FACTOR_OPERATIONS / 1e6:.0f} that are written out",
            f"take {', '.join(_others(model))}",
        )


def _others(model: EmittedModel) -> list[str]:
    """Schemes for many coordinates."""
    stiff = ["exponential_rk4"] if model.has("deflections") else []
    return [*stiff, *(["coupled"] if len(model.groups) == 2 else []), "single_rate"]


def _entries(matrix: ca.SX, sparsity: ca.Sparsity) -> ca.SX:
    if not sparsity.nnz():  # of nothing CasADi makes a 1 x 1 zero
        return ca.SX(0, 1)
    return ca.SX(ca.project(matrix, sparsity).nz[:])
