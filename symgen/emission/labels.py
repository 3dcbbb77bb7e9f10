"""Names in the emitted text: of the entries of every argument, and of the rows and columns of every output."""

from __future__ import annotations

import keyword
import re
from collections.abc import Iterable, Sequence

import casadi as ca

from runtime.contract.tape import Tape
from symgen.notation.symbols import BY_NAME
from symgen.pipeline import Derived

# what the emitted functions call their own: temporaries, arguments, outputs
RESERVED = re.compile(
    r"^(w\d+|c\d*|p\d*|t|ca|table|lam_R\d*|crossing\d*|interface\d*|shift\d*|push\d*|q\w*|M\w*|C\w*|Q\w*|inputs|outputs)$"
)


def local_names(names: Iterable[str], taken: Iterable[str] = ()) -> list[str]:
    """Distinct Python identifiers for names, clear of those taken and of what the emitted functions use themselves."""
    used = set(taken)
    chosen: list[str] = []
    for name in names:
        text = re.sub(r"\W+", "_", name).strip("_")
        if RESERVED.match(text) or text in BY_NAME or keyword.iskeyword(text) or text[:1].isdigit():
            text = f"x_{text}"
        while text in used:
            text += "_"
        chosen.append(text)
        used.add(text)
    return chosen


class Labels:
    """Names of a model's entries: `arguments` by input name, `tables` by key, rows of outputs by symbol of size."""

    def __init__(self, derived: Derived) -> None:
        eq, choice = derived.system.equations, derived.system.choice
        reduced = derived.system.reduced
        names = local_names(reduced.names)
        self.plain = names[: len(eq.names)]
        q_i, q_d = [names[c] for c in choice.independent], [names[c] for c in derived.dependent]
        slow = [k for group in derived.groups[:-1] for k in group.positions]
        self.arguments = {"q": self.plain, "q_i": q_i, "q_d": q_d, "t": ["t"]}
        for source in ("q", "q_i", "q_d"):
            self.arguments[f"{source}_dot"] = [f"{name}_dot" for name in self.arguments[source]]
            self.arguments[f"{source}_ddot"] = [f"{name}_ddot" for name in self.arguments[source]]
        omega = {f"{name}_dot": name.replace("turn_", "omega_") for name in names[len(eq.names) :]}
        for rates in ("q_i_dot", "q_d_dot"):
            self.arguments[rates] = [omega.get(name, name) for name in self.arguments[rates]]
        charts = [f"{turning.body}.chart_{k}" for turning in reduced.turnings for k in range(4)]
        self.arguments["chart"] = local_names(charts, names)
        self.arguments["lam_R"] = [f"lam_R{k}" for k in range(len(derived.redundant))]
        self.arguments["q_L_ddot"] = [f"{q_i[k]}_ddot" for k in slow]
        if "slow_response" in derived.tapes:
            crossing = derived.functions["slow_response"].outputs[-1].size[0]
            self.arguments["crossing"] = [f"crossing{k}" for k in range(crossing)]
        if "trunk_response" in derived.tapes:
            interface = derived.functions["trunk_response"].outputs[-1].size[0]
            self.arguments["interface"] = [f"interface{k}" for k in range(interface)]
        if "shifted_solution" in derived.tapes:
            sizes = {signal.name: signal.size[0] for signal in derived.functions["shifted_solution"].inputs}
            self.arguments |= {name: [f"{name}{k}" for k in range(sizes[name])] for name in ("shift", "push")}
        moving = [f"{name}{end}" for name in names for end in ("", "_dot", "_ddot")]
        moving += [*omega.values(), *self.arguments["chart"]]
        self.arguments["p"] = local_names((entry.name for entry in derived.parameters), moving)
        self.tables = {table.curve.key: name for name, table in derived.scene.tables.items()}
        self.arguments["u"] = local_names(eq.u, [*moving, *self.arguments["p"]])
        self.arguments["c"] = self._constants(derived.tapes["constants"])
        independent = [reduced.names[c] for c in choice.independent]
        self.rows: dict[str, list[str]] = {
            "n": eq.names,
            "n_i": independent,
            "n_d": [reduced.names[c] for c in derived.dependent],
            "n_c": [row.label for row in eq.constraints],
            "n_const": self.arguments["c"],
            "loops": [eq.constraints[row].label for row in choice.loop_rows],
            "joints": eq.joints,
            "measures": list(eq.measures),
            "events": list(eq.events),
            "conditions in t": [item for item, _ in eq.switching],
        }
        self.rows |= {f"n_{group.name}": [independent[k] for k in group.positions] for group in derived.groups}

    def _constants(self, tape: Tape) -> list[str]:
        """An entry of c that is a parameter keeps its name, the others are counted."""
        found = []
        for k, entry in enumerate(tape.outputs[0]):
            node = tape.nodes[entry]
            found.append(self.arguments["p"][node.b] if node.op == ca.OP_INPUT else f"c{k}")
        return found

    def along(self, shape: str, size: Sequence[int]) -> list[list[str]]:
        """Names along each side of an output of this shape; [] for a side whose entries have none."""
        found = [self.rows.get(symbol, []) for symbol in shape.split(" x ")]
        found += [[]] * (2 - len(found))
        return [names if len(names) == count else [] for names, count in zip(found, size, strict=True)]
