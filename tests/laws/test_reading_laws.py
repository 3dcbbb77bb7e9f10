"""Each reading of the interpolation of slow variables against its formula, summed or weighted by hand."""

from __future__ import annotations

import numpy as np
import pytest

from runtime.schemes.printed import INTERPOLATIONS

Q, V, A, H, M, Q_NEXT = 0.3, -1.2, 5.0, 0.08, 8, 0.11
h = H / M


@pytest.mark.parametrize("j", range(1, M))
def test_end_point_sum(j: int) -> None:
    """(63): q_L + sum over k = 1..j of h q_L_dot(t + k h), with (60) q_L_dot(t + k h) = q_L_dot + k h q_L_ddot."""
    position = Q + sum(h * (V + k * h * A) for k in range(1, j + 1))
    q, v = INTERPOLATIONS["end_point_sum"](Q, V, A, j * h, h, H, Q_NEXT)
    assert q == pytest.approx(position, rel=1e-14)
    assert v == pytest.approx(V + j * h * A, rel=1e-14)
    # the overshoot of the print, docs/theory/schemes.md
    exact, _ = INTERPOLATIONS["constant_acceleration"](Q, V, A, j * h, h, H, Q_NEXT)
    assert q - exact == pytest.approx(j * h * h * A / 2, rel=1e-11)


@pytest.mark.parametrize("j", range(1, M))
def test_constant_acceleration(j: int) -> None:
    """The mean of the end-point and the start-point sums is the exact polynomial."""
    ends = sum(h * (V + k * h * A) for k in range(1, j + 1))
    starts = sum(h * (V + k * h * A) for k in range(j))
    q, v = INTERPOLATIONS["constant_acceleration"](Q, V, A, j * h, h, H, Q_NEXT)
    assert q == pytest.approx(Q + (ends + starts) / 2, rel=1e-14)
    assert v == pytest.approx(V + j * h * A, rel=1e-14)


@pytest.mark.parametrize("j", range(2, M + 1))
def test_chord_ahead(j: int) -> None:
    """(13): x_L = (1 - j/m) x_L(t) + j/m x_L(t + dt_L), used at time t + (j - 1) h."""
    q, v = INTERPOLATIONS["chord_ahead"](Q, V, A, (j - 1) * h, h, H, Q_NEXT)
    assert q == pytest.approx((1 - j / M) * Q + j / M * Q_NEXT, rel=1e-13)
    assert v == pytest.approx((Q_NEXT - Q) / H, rel=1e-14)


def test_chord() -> None:
    """Linear between the two known values, at its own time."""
    for s in np.linspace(0, H, 9):
        q, v = INTERPOLATIONS["chord"](Q, V, A, s, h, H, Q_NEXT)
        assert q == pytest.approx(float(np.interp(s, [0, H], [Q, Q_NEXT])), rel=1e-13)
        assert v == pytest.approx((Q_NEXT - Q) / H, rel=1e-14)


@pytest.mark.parametrize("name", INTERPOLATIONS)
def test_all_agree_at_rest(name: str) -> None:
    q, v = INTERPOLATIONS[name](Q, 0.0, 0.0, 3 * h, h, H, Q)
    assert q == pytest.approx(Q, rel=1e-15) and v == 0.0
