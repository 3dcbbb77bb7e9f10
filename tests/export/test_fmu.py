"""FMUs, called as a master calls them: the bits of the runtime, states kept, derivatives, and answers to nonsense."""

from __future__ import annotations

import ctypes
import zipfile
from collections.abc import Callable, Sequence
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from runtime import ModelError, reference_solution, simulate
from runtime.engine.c_source import find_compiler
from runtime.export import fmu
from runtime.export.c_bundle import exported
from runtime.export.fmu import this_platform, write_fmu
from runtime.model import Model
from symgen.cli import main
from symgen.scene import Scene, SceneRecord
from tests.export.test_c_stops import kinks, relay
from tests.support.input_scenes import cart

pytestmark = pytest.mark.long

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]
OK, DISCARD, ERROR = 0, 2, 3
needs_compiler = pytest.mark.skipif(
    find_compiler() is None or this_platform() != "linux64", reason="no C compiler, or another platform"
)
LOGGER = ctypes.CFUNCTYPE(
    None, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p, ctypes.c_char_p
)
EXCHANGE, CO_SIMULATION = 0, 1
PAST = 1e-9  # s


class Callbacks(ctypes.Structure):
    _fields_ = [("logger", LOGGER), *((name, ctypes.c_void_p) for name in ("allocate", "release", "finished", "env"))]


class Master:
    """An instance of FMI 2.0."""

    def __init__(self, model: Model, folder: Path, kind: int = CO_SIMULATION, **how: object) -> None:
        path = folder / "unit.fmu"
        if not path.exists():
            model.export_fmu(path, **how)
            with zipfile.ZipFile(path) as archive:
                archive.extractall(folder / "unit")
        self.xml = ElementTree.parse(folder / "unit" / "modelDescription.xml").getroot()
        self.library = ctypes.CDLL(str(next((folder / "unit" / "binaries").rglob("*.so"))))
        self.places = {v.get("name"): int(v.get("valueReference", "")) for v in self.xml.iter("ScalarVariable")}
        self.outputs = [v.get("name", "") for v in self.xml.iter("ScalarVariable") if v.get("causality") == "output"]
        self.said: list[bytes] = []
        self._callbacks = Callbacks(LOGGER(lambda *words: self.said.append(words[5])), None, None, None, None)
        self.library.fmi2Instantiate.restype = ctypes.c_void_p
        token = self.xml.get("guid", "").encode()
        self.instance = self.new(token, kind)

    def new(self, token: bytes, kind: int) -> int | None:
        return self.library.fmi2Instantiate(b"one", kind, token, None, ctypes.byref(self._callbacks), 0, 0)

    def call(self, name: str, *arguments: object) -> int:
        return self.library["fmi2" + name](ctypes.c_void_p(self.instance), *arguments)

    def begin(self, t: float = 0.0) -> None:
        assert self.call("SetupExperiment", 0, ctypes.c_double(0), ctypes.c_double(t), 0, ctypes.c_double(0)) == OK
        assert self.call("EnterInitializationMode") == OK
        assert self.call("ExitInitializationMode") == OK

    def references(self, names: Sequence[str]) -> object:
        return (ctypes.c_uint * len(names))(*(self.places[name] for name in names))

    def get(self, names: Sequence[str]) -> np.ndarray:
        found = (ctypes.c_double * len(names))()
        assert self.call("GetReal", self.references(names), ctypes.c_size_t(len(names)), found) == OK
        return np.array(found)

    def set(self, name: str, value: float) -> int:
        return self.call("SetReal", self.references([name]), ctypes.c_size_t(1), (ctypes.c_double * 1)(value))

    def step(self, t: float, h: float) -> int:
        return self.call("DoStep", ctypes.c_double(t), ctypes.c_double(h), 1)

    def derivatives(self, x: np.ndarray) -> np.ndarray:
        found, n = (ctypes.c_double * len(x))(), ctypes.c_size_t(len(x))
        assert self.call("SetContinuousStates", (ctypes.c_double * len(x))(*x), n) == OK
        assert self.call("GetDerivatives", found, n) == OK
        return np.array(found)

    @property
    def states(self) -> list[str]:
        """Names, in order."""
        variables = list(self.xml.iter("ScalarVariable"))
        derivatives = [int(u.get("index", "")) - 1 for u in self.xml.iterfind("ModelStructure/Derivatives/Unknown")]
        return [variables[int(variables[k][0].get("derivative", "")) - 1].get("name", "") for k in derivatives]


