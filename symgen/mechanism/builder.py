"""A scene written in Python. The builder collects entries; the schema checks them once, in `build`."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache, partial
from inspect import Parameter, Signature
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self, get_args, get_origin, overload

import numpy as np
from pydantic.fields import FieldInfo

from runtime.contract.arguments import PLACE
from runtime.contract.lazy_method import LazyMethod
from symgen.couplings import COUPLINGS
from symgen.joints import JOINTS
from symgen.loads import LOADS
from symgen.mechanism.entry_docs import alternatives, entry_doc
from symgen.mechanism.scene import SceneRecord
from symgen.scene.bodies import BeamBody, GroundBody, RigidBody
from symgen.scene.flexible import ModalBody, SpatialModalBody, Structure
from symgen.scene.measures import (
    CoordinateMeasure,
    ExpressionMeasure,
    ForceMeasure,
    MarkerMeasure,
    SectionForceMeasure,
    StressMeasure,
)
from symgen.scene.parts import DeclaredInput, DeclaredParameter, DeclaredState
from symgen.scene.simulation import DeclaredEvent, Simulation
from symgen.scene.surfaces import SurfaceTable
from symgen.scene.tables import CurveTable, read_points
from symgen.scene.translate import item_path
from symgen.schema.errors import SceneError, did_you_mean, show
from symgen.schema.fields import StrictModel

if TYPE_CHECKING:
    from runtime.model import Model
    from symgen.fe import FEStructure, FlexibleBody
    from symgen.mechanism.entries import SceneEntries
    from symgen.scene.structures import MatrixData, StructureScene
else:
    SceneEntries = object

MAX_NESTING = 20
SYMBOLIC_AT_MOST = 60  # coordinates of a structure of dense numbers that is still written out as equations


class Scene(SceneEntries):
    """A mechanism to be written down: each method adds an entry and returns the scene; `model()` derives it.

        Scene("arm").rigid("rod", mass=1.0, inertia=0.1).revolute("hinge", "ground.origin", "rod.origin").model()

    Each type of body, joint, coupling and load has a method of its name; `help(Scene.revolute)` lists its parameters.
    Values are in SI units: numbers, expressions in quotes, lists or NumPy arrays. A wrong keyword, type or name raises
    SceneError at the call; values are checked by `build`, which `model` calls: it raises SceneError with the item, the
    problem and the remedy.
    """

    def __init__(self, name: str, **fields: Any) -> None:
        """Begin an empty scene.

        Parameters
        ----------
        name : str
            Name of the scene and of its model: letters, digits and underscores.
        **fields
            title, description : str, for pages; space : {"planar", "spatial"}, "planar" if left out.

        Raises
        ------
        SceneError
            For an unknown keyword; in `build` for wrong values.
        """
        _require_known("scene", SceneRecord, fields)
        self._data: dict[str, Any] = {"name": name, **_plain(fields, "scene")}

    @classmethod
    def from_toml(cls, path: str | Path) -> Scene:
        """Read a scene from a TOML file; entries can be added.

        Parameters
        ----------
        path : str or Path
            The file; matrices, tables and meshes that it names are read from beside it.

        Returns
        -------
        Scene
            A builder that holds the entries of the file.

        Raises
        ------
        SceneError
            For a file that cannot be read, and for what is wrong in it.
        """
        _require_path(path)
        found = cls("")
        found._data = SceneRecord.from_toml(path).to_dict()
        return found

    def parameter(self, name: str, default: float, unit: str = "", description: str = "") -> Self:
        """Declare a number that runs can change by name, without a new derivation; expressions may use it.

        Parameters
        ----------
        name : str
            Name by which expressions, results and messages refer to it.
        default : float
            Its value [unit] where a run gives none.
        unit : str, optional
            Its unit, for pages and reports.
        description : str, optional
            What it is, for pages and reports.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            For a name that is no text or declared twice, or an unknown keyword; in `build` for wrong values.
        """
        return self._declare("parameters", name, {"default": default, "unit": unit, "description": description})

    def input(self, name: str, default: float = 0.0, unit: str = "", description: str = "", **fields: Any) -> Self:
        """Declare a value that comes from outside during a run.

        Parameters
        ----------
        name : str
            Name by which expressions, results and messages refer to it.
        default : float
            Its value [unit] where a run gives none.
        unit : str, optional
            Its unit, for pages and reports.
        description : str, optional
            What it is, for pages and reports.
        **fields
            rates : bool, whether it comes with `<name>_dot` and `<name>_ddot`, as prescribed motions need; filter :
            float [rad/s], bandwidth of a filter of second order, for whose value and rates the name then stands.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            For a name that is no text or declared twice, or an unknown keyword; in `build` for wrong values.
        """
        return self._declare("inputs", name, {"default": default, "unit": unit, "description": description, **fields})

    def table(self, name: str, **fields: Any) -> Self:
        """Declare a table for expressions, `name(x)` or `name(x, y)`: a curve, a surface over a grid, or a CSV file.

        Parameters
        ----------
        name : str
            Name by which expressions, results and messages refer to it.
        **fields
            x, y : array_like, shape (n,), points of a curve; of a surface x (n,), y (k,) and z (n, k).
            interpolation : {"linear", "cubic", "monotone"}; outside : {"hold", "extend"}, beyond the ends;
            integrated : {0, 1, 2}, how often the curve is integrated; file : path of a CSV file, which is read now;
            columns : its two columns, (0, 1) if left out; description : str.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            For a file that cannot be read, a name that is no text or declared twice, an unknown keyword; in
            `build` for wrong values.
        """
        if "file" in fields:
            path, columns = fields.pop("file"), fields.pop("columns", (0, 1))
            fields |= read_points(path, columns, f"tables.{name}")
        return self._declare("tables", name, fields)

    def event(self, name: str, when: float | str, **fields: Any) -> Self:
        """Declare an event where the expression `when` passes zero; runs find its time.

        Parameters
        ----------
        name : str
            Name by which expressions, results and messages refer to it.
        when : float or expression
            An expression of parameters, inputs, t, measures, their rates and states.
        **fields
            direction : {"rising", "falling", "either"}, the way through zero that counts, "either" if left out;
            terminal : bool, whether the run ends there; action : mapping of inputs and parameters to their new
            values, numbers or expressions; cool_down : float [s], for how long it is not looked for again;
            description : str.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            For a name that is no text or declared twice, or an unknown keyword; in `build` for wrong values.
        """
        return self._declare("events", name, {"when": when, **fields})

    def state(self, name: str, rate: float | str, initial: float = 0.0, unit: str = "", description: str = "") -> Self:
        """Declare a state with s' = rate, of a controller, a filter or an actuator.

        Parameters
        ----------
        name : str
            Name by which expressions, results and messages refer to it.
        rate : float or expression
            Its rate [unit/s], of parameters, inputs, t, measures, their rates and states.
        initial : float
            Its value [unit] at the start.
        unit : str, optional
            Its unit, for pages and reports.
        description : str, optional
            What it is, for pages and reports.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            For a name that is no text or declared twice, or an unknown keyword; in `build` for wrong values.
        """
        fields = {"rate": rate, "initial": initial, "unit": unit, "description": description}
        return self._declare("states", name, fields)

    def gravity(self, *components: float | str) -> Self:
        """Set the acceleration of gravity in world axes.

        Parameters
        ----------
        *components : float or expression
            x, y and, in a spatial scene, z [m/s^2]; a z left out is zero.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            In `build` for a wrong number of components and for what is not a quantity.
        """
        return self._set("gravity", list(components))

    def ground(self, **fields: Any) -> Self:
        """Add markers to the ground, which is there without being added.

        Parameters
        ----------
        **fields
            markers : mapping, ``{"name": {"position": [x, y], "angle": phi}}`` [m, rad], in space with axis and
            x_axis in place of the angle; shape : how pictures show the ground.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, type or name; in `build` and `model` for wrong values.
        """
        return self._add("bodies", "ground", "ground", fields)

    def joint(self, type: str, name: str, marker_a: str, marker_b: str, **fields: Any) -> Self:
        """Add a joint of the type with this name; each type has a method of its name, too.

        Parameters
        ----------
        type : str
            Such as "revolute".
        name : str
            Name of the joint.
        marker_a, marker_b : str
            The markers that it joins, `"body.marker"`.
        **fields
            Those of the method of the type's name, such as `Scene.revolute`.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, type or name; in `build` and `model` for wrong values.

        Notes
        -----
        Its rows are part of C(q, t) = 0 (Eq. 21).
        """
        return self._add("joints", type, name, {"marker_a": marker_a, "marker_b": marker_b, **fields})

    if not TYPE_CHECKING:  # checkers know all methods, and refuse others

        def __getattr__(self, type: str) -> Callable[..., Self]:
            """Raise AttributeError for a name that no method has, with the nearest one that is there."""
            if type.startswith("_"):
                raise AttributeError(type)
            methods = [name for name in dir(Scene) if not name.startswith("_")]
            raise AttributeError(f"a scene has no method {show(type)}; {did_you_mean(type, methods)}")

    def force(self, name: str, marker: str, *components: float | str, **fields: Any) -> Self:
        """Add a force at a marker.

        Parameters
        ----------
        name : str
            Name of the load.
        marker : str
            Where it acts, `"body.marker"`.
        *components : float or expression
            x, y and, in a spatial scene, z [N]; of parameters, inputs, t, measures, states and their rates.
        **fields
            frame : {"world", "body"}, the axes of the components, "world" if left out.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, type or name; in `build` and `model` for wrong values.
        """
        return self._add("loads", "force", name, {"marker": marker, "components": list(components), **fields})

    def load(self, type: str, name: str, **fields: Any) -> Self:
        """Add a load of the type with this name; each type has a method of its name, too.

        Parameters
        ----------
        type : str
            Such as "spring_damper".
        name : str
            Name of the load.
        **fields
            Those of the method of the type's name, such as `Scene.spring_damper`.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, type or name; in `build` and `model` for wrong values.
        """
        return self._add("loads", type, name, fields)

    def measure(self, name: str, type: str, of: str, relative_to: str = "ground.origin", **fields: Any) -> Self:
        """Add a measure, which results have by its name, and expressions with its rate `<name>_dot`.

        Parameters
        ----------
        name : str
            Name by which expressions, results and messages refer to it.
        type : str
            "angle" [rad], "distance", "x", "y" or "z" [m] of a marker relative to another one; "coordinate" [m,
            rad]; "normal_force", "shear_force", "shear_force_z" [N], "bending_moment", "bending_moment_y",
            "torsion_moment" [N m] at a marker of a beam; "stress" [Pa]; "force" [N] or "moment" [N m] of a load;
            "expression", in any unit.
        of : str
            What is measured: `"body.marker"`, a coordinate, for a stress also `"body.gauge"` of a finite-element body
            and `"body.all"`, the largest; the name of a load; or the text of an expression of coordinates and their
            rates, measures, states, inputs, t, parameters and tables, such as `"torque*crank.theta_dot"`.
        relative_to : str
            The marker against which a marker is measured.
        **fields
            component : {"von_mises", "xx", "yy", "zz", "yz", "xz", "xy", "mesh_error"} of a stress, {"own", "x", "y",
            "z"} of a force or moment; axes : "world", or `"body.marker"` in whose axes x, y, z are taken; unit : str,
            of an expression.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword, type or name; in `build` and `model` for wrong values.
        """
        usual = isinstance(relative_to, str) and relative_to == "ground.origin"
        base = {} if usual else {"relative_to": relative_to}
        return self._add("measures", type, name, {"of": of, **base, **fields})

    @overload
    def structure(
        self,
        *,
        mass: MatrixData = ...,
        stiffness: MatrixData = ...,
        body: FlexibleBody | FEStructure = ...,
        damping: MatrixData | Mapping[str, float] | None = ...,
        force: Any = ...,
        coordinates: Sequence[str] = ...,
        width: int = ...,
        points: Any = ...,
        cells: Any = ...,
        fixed: Sequence[str | int] = ...,
        lump: bool | str = ...,
    ) -> StructureScene: ...
    @overload
    def structure(self, **fields: Any) -> Self: ...
    def structure(
        self,
        *,
        mass: Any = None,
        stiffness: Any = None,
        damping: Any = None,
        body: Any = None,
        fixed: Any = None,
        lump: Any = None,
        force: Any = None,
        coordinates: Any = None,
        width: Any = None,
        points: Any = None,
        cells: Any = None,
        **more: Any,
    ) -> Self | StructureScene:
        """Describe M x'' + D x' + K x = F(t) instead of bodies (Eqs. 3-14).

        Parameters
        ----------
        mass, stiffness, damping : (n, n) [kg, N/m, N s/m]
            Lists of numbers and expressions are written out as equations. SciPy sparse matrices, large arrays and
            MatrixMarket files are data: nothing is written out, and groups of nodes step as often as each needs. A
            mass (n,) is lumped; damping may be ``{"mass": a, "stiffness": b}`` (Rayleigh) [1/s, s].
        body : FlexibleBody or FEStructure, optional
            K and M of a body of solid elements of `symgen.fe`.
        fixed : list of str or int, optional
            Interfaces and ids of nodes of the body that are held.
        lump : bool or "row_sum", optional
            Make a consistent mass diagonal: explicit steps need that.
        force : mapping, list or list of pairs [N], optional
            By coordinate, ``{"n3.x": "1e3 * sin(t)"}``; one a coordinate; or pairs (pattern (n,), expression of t).
        coordinates : list of str, optional
            n names.
        width : int, optional
            Coordinates of a node, side by side.
        points : (nodes, 2 or 3) [m], optional
            For pictures.
        cells : (cells, corners), optional
            For pictures.

        Returns
        -------
        Scene or StructureScene
            The latter for data; its `model()` is a `StructureModel`.

        Raises
        ------
        SceneError
            For an unknown keyword, for data beside entries that do not go with it; in `build` for wrong values.
        """
        given = {
            "mass": mass, "stiffness": stiffness, "damping": damping, "body": body, "fixed": fixed, "lump": lump,
            "force": force, "coordinates": coordinates, "width": width, "points": points, "cells": cells,
        }  # fmt: skip
        fields = {name: value for name, value in given.items() if value is not None} | more
        if "body" in fields or any(_is_data(fields.get(name)) for name in ("mass", "stiffness", "damping")):
            from symgen.scene.structures import StructureScene

            if extra := sorted(self._data.keys() - {"name", "title", "description", "parameters", "space"}):
                raise SceneError(extra[0], "does not go with a structure", "remove it")
            declared = {name: float(entry["default"]) for name, entry in self._data.get("parameters", {}).items()}
            return StructureScene(self._data["name"], self._data.get("title", ""), declared, fields)
        _require_known("structure", Structure, fields)
        return self._set("structure", fields)

    def independent(self, *coordinates: str) -> Self:
        """Choose the independent coordinates q_i; left out, they are found.

        Parameters
        ----------
        *coordinates : str
            Names such as `"crank.theta"`, one for each degree of freedom.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            In `build` and `model` for names and choices that cannot be used.

        Notes
        -----
        The rest are dependent: q_d follows from C(q, t) = 0 (Eqs. 29-38).
        """
        return self._merge("partition", {"independent": list(coordinates)})

    def groups(self, **groups: Any) -> Self:
        """Name groups of coordinates, slow to fast, for schemes with sub-steps.

        Parameters
        ----------
        **groups : sequence of str
            Name of the group to names or patterns of its coordinates, such as ``fast=["rod.q_f*"]``.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            In `build` for coordinates that are not there, or in two groups.

        Notes
        -----
        Each group takes m of its steps in one of the group before (Eqs. 39, 72).
        """
        entries = [{"name": name, "coordinates": coordinates} for name, coordinates in groups.items()]
        return self._merge("partition", {"groups": entries})

    def stiff(self, *names: str) -> Self:
        """Choose the stiff deflections, which the exponential schemes solve exactly.

        Parameters
        ----------
        *names : str
            Names or patterns of elastic coordinates and of rotational springs.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            In `build` and `model` for what is no stiff deflection.
        """
        return self._merge("partition", {"stiff": list(names)})

    def initial(self, coordinates: dict[str, Any]) -> Self:
        """Set starting coordinates by name; calls add up. Rates at the start have a method of their own, `rates`.

        Parameters
        ----------
        coordinates : mapping
            Name to a number [m, rad] or to ``{"value": ..., "fixed": True}``, which the search for a closed
            configuration may not move.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            For what is not a mapping with names; in `build` for unknown names.
        """
        return self._start("coordinates", coordinates)

    def rates(self, rates: dict[str, Any]) -> Self:
        """Set starting rates by name; calls add up.

        Parameters
        ----------
        rates : mapping
            Name of the coordinate to a number [m/s, rad/s] or to ``{"value": ..., "fixed": True}``.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            For what is not a mapping with names; in `build` for unknown names.
        """
        return self._start("rates", rates)

    def simulation(self, **fields: Any) -> Self:
        """Set what runs use by default; `simulate` has the same arguments.

        Parameters
        ----------
        **fields
            t_end : float [s]; scheme : str; tolerance : float [1]; dt : float [s]; m : list of int, sub-steps of
            each group; seen_every : float [s], time between samples; start : {"given", "quasi_static",
            "quasi_static_unstable", "equilibrium"}.

        Returns
        -------
        Scene
            The scene itself, so that calls can follow one another.

        Raises
        ------
        SceneError
            At the call for an unknown keyword; in `build` for wrong values.
        """
        _require_known("simulation", Simulation, fields)
        return self._set("simulation", fields)

    def build(self) -> SceneRecord:
        """Check the scene and freeze it.

        Returns
        -------
        SceneRecord
            The checked scene.

        Raises
        ------
        SceneError
            With the item, the problem and the remedy, for anything that is wrong.
        """
        return SceneRecord.from_dict(self._data)

    def to_toml(self, path: str | Path | None = None) -> str:
        """Write the scene as TOML text, for `from_toml` and the command line.

        Parameters
        ----------
        path : str or Path, optional
            File that the text is written to.

        Returns
        -------
        str
            The text.

        Raises
        ------
        SceneError
            For a scene that `build` refuses, and for what is not a path.
        OutputError
            For a place that cannot be written.
        """
        if path is not None:
            _require_path(path)
        text = self.build().to_toml()
        if path is not None:
            from runtime.contract.files import write_text

            write_text(Path(path), text)
        return text

    def model(self) -> Model:
        """Derive the equations, ready to run; the generated code is kept in the cache.

        Returns
        -------
        Model
            The mechanism with all that can be asked of it: `simulate`, `equilibrium`, `modes` and so on.

        Raises
        ------
        SceneError
            For a scene that `build` refuses, and for one whose equations cannot be derived.

        Notes
        -----
        The equations of motion (Eqs. 15-28) are condensed to M_hat q_i'' = Q_hat (Eqs. 29-38).
        `symgen.generate.generate(scene.build(), folder)` keeps the code in a folder of your own.

        References
        ----------
        J. C. Miao, P. Zhu, G. L. Shi, G. L. Chen, Study on sub-cycling algorithm for flexible multi-body system:
        integral theory and implementation flow chart, Comput. Mech. 41 (2008) 257-268.
        """
        return self.build().model()

    def _declare(self, section: str, name: str, fields: dict[str, Any]) -> Self:
        if not isinstance(name, str):
            raise SceneError(section, f"the name {show(name)} is not text", "give a name first")
        _require_known(f"{section}.{name}", DECLARED[section], fields)
        declared = self._data.setdefault(section, {})
        if name in declared:
            raise SceneError(f"{section}.{name}", "is declared twice", "remove one of them")
        declared[name] = _plain(fields, section)
        return self

    def _set(self, section: str, value: Any) -> Self:
        self._data[section] = _plain(value, section)
        return self

    def _merge(self, section: str, value: dict[str, Any]) -> Self:
        self._data[section] = {**self._data.get(section, {}), **_plain(value, section)}
        return self

    def _start(self, kind: str, values: dict[str, Any]) -> Self:
        if not isinstance(values, Mapping) or not all(isinstance(key, str) for key in values):
            raise SceneError(f"initial.{kind}", f"{show(values)} is not a table", 'give names: {"rod.theta": 0.1}')
        start = self._data.setdefault("initial", {})
        start[kind] = {**start.get(kind, {}), **_plain(values, "initial")}
        return self

    def _add(self, section: str, type: str, name: str, fields: dict[str, Any]) -> Self:
        path = item_path(section, len(self._data.get(section, ())), name)
        if not isinstance(type, str) or type not in RECORDS[section]:
            raise SceneError(f"{path}.type", f"unknown type {show(type)}", did_you_mean(type, RECORDS[section]))
        if not isinstance(name, str):
            raise SceneError(f"{path}.name", f"{show(name)} is not text", "give text")
        _require_known(path, RECORDS[section][type], fields)
        self._data.setdefault(section, []).append(_plain({"type": type, "name": name, **fields}, section))
        return self

    def _change(self, section: str, name: str, fields: dict[str, Any]) -> Self:
        """Set fields of the entry of this name; None removes one."""
        (entry,) = [one for one in self._data[section] if one["name"] == name]
        for key, value in _plain(fields, section).items():
            if value is None:
                entry.pop(key, None)
            else:
                entry[key] = value
        return self


def _require_path(path: Any) -> None:
    if not PLACE.holds(path):
        raise SceneError("path", f"{show(path)} is not a path", PLACE.wanted)


def _require_known(
    path: str, record: type[StrictModel] | Sequence[type[StrictModel]], fields: Mapping[str, Any]
) -> None:
    """Raises SceneError for the first field that the record has not, nor any of several, and for those inside."""
    known = dict.fromkeys(key for one in _several(record) for key in one.model_fields)
    for key, value in fields.items():
        item = str(key) if path == "scene" else f"{path}.{key}"
        if key not in known:
            raise SceneError(item, f"unknown key {show(key)}", did_you_mean(key, known))
        if isinstance(value, Mapping):
            _require_known_inside(
                item, [one.model_fields[key] for one in _several(record) if key in one.model_fields], value
            )


def _require_known_inside(path: str, places: Sequence[FieldInfo], value: Mapping[str, Any]) -> None:
    """The same of a table that a field holds, or of each table in one by names, such as markers."""
    kinds = [kind for place in places for kind in alternatives(place.annotation)]
    records = [kind for kind in kinds if _is_record(kind)]
    by_name = [get_args(kind)[1] for kind in kinds if get_origin(kind) is dict]
    if records and not by_name:
        _require_known(path, records, value)
    elif by_name and not records and all(_is_record(kind) for kind in by_name):
        for name, part in value.items():
            if isinstance(part, Mapping):
                _require_known(f"{path}.{name}", by_name, part)


def _is_record(kind: Any) -> bool:
    return isinstance(kind, type) and issubclass(kind, StrictModel)


def _several(record: type[StrictModel] | Sequence[type[StrictModel]]) -> Sequence[type[StrictModel]]:
    return record if isinstance(record, Sequence) else [record]


def _plain(value: Any, item: str, depth: int = 0) -> Any:
    """NumPy arrays and scalars, and tuples, as the lists and numbers a TOML file would give."""
    if depth > MAX_NESTING:
        raise SceneError(item, "is nested too deeply", "give plain numbers, lists and dictionaries")
    if isinstance(value, set | frozenset):
        raise SceneError(item, f"{show(value)} has no order", "give a list instead of a set")
    if isinstance(value, dict):
        return {key: _plain(part, item, depth + 1) for key, part in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(part, item, depth + 1) for part in value]
    if hasattr(value, "tolist"):
        return value.tolist()
    return value


def _is_data(matrix: Any) -> bool:
    """Is this a sparse matrix, a file or a large array of numbers: nothing to be written out?"""
    if isinstance(matrix, np.ndarray):
        return matrix.ndim > 0 and len(matrix) > SYMBOLIC_AT_MOST
    return isinstance(matrix, str | Path) or hasattr(matrix, "tocsr")


def _method(section: str, type: str, record: type[StrictModel]) -> Callable[..., Scene]:
    """A method that adds an entry of this type: required fields by place or by name, the others by name."""
    own = {key: field for key, field in record.model_fields.items() if key not in ("type", "name")}
    needed = [key for key, field in own.items() if field.is_required()]
    free = [key for key in own if key not in needed]

    def add(self: Scene, name: str, *values: Any, **fields: Any) -> Scene:
        placed = dict(zip(needed, values, strict=False))
        if len(values) > len(needed):
            problem = f"{show(values[len(needed)])} is one value too many: {type}({', '.join(['name', *needed])})"
            raise SceneError(f"{section} {show(name)}", problem, f"name it: {', '.join(free) or 'none'}")
        if twice := sorted(placed.keys() & fields.keys()):
            raise SceneError(
                f"{section} {show(name)}.{twice[0]}", "is given twice, by position and by name", "give it once"
            )
        return self._add(section, type, name, {**placed, **fields})

    either, named = Parameter.POSITIONAL_OR_KEYWORD, Parameter.KEYWORD_ONLY
    known = [Parameter(key, either) for key in ("self", "name", *needed)]
    defaults = {key: None if own[key].default_factory else own[key].default for key in free}
    optional = [Parameter(key, named, default=default) for key, default in defaults.items()]
    add.__name__, add.__qualname__, add.__doc__ = type, f"Scene.{type}", entry_doc(section, type, record)
    add.__signature__ = Signature([*known, *optional])  # type: ignore[attr-defined]
    return add


BODIES: dict[str, type[StrictModel]]
BODIES = {"rigid": RigidBody, "beam": BeamBody, "modal": ModalBody, "flexible": SpatialModalBody}
RECORDS: dict[str, Mapping[str, type[StrictModel]]] = {
    "bodies": {"ground": GroundBody, **BODIES},
    "joints": JOINTS,
    "couplings": COUPLINGS,
    "loads": LOADS,
    "measures": {
        kind: record
        for record in (
            MarkerMeasure,
            CoordinateMeasure,
            SectionForceMeasure,
            StressMeasure,
            ExpressionMeasure,
            ForceMeasure,
        )
        for kind in get_args(record.model_fields["type"].annotation)
    },
}
DECLARED: dict[str, type[StrictModel] | Sequence[type[StrictModel]]] = {
    "parameters": DeclaredParameter,
    "inputs": DeclaredInput,
    "states": DeclaredState,
    "events": DeclaredEvent,
    "tables": (CurveTable, SurfaceTable),
}

ENTRIES: dict[str, Mapping[str, type[StrictModel]]]
ENTRIES = {"bodies": BODIES, "joints": JOINTS, "couplings": COUPLINGS, "loads": LOADS}
for _section, _records in ENTRIES.items():
    for _type, _record in _records.items():
        if not hasattr(Scene, _type):
            setattr(
                Scene, _type, LazyMethod(cache(partial(_method, _section, _type, _record)))
            )  # its docstring takes time
