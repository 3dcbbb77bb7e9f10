"""Outputs of a run in lanes, as stages behind the step: the values of runtime/solutions/observe.py, bit for bit.

Each function of the model is called on entries of z, never on expressions of another one, since what CasADi simplifies
across them would round differently.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import casadi as ca

from runtime.contract.coordinates import charts_in, joined
from runtime.contract.model import EmittedModel
from runtime.engine.program import Call, Fields, Layout, Program, Until, make_stage
from runtime.engine.program import Sequence as InSequence
from runtime.results.named_outputs import ORDERS, Column, column
from runtime.schemes.scheme import LARGEST_NUMBER, Scheme
from runtime.solutions.observe import MOST_OBSERVED_CLOSURES, OBSERVED_CLOSURE_TOLERANCE

KERNELS = ("energy", "measures", "reactions", "acceleration_measures")


class Observation:
    """Outputs by name of a scheme on a model; fields: what they add to z; program(layout, c_size): the stages."""

    def __init__(self, model: EmittedModel, scheme: Scheme, names: Sequence[str]) -> None:
        self.model, self.scheme = model, scheme
        self.columns = [column(model, name) for name in names]
        self.kernels = [name for name in KERNELS if any(one.kernel == name for one in self.columns)]
        needed = {suffix for one in self.columns if self._dependent(one) for suffix in one.suffixes}
        read = {name for kernel in self.kernels for name in model.kernel(kernel).name_in()}
        self.dependent = [suffix for suffix in ORDERS if suffix in needed or f"q{suffix}" in read]
        independent = {suffix for one in self.columns for suffix in one.suffixes} | set(self.dependent)
        self.independent = [suffix for suffix in ORDERS if suffix in independent or f"q{suffix}" in read]
        if model.q_d and model.loop_unknowns and self.dependent:
            # the closure is looked at again, with the rates that follow from it
            self.dependent = [suffix for suffix in ORDERS if suffix in {"", "_dot", *self.dependent}]
            self.independent = [suffix for suffix in ORDERS if suffix in {"", "_dot", *self.independent}]
            self.closes = True
        else:
            self.closes = False

    def _dependent(self, one: Column) -> bool:
        columns = range(one.position, one.position + (4 if one.kernel in ("spin", "angle") else 1))
        return bool(one.suffixes) and any(self.model.coordinates[column] in self.model.q_d for column in columns)

    @property
    def fields(self) -> dict[str, int]:
        """What is kept in z: the coordinates that are looked at, and the outputs."""
        found = {"seen_t": 1, "seen_open": 1}
        found |= {f"seen_i{suffix}": len(self.model.q_i) for suffix in self.independent}
        found |= {f"seen_d{suffix}": len(self.model.q_d) for suffix in self.dependent}
        return {**found, "outputs": len(self.columns)}

    def program(self, layout: Layout, c_size: int) -> Program:
        """Observe, close, evaluate: z has a field `scheme`, c begins with what the scheme's stages read."""
        parts: list[Program] = [make_stage("observed", layout, c_size, self._observed)]
        if self.closes:
            body = InSequence(
                (
                    make_stage("observed_closure", layout, c_size, self._closed),
                    make_stage("observed_rates", layout, c_size, self._rates),
                )
            )
            parts.append(Until(body, layout.slice("seen_open").start, MOST_OBSERVED_CLOSURES, 1))
        parts += [self._kernel_stage(layout, c_size, name) for name in self.kernels]
        if any(one.suffixes for one in self.columns):
            parts.append(make_stage("observed_state", layout, c_size, self._states))
        return InSequence(tuple(parts))

    def _observed(self, z: Fields, c: ca.SX) -> Mapping[str, ca.SX]:
        observed = self.scheme.observer(z=z["scheme"], c=c[: self.scheme.c_size])
        found = {f"seen_i{suffix}": observed[f"q_i{suffix}"] for suffix in self.independent}
        found |= {f"seen_d{suffix}": observed[f"q_d{suffix}"] for suffix in self.dependent}
        return {**found, "seen_t": observed["t"], "seen_open": ca.SX(1)}

    def _closed(self, z: Fields, c: ca.SX) -> Mapping[str, ca.SX]:
        charts, q_d, c = self.scheme.charts, z["seen_d"], c[: self.model.c_size]
        if charts.size:  # where the bodies are, as turns are observed at zero
            whole, at = joined(self.model, z["seen_i"], q_d), charts_in(self.model)
            e = whole[self.model.places.parameters.ravel().tolist()]
            c, q_d = ca.vertcat(c[: at.start], e, c[at.stop :]), charts.zeroed_dependent(q_d)
        found = self.model.evaluate("closure", q_i=z["seen_i"], q_d=q_d, t=z["seen_t"], c=c)
        tolerance = OBSERVED_CLOSURE_TOLERANCE * ca.fmax(1, ca.norm_inf(q_d))
        finite = ca.sum1(ca.fabs(found["q_d_next"])) < LARGEST_NUMBER
        open_ = ca.logic_and(ca.norm_inf(found["C_loop"]) > tolerance, finite)
        return {"seen_open": open_, "seen_d": ca.if_else(open_, found["q_d_next"], q_d)}

    def _rates(self, z: Fields, c: ca.SX) -> Mapping[str, ca.SX]:
        at = {"q_i": z["seen_i"], "q_d": z["seen_d"], "q_i_dot": z["seen_i_dot"], "t": z["seen_t"]}
        rates = self.model.evaluate("velocities", **at, c=c[: self.model.c_size])["q_d_dot"]
        return {"seen_d_dot": ca.if_else(z["seen_open"] > 0, rates, z["seen_d_dot"])}

    def _kernel_stage(self, layout: Layout, c_size: int, name: str) -> Call:
        def body(z: Fields, c: ca.SX) -> Mapping[str, ca.SX]:
            at = {f"q{suffix}": self._whole(z, suffix) for suffix in ORDERS}
            at |= {"t": z["seen_t"], "lam_R": ca.SX.zeros(len(self.model.redundant))}
            found = self.model.evaluate(name, **at, c=c[: self.model.c_size])
            outputs = ca.SX(z["outputs"])
            for k, one in enumerate(self.columns):
                if one.kernel == name:
                    outputs[k] = ca.vec(found[one.part])[one.position]
            return {"outputs": outputs}

        return make_stage(f"observed_{name}", layout, c_size, body)

    def _states(self, z: Fields, c: ca.SX) -> Mapping[str, ca.SX]:
        outputs = ca.SX(z["outputs"])
        for k, one in enumerate(self.columns):
            if one.suffixes:
                outputs[k] = one.of_state(lambda suffix: self._whole(z, suffix))
        return {"outputs": outputs}

    def _whole(self, z: Fields, suffix: str) -> ca.SX:
        """A vector in the order of the coordinates, as far as it is known."""
        model = self.model
        sizes = {"i": len(model.q_i), "d": len(model.q_d)}
        parts = (z.get(f"seen_{kind}{suffix}", ca.SX.zeros(size)) for kind, size in sizes.items())
        return ca.densify(joined(model, *parts))