@needs_compiler
@pytest.mark.parametrize("name, scheme", [("flexible_slider_crank_free", "exponential"), ("heavy_top", "rk4")])
def test_co_simulation_has_the_bits_of_the_runtime(built_in: Load, name: str, scheme: str, tmp_path: Path) -> None:
    model = built_in(name)
    master, stepper = Master(model, tmp_path, scheme=scheme), model.stepper(scheme=scheme)
    master.begin()
    read, h = stepper.reader(master.outputs), 20 * stepper.dt
    for k in range(20):
        np.testing.assert_array_equal(master.get(master.outputs), read())
        assert master.step(k * h, h) == OK
        stepper.step(20)


@needs_compiler
def test_a_step_that_is_no_multiple_is_divided(built_in: Load, tmp_path: Path) -> None:
    """2.5 steps of the scheme are three of 2.5/3; one of another length later leads to the same motion."""
    model = built_in("double_pendulum")
    master, dt = Master(model, tmp_path, scheme="rk4"), model.stepper(scheme="rk4").dt
    master.begin()
    h = 2.5 * dt
    stepper = model.stepper(scheme="rk4", dt=h / 3)
    for k in range(10):
        assert master.step(k * h, h) == OK
    stepper.step(30)
    read = stepper.reader(master.outputs)
    np.testing.assert_array_equal(master.get(master.outputs), read())
    assert master.step(10 * h, 0.3 * h) == OK and master.step(10.3 * h, 0.7 * h) == OK
    stepper.step(3)
    np.testing.assert_allclose(master.get(master.outputs), read(), rtol=1e-9, atol=1e-10)


@needs_compiler
def test_states_are_restored_bit_for_bit(built_in: Load, tmp_path: Path) -> None:
    model = built_in("flexible_slider_crank")
    master, h = Master(model, tmp_path), 3e-4
    master.begin()
    state, size = ctypes.c_void_p(), ctypes.c_size_t()
    assert master.step(0.0, h) == OK
    assert master.call("GetFMUstate", ctypes.byref(state)) == OK
    assert master.call("SerializedFMUstateSize", state, ctypes.byref(size)) == OK
    bytes_ = (ctypes.c_char * size.value)()
    assert master.call("SerializeFMUstate", state, bytes_, size) == OK
    assert master.set("crank.mass", 3.0) == OK and master.step(h, h) == OK
    expected = master.get(master.outputs)
    again = ctypes.c_void_p()
    assert master.call("DeSerializeFMUstate", bytes_, size, ctypes.byref(again)) == OK
    for kept in (state, again):
        assert master.call("SetFMUstate", kept) == OK
        assert master.set("crank.mass", 3.0) == OK and master.step(h, h) == OK
        np.testing.assert_array_equal(master.get(master.outputs), expected)
        assert master.call("FreeFMUstate", ctypes.byref(kept)) == OK


@needs_compiler
def test_inputs_follow_the_slope_that_a_master_gives(model_of: Build, tmp_path: Path) -> None:
    """A force 3 t on 2 kg: v = 3/4 t^2, which values at the middle of each step give exactly."""
    master = Master(model_of(cart()), tmp_path)
    master.begin()
    one = ctypes.c_size_t(1)
    slope = (master.references(["force"]), one, (ctypes.c_int * 1)(1), (ctypes.c_double * 1)(3.0))
    for k in range(5):
        assert master.set("force", 3.0 * 0.01 * k) == OK
        assert master.call("SetRealInputDerivatives", *slope) == OK
        assert master.step(0.01 * k, 0.01) == OK
    assert master.get(["cart.x_dot"])[0] == pytest.approx(0.75 * 0.05**2, rel=1e-12)


