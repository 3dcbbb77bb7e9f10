"""sin, cos and exp of runtime/engine/mathematics.py as C99: the same operations, printed as statements.

They need fused multiply-adds that round once, as `fma` of the C library does where the processor has none.
"""

from __future__ import annotations

from runtime.engine.llvm_ir import WIDTHS
from runtime.engine.mathematics import Body, Lanes, exp_of, sincos_of

_TESTS = {"olt": "<", "ogt": ">", "oeq": "==", "une": "!="}
_OPERATORS = {"fadd": "+", "fsub": "-", "fmul": "*", "add": "+", "sub": "-", "and": "&", "or": "|", "shl": "<<"}
_WORDS = """
static inline uint64_t {0}own_bits(double x) {{ uint64_t b; memcpy(&b, &x, sizeof b); return b; }}
static inline double {0}own_double(uint64_t b) {{ double x; memcpy(&x, &b, sizeof x); return x; }}
"""


class _Numbers(Lanes):
    """Constants as C writes them."""

    def number(self, value: float) -> str:
        """A double."""
        return "NAN" if value != value else f"({value!r})" if value < 0 else repr(value)

    def whole(self, value: int) -> str:
        """A 64-bit word."""
        return f"UINT64_C({value % 2**64:#x})"


class _C(Body):
    """The operations of a function of x as C statements."""

    x = "x"

    def __init__(self, prefix: str) -> None:
        super().__init__(_Numbers(1))
        self.prefix = prefix

    def _value(self, kind: str, text: str) -> str:
        name = f"t{len(self.lines)}"
        self.lines.append(f"  const {kind} {name} = {text};")
        return name

    def _number(self, value: str | float) -> str:
        return value if isinstance(value, str) else self.lanes.number(value)

    def op(self, name: str, a: str, b: str | float) -> str:
        return self._value("double", f"{a} {_OPERATORS[name]} {self._number(b)}")

    def fma(self, a: str, b: str | float, c: str | float) -> str:
        return self._value("double", f"fma({a}, {self._number(b)}, {self._number(c)})")

    def negative(self, a: str) -> str:
        return self._value("double", f"-{a}")

    def magnitude(self, a: str) -> str:
        return self._value("double", f"fabs({a})")

    def bits(self, a: str) -> str:
        return self._value("uint64_t", f"{self.prefix}own_bits({a})")

    def double(self, a: str) -> str:
        return self._value("double", f"{self.prefix}own_double({a})")

    def whole(self, name: str, a: str, b: str | int) -> str:
        if name == "ashr":  # C leaves open what it does to negative numbers
            assert b == 1
            return self._value("uint64_t", f"({a} >> 1) | ({a} & {self.lanes.whole(1 << 63)})")
        second = b if isinstance(b, str) else str(b) if name == "shl" else self.lanes.whole(b)
        return self._value("uint64_t", f"{a} {_OPERATORS[name]} {second}")

    def select(self, condition: str, a: str | float, b: str | float) -> str:
        return self._value("double", f"{condition} ? {self._number(a)} : {self._number(b)}")

    def compare(self, test: str, a: str, b: float) -> str:
        return self._value("int", f"{a} {_TESTS[test]} {self.lanes.number(b)}")


def own_c(text: str, prefix: str) -> str:
    """Definitions of those of PREFIXown_sincos(x, &sine, &cosine), PREFIXown_sin, _cos and _exp that a text calls."""
    called = [name for name in ("sincos", "sin", "cos", "exp") if f"{prefix}own_{name}(" in text]
    widths = [width for width in WIDTHS if f"{prefix}own_sincos_{width}(" in text]
    called += [f"sincos_{width}" for width in widths]
    if not called:
        return ""
    parts = [_WORDS.format(prefix)]
    if set(called) - {"exp"}:
        body = _C(prefix)
        sine, cosine = sincos_of(body)
        head = f"static inline void {prefix}own_sincos(double x, double *sine, double *cosine) {{"
        parts.append("\n".join([head, *body.lines, f"  *sine = {sine};", f"  *cosine = {cosine};", "}"]))
    for width in widths:
        parts.append(
            f"static APART void {prefix}own_sincos_{width}(const double *restrict x, double *restrict s, "
            f"double *restrict c) {{\n  for (int k = 0; k < {width}; ++k) {prefix}own_sincos(x[k], s + k, c + k);\n}}"
        )
    for name, letter in (("sin", "s"), ("cos", "c")):
        if name in called:
            parts.append(
                f"static inline double {prefix}own_{name}(double x) {{ double s, c; "
                f"{prefix}own_sincos(x, &s, &c); return {letter}; }}"
            )
    if "exp" in called:
        body = _C(prefix)
        value = exp_of(body)
        parts.append(
            "\n".join([f"static inline double {prefix}own_exp(double x) {{", *body.lines, f"  return {value};", "}"])
        )
    return "\n".join([*parts, ""])
