"""The fields of z, the state of a scheme as one vector, by how long they matter. docs/names.md says what each is."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class Lasting(Enum):
    """How long a field of z matters."""

    STEP = "within a major step"
    STATE = "one major step acts on the next through it"
    HISTORY = "state, too: what each coordinate of q_i remembers of earlier steps"
    CONTROL = "steers an iteration; what it converges to does not depend on it"
    GIVEN = "from outside: steps read it and leave it as it is"
    ACCOUNT = "for whoever runs the scheme; no step reads it"


@dataclass(frozen=True)
class StateField:
    """A field of z: how many numbers, and how long they matter."""

    size: int
    lasting: Lasting


def state(size: int) -> StateField:
    """A field through which one major step acts on the next."""
    return StateField(size, Lasting.STATE)


def history(size: int) -> StateField:
    """A field of what each coordinate of q_i remembers of earlier steps."""
    return StateField(size, Lasting.HISTORY)


def work(size: int) -> StateField:
    """A field that passes values between the stages of one major step."""
    return StateField(size, Lasting.STEP)


def account(size: int) -> StateField:
    """A field for whoever runs the scheme."""
    return StateField(size, Lasting.ACCOUNT)


def given(size: int) -> StateField:
    """A field of numbers from outside."""
    return StateField(size, Lasting.GIVEN)


def control(size: int) -> StateField:
    """A field that steers an iteration."""
    return StateField(size, Lasting.CONTROL)
