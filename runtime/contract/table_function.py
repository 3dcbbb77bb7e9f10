"""Tables as CasADi Functions. This text stands in every emitted model that has tables, so it imports CasADi only."""

# mypy: disable-error-code="type-arg, no-any-return, list-item, arg-type"
import casadi as ca

# the scene's tables by name: data.json has their numbers, load_model puts them here
TABLES: dict[str | int, dict] = {}


def table(name: str | int, order: int = 0) -> ca.Function:
    """What a table gives at x, or its derivative of this order, as a Function of x.

    Row r of its polynomials, in powers of x - knots[r], holds from knots[r] to before knots[r + 1]. Buckets of one
    length tell about where x lies, halving finds the row.
    """
    data = TABLES[name]
    known = data.setdefault("functions", {})
    if order in known:
        return known[order]
    powers = data["powers"]
    for _ in range(order):
        powers = [[k * entry for entry in powers[k]] for k in range(1, len(powers))] or [[0.0] * len(powers[0])]

    def entries(columns: list[list[float]], k: ca.MX) -> ca.MX:  # of row k: a look-up that copies no array
        rows = [entry for row in zip(*columns, strict=True) for entry in row]
        return ca.interpolant("rows", "linear", [range(len(columns[0]))], rows, {"lookup_mode": ["exact"]})(k)

    x = ca.MX.sym("x")
    inside = ca.fmin(x, data["last"])
    row = ca.floor(ca.fmax((inside - data["left"]) * data["scale"], 0))
    if data["starts"]:
        row = entries([data["starts"]], row)
    for level in reversed(range(data["levels"])):
        row += 2**level * (inside >= entries([data["knots"]], row + 2**level))
    beyond, found = x - entries([data["knots"]], row), entries(powers, row)
    y = found[len(powers) - 1]
    for k in reversed(range(len(powers) - 1)):
        y = found[k] + beyond * y
    own, more = f"table_{data['key']}_{order}", table(name, order + 1)(x) if len(powers) > 1 else ca.MX(ca.DM(0.0))
    slope = ca.Function(f"jac_{own}", [x, ca.MX.sym("y")], [more], ["x", "out_y"], ["jac_y_x"])
    options = {"never_inline": True, "custom_jacobian": slope, "enable_forward": False, "enable_reverse": False}
    known[order] = ca.Function(own, [x], [y], ["x"], ["y"], options)
    return known[order]