@needs_compiler
def test_model_exchange_is_the_motion_of_the_model(built_in: Load, tmp_path: Path) -> None:
    """Against the reference at full length, for a tree and a loop; derivatives along x against differences."""
    for name in ("double_pendulum", "four_bar"):
        model = built_in(name)
        (tmp_path / name).mkdir()
        master = Master(model, tmp_path / name, EXCHANGE, scheme="rk4")
        master.begin()
        assert master.call("EnterContinuousTimeMode") == OK
        x0, end = master.get(master.states), float(model.simulation["t_end"])

        def slope(t: float, x: np.ndarray, master: Master = master) -> np.ndarray:
            assert master.call("SetTime", ctypes.c_double(t)) == OK
            return master.derivatives(x)

        found = solve_ivp(slope, (0.0, end), x0, method="DOP853", rtol=1e-11, atol=1e-12).y[:, -1]
        reference = reference_solution(model, t_end=end, rtol=1e-12, atol=1e-13)
        expected = np.concatenate(
            [reference.q_i[-1], [reference.q_dot[-1][model.coordinates.index(n)] for n in model.q_i]]
        )
        np.testing.assert_allclose(found[: len(expected)], expected, rtol=1e-7, atol=1e-7)
        for k, state in enumerate(master.states):
            step = 1e-5 * np.eye(len(x0))[k]
            differences = [
                (master.derivatives(x0 + j * step) - master.derivatives(x0 - j * step)) / (2e-5 * j) for j in (1, 2)
            ]
            master.derivatives(x0)
            rates = [v.get("name") for v in master.xml.iter("ScalarVariable") if v[0].get("derivative")]
            order = [
                rates.index(s.removesuffix("_dot") + ("_ddot" if s.endswith("_dot") else "_dot")) for s in master.states
            ]
            found = (ctypes.c_double * len(rates))()
            one, n, seed = ctypes.c_size_t(1), ctypes.c_size_t(len(rates)), (ctypes.c_double * 1)(1.0)
            arguments = (master.references(rates), n, master.references([state]), one, seed, found)
            assert master.call("GetDirectionalDerivative", *arguments) == OK
            expected = (4 * differences[0] - differences[1]) / 3
            np.testing.assert_allclose(
                np.array(found)[order], expected, rtol=1e-8, atol=1e-8 * max(1.0, np.abs(expected).max())
            )


def exchanged(master: Master, t_end: float) -> tuple[float, np.ndarray, int]:
    """(time, states, events answered) by DOP853 that ends at roots of the indicators, with events as FMI 2 says."""
    master.begin()
    info, size = (ctypes.c_int * 8)(), ctypes.c_size_t(int(master.xml.get("numberOfEventIndicators", "")))
    assert master.call("NewDiscreteStates", info) == OK and master.call("EnterContinuousTimeMode") == OK
    t, x, answered = 0.0, master.get(master.states), 0

    def slope(t: float, x: np.ndarray) -> np.ndarray:
        assert master.call("SetTime", ctypes.c_double(t)) == OK
        return master.derivatives(x)

    def indicators(t: float, x: np.ndarray) -> np.ndarray:
        slope(t, x)
        found = (ctypes.c_double * size.value)()
        assert master.call("GetEventIndicators", found, size) == OK
        return np.array(found)

    def root(k: int) -> Callable[[float, np.ndarray], float]:
        def event(t: float, x: np.ndarray) -> float:
            return float(indicators(t, x)[k])

        event.terminal = True  # type: ignore[attr-defined]
        return event

    while t < t_end:
        roots = [root(k) for k in range(size.value)]
        end = min(t_end, ctypes.c_double.from_buffer(info, 24).value) if info[4] else t_end
        run = solve_ivp(slope, (t, end), x, method="DOP853", rtol=1e-10, atol=1e-12, events=roots, max_step=0.01)
        t, x = float(run.t[-1]), run.y[:, -1]
        if t == t_end:
            break
        if run.status:
            t, x = t + PAST, x + PAST * slope(t, x)  # on the other side, as masters are
        indicators(t, x)
        assert master.call("EnterEventMode") == OK
        assert master.call("NewDiscreteStates", info) == OK and not info[0]
        answered += 1
        if info[1]:
            break
        assert master.call("EnterContinuousTimeMode") == OK
    return t, x, answered


