"""sin, cos and exp in LLVM IR: IEEE operations and fused multiply-adds only, no branch, one text for every width.

So results are the same bits in scalar code and in lanes, at every level of optimisation and of the processor, and a
value that a loop does not change can be taken out of it. At most 0.8 units in the last place:

    sin, cos    x = j pi/2 + r + remainder, j to nearest, pi/2 in three parts (Cody and Waite, with fused multiply-add);
                polynomials of Cephes in r, to which the remainder is added; NaN where |x| is not below 2^50
    exp         x = n ln 2 + r, Taylor polynomial, times 2^n in two steps so that small results round once

LIBRARY functions are those of the C library, called once a lane: the same at every width, but those of the platform.
"""

from __future__ import annotations

import struct

LIBRARY_UNARY = ("log", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh")
LIBRARY_BINARY = ("pow", "atan2", "fmod", "hypot")
REPLACED = ("sin", "cos", "exp")  # by functions of our own where mathematics is "own"
PURE = "nounwind willreturn memory(none)"

MAGIC = 1.5 * 2.0**52  # added, it leaves the nearest integer in the low bits
TWO_OVER_PI = 0.6366197723675814
HALF_PI = (1.5707963267948966, 6.123233995736766e-17, -1.4973849048591698e-33)
SIN = (
    1.58962301576546568060e-10,
    -2.50507477628578072866e-8,
    2.75573136213857245213e-6,
    -1.98412698295895385996e-4,
    8.33333333332211858878e-3,
    -1.66666666666666307295e-1,
)
COS = (
    -1.13585365213876817300e-11,
    2.08757008419747316778e-9,
    -2.75573141792967388112e-7,
    2.48015872888517045348e-5,
    -1.38888888888730564116e-3,
    4.16666666666665929218e-2,
)
LARGEST_ANGLE = 2.0**50
LOG2_E = 1.4426950408889634
LN_2 = (0.6931471805599453, 2.3190468138462996e-17)
EXP_RANGE = (-746.0, 710.0)  # beyond: 0 and infinity
_FACTORIALS = (1, 2, 6, 24, 120, 720, 5040, 40320, 362880, 3628800, 39916800, 479001600, 6227020800)
EXP = tuple(1.0 / value for value in reversed(_FACTORIALS[1:]))  # 1/13! ... 1/2!


class Lanes:
    """Names of types and numbers for values of `width` lanes; one lane is a plain double."""

    def __init__(self, width: int) -> None:
        self.width = width
        self.double = "double" if width == 1 else f"<{width} x double>"
        self.integer = "i64" if width == 1 else f"<{width} x i64>"
        self.bit = "i1" if width == 1 else f"<{width} x i1>"
        self.suffix = "f64" if width == 1 else f"v{width}f64"
        self.true = "true" if width == 1 else self._spread("i1", "true")
        self.align = 8 * width

    def number(self, value: float) -> str:
        """A constant, the same in every lane."""
        text = f"0x{struct.unpack('<Q', struct.pack('<d', value))[0]:016X}"
        return text if self.width == 1 else self._spread("double", text)

    def whole(self, value: int) -> str:
        """A 64-bit integer, the same in every lane."""
        return str(value) if self.width == 1 else self._spread("i64", str(value))

    def _spread(self, kind: str, text: str) -> str:
        return "<" + ", ".join([f"{kind} {text}"] * self.width) + ">"


class Body:
    """Lines of one function of x; every method appends an instruction and returns the name of its result."""

    x = "%x"

    def __init__(self, lanes: Lanes) -> None:
        self.lanes, self.lines = lanes, list[str]()

    def line(self, text: str) -> str:
        """An instruction."""
        name = f"%t{len(self.lines)}"
        self.lines.append(f"  {name} = {text}")
        return name

    def op(self, name: str, a: str, b: str | float) -> str:
        """An operation of two doubles, by LLVM's name."""
        second = b if isinstance(b, str) else self.lanes.number(b)
        return self.line(f"{name} {self.lanes.double} {a}, {second}")

    def fma(self, a: str, b: str | float, c: str | float) -> str:
        """a b + c, rounded once."""
        kind = self.lanes.double
        b, c = (value if isinstance(value, str) else self.lanes.number(value) for value in (b, c))
        return self.line(f"call {kind} @llvm.fma.{self.lanes.suffix}({kind} {a}, {kind} {b}, {kind} {c})")

    def negative(self, a: str) -> str:
        """-a."""
        return self.line(f"fneg {self.lanes.double} {a}")

    def magnitude(self, a: str) -> str:
        """abs(a)."""
        return self.line(f"call {self.lanes.double} @llvm.fabs.{self.lanes.suffix}({self.lanes.double} {a})")

    def polynomial(self, coefficients: tuple[float, ...], x: str, xx: str) -> str:
        """By Estrin's scheme, the highest coefficient first; xx is the square of x."""
        terms = [self.lanes.number(value) for value in reversed(coefficients)]
        power = x
        while len(terms) > 1:
            pairs = [self.fma(terms[k + 1], power, terms[k]) for k in range(0, len(terms) - 1, 2)]
            terms = pairs + terms[2 * len(pairs) :]
            if len(terms) > 1:
                power = xx if power == x else self.op("fmul", power, power)
        return terms[0]

    def bits(self, a: str) -> str:
        """A double as a 64-bit word."""
        return self.line(f"bitcast {self.lanes.double} {a} to {self.lanes.integer}")

    def double(self, a: str) -> str:
        """A 64-bit word as a double."""
        return self.line(f"bitcast {self.lanes.integer} {a} to {self.lanes.double}")

    def whole(self, name: str, a: str, b: str | int) -> str:
        """An operation of two 64-bit words, by LLVM's name."""
        second = b if isinstance(b, str) else self.lanes.whole(b)
        return self.line(f"{name} {self.lanes.integer} {a}, {second}")

    def select(self, condition: str, a: str | float, b: str | float) -> str:
        """a where the condition holds, else b."""
        kind = self.lanes.double
        a, b = (value if isinstance(value, str) else self.lanes.number(value) for value in (a, b))
        return self.line(f"select {self.lanes.bit} {condition}, {kind} {a}, {kind} {b}")

    def compare(self, test: str, a: str, b: float) -> str:
        """A test of a double, by LLVM's name."""
        return self.line(f"fcmp {test} {self.lanes.double} {a}, {self.lanes.number(b)}")


def sincos(lanes: Lanes, name: str, inline: bool) -> str:
    """A definition of sine and cosine (a pair) under a name of its own."""
    body, pair = Body(lanes), f"{{ {lanes.double}, {lanes.double} }}"
    sine, cosine = sincos_of(body)
    first = body.line(f"insertvalue {pair} poison, {lanes.double} {sine}, 0")
    end = body.line(f"insertvalue {pair} {first}, {lanes.double} {cosine}, 1")
    return _defined(name, pair, body, end, f"{PURE} {'alwaysinline' if inline else 'noinline'}")


def own_functions(lanes: Lanes, inline: bool) -> str:
    """Definitions of @own_sincos (a pair), @own_sin, @own_cos and @own_exp."""
    kind = lanes.double
    attributes = f"{PURE} {'alwaysinline' if inline else 'noinline'}"
    parts = []
    for name in ("sin", "cos"):
        body = Body(lanes)
        sine, cosine = sincos_of(body)
        parts.append(_defined(f"own_{name}", kind, body, sine if name == "sin" else cosine, attributes))
    parts.append(sincos(lanes, "own_sincos", inline))
    body = Body(lanes)
    parts.append(_defined("own_exp", kind, body, exp_of(body), attributes))
    return "\n".join(parts)


def _defined(name: str, result: str, body: Body, end: str, attributes: str) -> str:
    head = f"define internal {result} @{name}({body.lanes.double} %x) {attributes} {{"
    return "\n".join([head, *body.lines, f"  ret {result} {end}", "}", ""])


def sincos_of(f: Body) -> tuple[str, str]:
    """(sine, cosine) of x. Latency is what counts: signs, remainder and tests are computed beside the main path."""
    near = f.fma(f.x, TWO_OVER_PI, MAGIC)
    minus_j, quadrant = f.op("fsub", f.lanes.number(MAGIC), near), f.bits(near)
    first = f.fma(minus_j, HALF_PI[0], f.x)  # exact: a multiple of 2^-53 below 2
    p = f.op("fmul", minus_j, HALF_PI[1])
    r = f.op("fadd", first, p)

    back = f.op("fsub", r, first)  # r + low = x - j pi/2: TwoSum of first and p, error of p, third part
    error = f.op("fadd", f.op("fsub", first, f.op("fsub", r, back)), f.op("fsub", p, back))
    p_error = f.fma(minus_j, HALF_PI[1], f.negative(p))
    low = f.fma(minus_j, HALF_PI[2], f.op("fadd", error, p_error))

    known = f.compare("olt", f.magnitude(f.x), LARGEST_ANGLE)
    sign_of_sine = f.select(known, _sign(f, f.whole("add", quadrant, 1)), float("nan"))
    sign_of_cosine = f.select(known, _sign(f, quadrant), float("nan"))

    z = f.op("fmul", r, r)
    zz = f.op("fmul", z, z)
    half = f.op("fmul", z, 0.5)
    main = f.op("fsub", f.lanes.number(1.0), half)
    lost = f.op("fsub", f.op("fsub", f.lanes.number(1.0), main), half)
    signed_r = f.op("fmul", r, sign_of_sine)  # sin(r + low) = r + r z P(z) + low cos r
    tail = f.fma(
        f.op("fmul", signed_r, z), f.polynomial(SIN, z, zz), f.op("fmul", f.op("fmul", low, main), sign_of_sine)
    )
    sine = f.op("fadd", signed_r, tail)
    beside = f.op("fmul", f.fma(f.negative(r), low, lost), sign_of_cosine)  # cos = 1 - z/2 + z^2 Q(z) - r low
    tail = f.fma(f.op("fmul", zz, sign_of_cosine), f.polynomial(COS, z, zz), beside)
    cosine = f.op("fadd", f.op("fmul", main, sign_of_cosine), tail)

    # odd quadrants swap the two; a comparison of doubles (2 or 0) is a blend on every processor, not a branch
    odd = f.compare("une", f.double(f.whole("shl", f.whole("and", quadrant, 1), 62)), 0.0)
    zero = f.compare("oeq", f.x, 0.0)  # sin(-0.0) is -0.0
    return f.select(zero, f.x, f.select(odd, cosine, sine)), f.select(odd, sine, cosine)


def _sign(f: Body, quadrant: str) -> str:
    """1 or -1, the latter where the second bit is set."""
    bit = f.whole("and", f.whole("shl", quadrant, 62), -(2**63))
    return f.double(f.whole("or", bit, 0x3FF0000000000000))


def exp_of(f: Body) -> str:
    """exp of x."""
    x = f.select(f.compare("ogt", f.x, EXP_RANGE[1]), EXP_RANGE[1], f.x)
    x = f.select(f.compare("olt", x, EXP_RANGE[0]), EXP_RANGE[0], x)
    near = f.fma(x, LOG2_E, MAGIC)
    n = f.whole("sub", f.bits(near), struct.unpack("<q", struct.pack("<d", MAGIC))[0])
    minus_n = f.negative(f.op("fsub", near, MAGIC))
    exact, small = f.fma(minus_n, LN_2[0], x), f.op("fmul", minus_n, LN_2[1])
    r = f.op("fadd", exact, small)  # FastTwoSum
    low = f.op("fsub", small, f.op("fsub", r, exact))
    main = f.op("fadd", r, 1.0)
    lost = f.op("fsub", r, f.op("fsub", main, 1.0))
    rr = f.op("fmul", r, r)
    square = f.fma(rr, f.polynomial(EXP, r, rr), f.fma(low, main, lost))
    value = f.op("fadd", main, square)
    half = f.whole("ashr", n, 1)
    for power in (half, f.whole("sub", n, half)):
        scale = f.double(f.whole("shl", f.whole("add", power, 1023), 52))
        value = f.op("fmul", value, scale)
    return value
