"""Solution: access by name, interpolation, energy balance, and files that read back exactly."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
import pytest
from scipy.io import loadmat

from runtime import Group, ModelError, OutputError, Solution, Status, linearise, load_model, simulate
from runtime.contract.files import replacing, write_text
from runtime.contract.records import (
    BodyRecord,
    Constraint,
    Coordinate,
    Description,
    Drawing,
    FunctionSpec,
    Measure,
    Parameter,
    PointRecord,
)
from runtime.model import Model
from runtime.results.export import as_json
from runtime.views.report import run_report
from symgen import Scene
from symgen.scenes import generated_folder


def rod_model() -> Model:
    """A rod on a hinge with one elastic coordinate; its outline bends by q1 at the tip."""

    def poses() -> ca.Function:
        q = ca.SX.sym("q", 4)
        c, s = ca.cos(q[2]), ca.sin(q[2])
        return ca.Function(
            "poses", [q], [ca.densify(ca.vertcat(q[:2], 0, c, s, 0, -s, c, 0, 0, 0, 1))], ["q"], ["poses"]
        )

    def geometry() -> ca.Function:
        p, parts = ca.SX.sym("p", 2), np.append(np.linspace(0.0, 1.0, 5), 0.0)
        outputs = {
            "positions": ca.vertcat(p[0] * ca.DM(parts).T, ca.SX.zeros(2, 6)),
            "axes": ca.repmat(ca.SX(ca.DM(np.eye(3).ravel())), 1, 6),
            "shapes": ca.DM(np.stack([0 * parts, parts**2, 0 * parts])[:, :5]),
            "turns": ca.DM(np.stack([0 * parts, 0 * parts, 2 * parts])[:, :5]) / p[0],
            "sections": ca.DM([0.1, 0.2]),
        }
        return ca.Function("geometry", [p], [ca.densify(value) for value in outputs.values()], ["p"], list(outputs))

    def constants() -> ca.Function:
        p = ca.SX.sym("p", 2)
        return ca.Function("constants", [p], [p[:1]], ["p"], ["c"])

    return Model(
        description=rod_description(),
        initial_q=np.zeros(4),
        initial_q_dot=np.zeros(4),
        builders={"poses": poses, "geometry": geometry, "constants": constants},
    )


def rod_description() -> Description:
    """Its records."""
    return Description(
        name="rod_on_hinge",
        title="Rod on a hinge",
        coordinates=[
            Coordinate("rod.x", "rod", "position", "m"),
            Coordinate("rod.y", "rod", "position", "m"),
            Coordinate("rod.theta", "rod", "angle", "rad"),
            Coordinate("rod.q1", "rod", "modal", "m"),
        ],
        q_i=["rod.q1", "rod.theta"],
        q_d=["rod.x", "rod.y"],
        loop_unknowns=[],
        groups=[Group("slow", [1]), Group("fast", [0])],
        constraints=[Constraint(f"hinge.{axis}", "hinge", "distance", "m") for axis in "xy"],
        redundant=[],
        bodies=[BodyRecord("ground", "ground", ["origin"]), BodyRecord("rod", "beam", ["start", "end"])],
        joints=[],
        loads=[],
        measures=[Measure("tip", "m"), Measure("tip_dot", "m/s")],
        drawing=Drawing(
            "planar", ["rod"], [PointRecord("rod", "", 1)] * 5 + [PointRecord("ground", "origin", 0)], ["rod"]
        ),
        gravity=[0.0, 0.0],
        parameters=[
            Parameter("length", "m", "of the rod", "declared", 2.0),
            Parameter("rod.data.1", "", "", "data", 3.0),
        ],
        bounded=[],
        functions=[FunctionSpec("condensed", "38", "", "condensed", [], [], 55)],
        simulation={"t_end": 2.0, "dt": 0.01, "m": [10], "scheme": "printed", "seen_every": 0.0},
    )


def rod_solution(samples: int = 41, status: Status | None = None) -> Solution:
    """theta = sin t, q1 = 0.01 cos 3t: functions whose derivatives and energies are known."""
    t = np.linspace(0.0, 2.0, samples)
    zero = np.zeros_like(t)
    q = np.stack([zero, zero, np.sin(t), 0.01 * np.cos(3 * t)], axis=1)
    q_dot = np.stack([zero, zero, np.cos(t), -0.03 * np.sin(3 * t)], axis=1)
    q_ddot = np.stack([zero, zero, -np.sin(t), -0.09 * np.cos(3 * t)], axis=1)
    kinetic = 5.0 + t**3  # fed by the drive at 3 t^2 + 2 W, of which damping takes 2 W
    energy = {
        "kinetic": kinetic,
        "elastic": zero + 1.0,
        "potential": zero - 2.0,
        "power_dissipated": zero + 2.0,
        "power_applied": zero,
        "power_driven": 3.0 * t**2 + 2.0,
    }
    return Solution(
        model=rod_model(),
        scheme="printed",
        dt=0.01,
        m=[10],
        parameters=np.array([2.0, 3.0]),
        t=t,
        q_i=q[:, [3, 2]],
        q=q,
        q_dot=q_dot,
        q_ddot=q_ddot,
        lam=np.stack([t, -t], axis=1),
        energy=energy,
        joint_forces=np.stack([-t, t, zero], axis=1)[:, None, :],
        load_forces=np.zeros((len(t), 0, 3)),
        constraint_error=np.full_like(t, 1e-15),
        constraint_rate_error=np.full_like(t, 1e-14),
        measures=np.stack([2.0 * t, zero + 2.0], axis=1),
        stats={"steps": 200, "engine": "interpreted", "wall_seconds": np.float64(0.5)},
        status=status or Status("completed", 2.0),
    )


def test_access_by_name() -> None:
    solution = rod_solution()
    assert np.array_equal(solution["rod.theta"], solution.q[:, 2])
    assert np.array_equal(solution["tip"], solution.measures[:, 0])
    assert np.array_equal(solution.rate("rod.q1"), solution.q_dot[:, 3])
    assert np.array_equal(solution.acceleration("rod.q1"), solution.q_ddot[:, 3])
    assert np.array_equal(solution.multiplier("hinge.y"), solution.lam[:, 1])


def test_a_misspelled_name_is_recognised() -> None:
    with pytest.raises(ModelError, match="'rod.tetha'; it has .*; did you mean 'rod.theta'"):
        rod_solution()["rod.tetha"]


@pytest.mark.parametrize(
    "access",
    [
        lambda s: s["rod.q2"],
        lambda s: s.rate("tip"),
        lambda s: s.multiplier("x"),
        lambda s: s.interpolate(0.5, "nothing"),
    ],
)
def test_unknown_names_list_the_known_ones(access) -> None:
    with pytest.raises(ModelError, match="rod_on_hinge has no .*; it has"):
        access(rod_solution())


def test_energy_balance_is_fourth_order_in_the_sampling() -> None:
    solution = rod_solution()
    assert np.allclose(solution.total_energy, 4.0 + solution.t**3)
    assert np.abs(solution.energy_balance()).max() < 1e-12  # power is quadratic: the rule is exact
    errors = []
    for samples in (41, 81):
        solution = rod_solution(samples)
        solution.energy["kinetic"] = np.exp(solution.t)
        solution.energy["power_driven"] = np.exp(solution.t) + 2.0
        errors.append(np.abs(solution.energy_balance()).max())
    assert errors[0] < 1e-5 and errors[0] / errors[1] > 12.0


def test_energy_balance_of_one_and_two_samples() -> None:
    assert rod_solution(1).energy_balance() == pytest.approx([0.0])
    assert rod_solution(2).energy_balance().shape == (2,)


def test_interpolation_is_cubic_hermite() -> None:
    solution = rod_solution()
    times = np.linspace(0.0, 2.0, 333)
    assert np.abs(solution.interpolate(times)[:, 2] - np.sin(times)).max() < 2e-8
    assert np.abs(solution.interpolate(times, "rod.q1") - 0.01 * np.cos(3 * times)).max() < 2e-8
    assert np.abs(solution.interpolate(times, "q_dot")[:, 2] - np.cos(times)).max() < 2e-8
    assert solution.interpolate(0.123, "q_i").shape == (2,)
    assert solution.interpolate(0.125, "tip") == pytest.approx(0.25)
    assert solution.interpolate(2.0, "kinetic") == pytest.approx(13.0)
    assert np.array_equal(solution.interpolate(solution.t, "q"), solution.q)
    for outside in (-1e-9, 2.1, np.nan):
        with pytest.raises(ValueError, match="outside|finite number"):
            solution.interpolate(outside)


def test_npz_round_trip_without_pickle(tmp_path) -> None:
    solution = rod_solution(status=Status("diverged", 1.5, "rod.q1", "cause", "advice"))
    solution.save(tmp_path / "sub" / "run.npz")
    with np.load(tmp_path / "sub" / "run.npz", allow_pickle=False) as data:
        assert all(data[key].dtype != object for key in data)
    assert [path.name for path in (tmp_path / "sub").iterdir()] == ["run.npz"]
    for model in (None, solution.model):
        back = Solution.load(tmp_path / "sub" / "run.npz", model)
        for key in ("t", "q", "q_i", "q_dot", "q_ddot", "lam", "measures", "constraint_error", "parameters"):
            assert np.array_equal(getattr(back, key), getattr(solution, key))
        assert back.status == solution.status and back.m == [10] and back.energy.keys() == solution.energy.keys()
        assert back.model.groups == solution.model.groups and back.stats["wall_seconds"] == 0.5


def test_loading_refuses_what_is_not_a_solution(tmp_path) -> None:
    (tmp_path / "text.npz").write_text("no")
    np.savez(tmp_path / "other.npz", a=np.arange(3))
    np.savez(tmp_path / "pickled.npz", header=np.array([{}], dtype=object))
    for name in ("text.npz", "other.npz", "pickled.npz", "missing.npz"):
        with pytest.raises(OutputError, match="is not a saved solution"):
            Solution.load(tmp_path / name)
    rod_solution().save(tmp_path / "run.npz")
    other = rod_model()
    other.coordinates[3] = "rod.q9"
    with pytest.raises(ModelError, match="belongs to model rod_on_hinge"):
        Solution.load(tmp_path / "run.npz", other)


def test_a_damaged_file_is_refused_by_name(tmp_path) -> None:
    """Of 400 files with a byte or more changed or cut off: each is refused as OutputError or ModelError, or reads."""
    rod_solution().save(tmp_path / "run.npz")
    good, rng = (tmp_path / "run.npz").read_bytes(), np.random.default_rng(3)
    refused = 0
    for _ in range(400):
        bad = bytearray(good)
        for at in rng.integers(len(bad), size=rng.integers(1, 9)):
            bad[at] = rng.integers(256)
        (tmp_path / "bad.npz").write_bytes(bad[: len(bad) if rng.random() < 0.8 else rng.integers(len(bad))])
        try:
            Solution.load(tmp_path / "bad.npz")
        except (OutputError, ModelError):
            refused += 1
    assert refused > 300


def test_csv_reads_back_exactly(tmp_path) -> None:
    solution = rod_solution()
    solution.export(tmp_path / "run.csv")
    header = (tmp_path / "run.csv").read_text().partition("\n")[0].split(",")
    assert {"t [s]", "rod.theta_dot [rad/s]", "energy.kinetic [J]", "hinge.force_x [N]", "lam.hinge.x [N]"} <= set(
        header
    )
    names = [name.partition(" [")[0] for name in header]
    values = np.loadtxt(tmp_path / "run.csv", delimiter=",", skiprows=1)
    for name, column in solution.columns().items():
        assert np.array_equal(values[:, names.index(name)], column)
        assert np.array_equal(solution[name], column) and np.array_equal(solution[header[names.index(name)]], column)


def test_matlab_files_hold_columns_names_and_units(tmp_path) -> None:
    solution = rod_solution()
    solution.export(tmp_path / "run.mat")
    found = loadmat(tmp_path / "run.mat", squeeze_me=True)
    names, variables, units = (list(found[key]) for key in ("names", "variables", "units"))
    assert dict(zip(names, units, strict=True))["rod.theta_dot"] == "rad/s" and len(set(variables)) == len(names)
    for name, variable in zip(names, variables, strict=True):
        assert variable.isidentifier() and np.array_equal(found[variable], solution[name])


def test_other_endings_are_refused(tmp_path) -> None:
    with pytest.raises(ModelError, match=r"ends in no known format.*\.csv, \.mat, \.parquet"):
        rod_solution().export(tmp_path / "run.xlsx")


def test_writing_is_all_or_nothing(tmp_path) -> None:
    write_text(tmp_path / "a.txt", "old")
    with pytest.raises(RuntimeError), replacing(tmp_path / "a.txt") as temporary:
        temporary.write_text("half")
        raise RuntimeError
    assert (tmp_path / "a.txt").read_text() == "old" and len(list(tmp_path.iterdir())) == 1
    with pytest.raises(OutputError, match="cannot be written"):
        rod_solution().save(tmp_path / "a.txt" / "run.npz")


def test_parquet_files_hold_columns_and_units(tmp_path) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")
    solution = rod_solution()
    solution.export(tmp_path / "run.parquet")
    found = parquet.read_table(tmp_path / "run.parquet")
    assert found.schema.field("rod.theta_dot").metadata[b"unit"] == b"rad/s"
    assert found.schema.metadata[b"model"] == solution.model.name.encode()
    for name, column in solution.columns().items():
        assert np.array_equal(found[name].to_numpy(), column)


def test_a_dataset_has_columns_with_units_and_how_the_run_ended() -> None:
    pytest.importorskip("xarray")
    solution = rod_solution(status=Status("not_finite", 1.5, "rod.q1", "a | b", "smaller dt"))
    found = solution.to_xarray()
    assert found["time"].attrs == {"units": "s", "long_name": "time"} and np.array_equal(found["time"], solution.t)
    assert set(found.data_vars) == set(solution.columns()) - {"t"}
    for name, column in solution.columns().items():
        assert name == "t" or np.array_equal(found[name], column)
    assert found["rod.theta_dot"].attrs == {"units": "rad/s", "long_name": "rate of angle rod.theta"}
    assert found["energy.kinetic"].attrs == {"units": "J", "long_name": "kinetic energy"}
    assert found.attrs["status"] == "not_finite" and "smaller dt" in found.attrs["status_text"]
    assert np.isnan(found.attrs["error"]) and "not requested" in found.attrs["error_text"]
    assert found.attrs["scheme"] == solution.scheme and found.attrs["dt"] == 0.01


@pytest.mark.parametrize("library", ["netCDF4", "zarr"])
def test_a_dataset_is_read_back_from_files_as_it_was(tmp_path: Path, library: str) -> None:
    xarray = pytest.importorskip("xarray")
    pytest.importorskip(library)
    found = rod_solution().to_xarray()
    if library == "netCDF4":
        found.to_netcdf(tmp_path / "run.nc", engine="netcdf4")
        with xarray.open_dataset(tmp_path / "run.nc", engine="netcdf4") as read:
            assert read.load().identical(found)
    else:
        found.to_zarr(tmp_path / "run.zarr", consolidated=False)
        assert xarray.open_zarr(tmp_path / "run.zarr", consolidated=False).identical(found)


@pytest.mark.parametrize("name", ["flexible_slider_crank_torque", "heavy_top"])
def test_every_column_of_a_dataset_says_what_it_is(name: str) -> None:
    """Inputs, forces and angular velocities too; only what the scene gives no unit has none."""
    pytest.importorskip("xarray")
    found = load_model(generated_folder(name)).simulate(t_end=0.01, error="off").to_xarray()
    for column, variable in found.data_vars.items():
        assert variable.attrs["long_name"] != column and variable.attrs["units"]


def test_without_xarray_the_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "xarray", None)
    with pytest.raises(ImportError, match=r"symgen\[xarray\]"):
        rod_solution().to_xarray()


def test_report() -> None:
    solution = rod_solution(status=Status("not_finite", 1.5, "rod.q1", "a | b", "smaller dt"))
    solution.stats["ratio"] = float("nan")
    report = run_report(solution)
    assert report["scheme"]["step_of_each_group"] == pytest.approx([0.01, 0.001])
    assert report["status"]["coordinate"] == "rod.q1" and not report["status"]["ok"]
    assert list(report["parameters"]) == ["length"]
    assert report["final_state"]["rod.theta"] == {"value": np.sin(2.0), "rate": np.cos(2.0), "unit": "rad"}
    assert report["energy"]["largest_balance_error"] < 1e-12
    assert '"ratio": null' in as_json(report)


@pytest.mark.parametrize(
    ("how", "told"),
    [
        ({"scheme": "rk4", "dt": 1e-3}, "dt 0.001 s"),
        ({"scheme": "rk4", "dt": 1e-3, "seen_every": 0.01}, "dt 0.001 s, seen every 0.01 s"),
        (
            {"scheme": "dopri5", "tolerance": 1e-4, "options": {"error_of": "step"}, "seen_every": 0.05},
            "steps of {mean:.3g} s in the mean, seen every 0.05 s",
        ),
    ],
)
def test_headers_tell_steps_and_what_is_seen_of_them(how: dict[str, Any], told: str) -> None:
    run = simulate(load_model(generated_folder("pendulum")), t_end=0.5, **{"seen_every": 0.0, **how})
    assert run.pace == told.format(mean=0.5 / int(run.stats["steps"]))
    assert run.pace in run._repr_html_()


Load = Callable[[str], Model]


def test_rates_have_units_of_rates(built_in: Load) -> None:
    model = built_in("pendulum")
    name = model.q_i[0]
    units = linearise(model, outputs=[name, f"{name}_dot"]).units
    assert units[name] == "rad" and units[f"{name}_dot"] == "rad/s"


def swing() -> Scene:
    """A pendulum whose scene says nothing of samples."""
    scene = Scene("swing").gravity(0, -9.81).rigid("rod", mass=1.0, inertia=0.1, center_of_mass=(0.5, 0.0))
    return scene.revolute("hinge", "ground.origin", "rod.origin").initial({"rod.theta": 0.3})


def test_long_runs_keep_no_more_samples_than_they_need() -> None:
    """30,000 steps: every second one, the same states as where each is asked for."""
    pendulum = swing().model()
    asked = {"scheme": "rk4", "dt": 1e-4, "error": "off"}
    run, every = pendulum.simulate(t_end=3.0, **asked), pendulum.simulate(t_end=3.0, seen_every=0.0, **asked)
    assert len(run.t) == 15_001 and len(every.t) == 30_001
    np.testing.assert_array_equal(run.t, every.t[::2])
    np.testing.assert_array_equal(run.q, every.q[::2])
    assert len(pendulum.simulate(t_end=2.0, **asked).t) == 20_001