@needs_compiler
@pytest.mark.parametrize("scene", [relay, kinks])
def test_events_of_model_exchange_are_those_of_a_run(
    model_of: Build, scene: Callable[[], Scene], tmp_path: Path
) -> None:
    """Actions, a cool-down, a jump in time, an end by an event; a spring that pushes only."""
    model = model_of(scene().simulation(t_end=4.0 if scene is relay else 1.0, dt=2e-4, scheme="rk4").build())
    run = simulate(model)
    t, x, answered = exchanged(Master(model, tmp_path, EXCHANGE), float(model.simulation["t_end"]))
    assert t == pytest.approx(float(run.t[-1]), abs=2 * PAST)
    np.testing.assert_allclose(x, [run["cart.x"][-1], run["cart.x_dot"][-1]], rtol=0, atol=1e-7)
    assert answered >= len(run.events) >= 4


@needs_compiler
def test_an_event_ends_co_simulation_at_its_time(model_of: Build, tmp_path: Path) -> None:
    """fmi2Discard with fmi2Terminated and the time of the event, and no step from there on."""
    model = model_of(relay().simulation(t_end=4.0, dt=1e-3, scheme="rk4").build())
    master, stepper = Master(model, tmp_path), model.stepper()
    master.begin()
    h, terminated, value = 0.05, ctypes.c_int(), ctypes.c_double()
    answers = [master.step(k * h, h) for k in range(75)]
    assert answers == [OK] * 75
    assert master.call("GetBooleanStatus", 3, ctypes.byref(terminated)) == OK and not terminated.value
    assert master.step(75 * h, h) == DISCARD and b"an event has ended" in master.said.pop()
    assert master.call("GetBooleanStatus", 3, ctypes.byref(terminated)) == OK and terminated.value
    assert master.call("GetRealStatus", 2, ctypes.byref(value)) == OK
    assert value.value == pytest.approx(3.7654321, abs=1e-11)
    stepper.step(4000)
    np.testing.assert_array_equal(master.get(master.outputs), stepper.reader(master.outputs)())
    assert master.step(value.value, h) == ERROR and b"has ended" in master.said.pop()


@needs_compiler
@pytest.mark.parametrize("fmi", [2, 3])
def test_the_standards_own_simulator_meets_events(model_of: Build, tmp_path: Path, fmi: int) -> None:
    """Both kinds end where the event is; CVODE's motion is that of the scheme."""
    fmpy = pytest.importorskip("fmpy")
    from fmpy.validation import validate_fmu

    path = tmp_path / "unit.fmu"
    write_fmu(exported(model_of(relay().simulation(t_end=4.0, dt=1e-3, scheme="rk4").build())), path, fmi)
    assert not validate_fmu(str(path))
    how = {"stop_time": 4.0, "output_interval": 0.01, "output": ["cart.x"]}
    exchanged = fmpy.simulate_fmu(str(path), fmi_type="ModelExchange", solver="CVode", relative_tolerance=1e-10, **how)
    steps = fmpy.simulate_fmu(str(path), fmi_type="CoSimulation", step_size=0.01, **how)
    assert exchanged[-1]["time"] == pytest.approx(3.7654321, abs=1e-8)
    assert steps[-1]["time"] < 3.78
    assert exchanged[-1]["cart.x"] == pytest.approx(steps[-1]["cart.x"], abs=1e-7)


@needs_compiler
def test_nonsense_is_answered_with_a_status_and_a_line(built_in: Load, tmp_path: Path) -> None:
    master = Master(built_in("double_pendulum"), tmp_path, scheme="rk4")
    nowhere = (ctypes.c_uint * 1)(10_000)
    value, one = (ctypes.c_double * 1)(), ctypes.c_size_t(1)
    assert master.new(b"another", CO_SIMULATION) is None and b"token" in master.said.pop()
    assert master.step(0.0, 1e-3) == ERROR and b"behind the initialisation" in master.said.pop()
    master.begin()
    assert master.call("EnterInitializationMode") == ERROR and b"once" in master.said.pop()
    assert master.call("GetReal", nowhere, one, value) == ERROR and b"no variable" in master.said.pop()
    assert master.call("GetReal", None, one, value) == ERROR and b"no place" in master.said.pop()
    assert master.call("GetInteger", nowhere, one, value) == ERROR and b"only real" in master.said.pop()
    mass = next(name for name in master.places if name and name.endswith("mass"))
    assert master.set(mass, float("nan")) == ERROR and b"finite" in master.said.pop()
    assert master.set(mass, -1.0) == ERROR and b"wrong sign" in master.said.pop()
    assert master.set(master.outputs[0], 0.0) == ERROR and b"before" in master.said.pop()
    for h in (0.0, -1.0, float("nan"), float("inf")):
        assert master.step(0.0, h) == ERROR and b"positive and finite" in master.said.pop()
    assert master.step(1.0, 1e-3) == ERROR and b"another time" in master.said.pop()
    assert master.step(0.0, 1e12) == DISCARD and b"longer" in master.said.pop()
    assert master.call("EnterContinuousTimeMode") == ERROR
    assert master.step(0.0, 1e-3) == OK


@needs_compiler
@pytest.mark.parametrize("fmi", [2, 3])
def test_the_standards_own_checker_and_simulator(built_in: Load, fmi: int, tmp_path: Path) -> None:
    fmpy = pytest.importorskip("fmpy")
    from fmpy.validation import validate_fmu

    model, path = built_in("slider_crank"), tmp_path / "unit.fmu"
    write_fmu(exported(model, "rk4"), path, fmi)
    assert not validate_fmu(str(path))
    stepper = model.stepper(scheme="rk4")
    h, name = 10 * stepper.dt, model.q_i[0]
    found = fmpy.simulate_fmu(
        str(path), stop_time=20 * h, output_interval=h, step_size=h, output=[name], fmi_type="CoSimulation"
    )
    stepper.step(200)
    assert found[-1][name] == stepper.state[name]
    found = fmpy.simulate_fmu(
        str(path),
        stop_time=20 * h,
        output_interval=h,
        output=[name],
        fmi_type="ModelExchange",
        solver="CVode",
        relative_tolerance=1e-10,
    )
    assert found[-1][name] == pytest.approx(stepper.state[name], rel=1e-7)


def test_descriptions_name_each_variable_once_with_a_known_unit(built_in: Load) -> None:
    for fmi, kind in ((2, "ScalarVariable"), (3, "Float64")):
        one = exported(built_in("flexible_slider_crank_free"))
        root = ElementTree.fromstring(fmu.fmu_texts(one, fmi)["modelDescription.xml"])
        variables = list(root.iter(kind))
        for key in ("name", "valueReference"):
            assert len({v.get(key) for v in variables}) == len(variables)
        units = {unit.get("name") for unit in root.iter("Unit")}
        if fmi == 3:  # what others build it from: all of its sources, by the name that its library has
            build = ElementTree.fromstring(fmu.fmu_texts(one, fmi)["sources/buildDescription.xml"])
            named = {f"sources/{source.get('name')}" for source in build.iter("SourceFile")}
            assert named == {name for name in fmu.fmu_texts(one, fmi) if name.endswith(".c")}
            (whole,) = (own.get("modelIdentifier") for own in build.iter("BuildConfiguration"))
            assert {own.get("modelIdentifier") for own in root.iter() if own.get("modelIdentifier")} == {whole}
        used = {e.get("unit") for e in root.iter() if e.get("unit")}
        assert used and used == units
        starts = {v.get("name"): v for v in variables if v.get("initial") == "exact"}
        assert set(one.model.q_i) <= set(starts)


def test_a_unit_without_a_compiler_has_sources_and_says_so(
    built_in: Load, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(fmu, "find_compiler", lambda: None)
    monkeypatch.setattr(fmu, "find_spec", lambda name: None)
    path = tmp_path / "unit.fmu"
    assert main(["export", "fmu", "pendulum", "--out", str(path), "--platform", "win64,linux64"]) == 0
    said = capsys.readouterr().out
    assert "sources only" in said and "Nothing for win64" in said
    names = zipfile.ZipFile(path).namelist()
    assert "sources/fmu.c" in names and not [name for name in names if name.startswith("binaries")]
    with pytest.raises(ModelError, match="platform amiga: is not known"):
        write_fmu(exported(built_in("pendulum")), tmp_path / "other.fmu", platforms=["amiga"])
    assert not (tmp_path / "other.fmu").exists()
