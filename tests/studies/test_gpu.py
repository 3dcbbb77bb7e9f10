"""Ensembles on a GPU: the program that it is given, assembled, and run here by a driver that is this processor.

No test has a card: what only a card can show is said on the page. The driver below does what NVIDIA's does with memory
and launches, and runs the case of the kernel that it is given, compiled for this processor, case by case.
"""

from __future__ import annotations

import ctypes
import re
import sys
from enum import IntEnum
from types import ModuleType, SimpleNamespace

import numpy as np
import pytest

from runtime import ArgumentError
from runtime.engine import gpu
from runtime.engine.llvm_code import BEST, host, linked, machine_code
from runtime.studies.ensemble import lane_programs
from symgen import Scene
from symgen.scenes import SCENES

MODELS = {
    "double_pendulum": ("rk4", 1e-3, "lower.mass", (0.7, 1.3)),
    "flexible_slider_crank_free": ("single_rate", 1e-5, "slider.mass", (0.06, 0.09)),
    "hub_beam": ("exponential_rk4", 1e-2, "hub.inertia", (5.0, 20.0)),
}


class Status(IntEnum):
    CUDA_SUCCESS = 0
    CUDA_ERROR_OUT_OF_MEMORY = 2


class FakeDriver:
    """`cuda.bindings.driver` without a card; texts: the IR of cases, in the order in which kernels are asked for."""

    CUdevice_attribute = SimpleNamespace(
        CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MAJOR="major", CU_DEVICE_ATTRIBUTE_COMPUTE_CAPABILITY_MINOR="minor"
    )

    def __init__(self) -> None:
        self.texts: list[str] = []
        self.memory: dict[int, np.ndarray] = {}
        self.images: list[bytes] = []
        self.launches = 0
        self.full = False

    def cuInit(self, flags):
        return (Status.CUDA_SUCCESS,)

    def cuDeviceGet(self, number):
        return Status.CUDA_SUCCESS, number

    def cuDeviceGetAttribute(self, which, device):
        return Status.CUDA_SUCCESS, {"major": 8, "minor": 0}[which]

    def cuDevicePrimaryCtxRetain(self, device):
        return Status.CUDA_SUCCESS, "context"

    def cuCtxSetCurrent(self, context):
        return (Status.CUDA_SUCCESS,)

    def cuModuleLoadData(self, image):
        self.images.append(image)
        return Status.CUDA_SUCCESS, self.texts.pop(0)

    def cuModuleGetFunction(self, text, name):
        assert name == b"cases"
        engine = linked(machine_code(text, BEST, host()), host())
        kind = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 2, *[ctypes.c_int64] * 6)
        function = kind(engine.get_function_address("one_case"))
        function.kept = engine
        return Status.CUDA_SUCCESS, function

    def cuMemAlloc(self, size):
        if self.full:
            return Status.CUDA_ERROR_OUT_OF_MEMORY, None
        place = np.zeros(-(-size // 8))
        self.memory[place.ctypes.data] = place
        return Status.CUDA_SUCCESS, place.ctypes.data

    def cuMemFree(self, place):
        del self.memory[place]
        return (Status.CUDA_SUCCESS,)

    def cuMemcpyHtoD(self, to, place, size):
        assert size <= self.memory[to].nbytes
        ctypes.memmove(to, place, size)
        return (Status.CUDA_SUCCESS,)

    def cuMemcpyDtoH(self, to, place, size):
        ctypes.memmove(to, place, size)
        return (Status.CUDA_SUCCESS,)

    def cuLaunchKernel(self, kernel, *settings):
        blocks, threads, ((rows, work, z, c, apart, own, n, cases), kinds) = settings[0], settings[3], settings[8]
        assert kinds == (None, None, *[ctypes.c_int64] * 6) and blocks * threads >= cases > (blocks - 1) * threads
        self.launches += 1
        for k in range(cases):
            kernel(rows, work, z, c, apart, own, n, k)
        return (Status.CUDA_SUCCESS,)


@pytest.fixture
def driver(monkeypatch) -> FakeDriver:
    """No card, but a driver."""
    fake = FakeDriver()
    read = gpu.ptx_of

    def told(program, architecture):
        fake.texts.append(gpu.case_ir(program)[0])
        return read(program, architecture)

    monkeypatch.setattr(gpu, "ptx_of", told)
    monkeypatch.setattr(lane_programs, "the_gpu", lambda: gpu.Gpu(fake))
    return fake


def asked(name: str, cases: int):
    scheme, dt, parameter, ends = MODELS[name]
    model = SCENES[name]().model()
    q = model.q_i[0]
    return model, {
        "parameters": {parameter: np.linspace(*ends, cases)}, "scheme": scheme, "dt": dt, "t_end": 300 * dt,
        "reduce": {q: ["end", "rms"], f"{q}_dot": "peak"},
    }  # fmt: skip


@pytest.mark.every_push("double_pendulum")
@pytest.mark.parametrize("name", MODELS)
def test_an_ensemble_by_the_kernel_has_the_bits_of_the_cpu(driver, name: str) -> None:
    model, given = asked(name, 37)
    found = model.ensemble(**given, device="gpu")
    assert driver.launches > 0 and found.identical(model.ensemble(**given))
    histories = {**given, "outputs": list(given["reduce"]), "samples": 5}
    del histories["reduce"]
    assert model.ensemble(**histories, device="gpu").identical(model.ensemble(**histories))


def test_to_a_tolerance_and_in_a_folder_too(driver, tmp_path) -> None:
    model, given = asked("double_pendulum", 20)
    refined = {key: value for key, value in given.items() if key != "dt"} | {"tolerance": 1e-4}
    assert model.ensemble(**refined, device="gpu").identical(model.ensemble(**refined))
    kept = {"folder": tmp_path / "study", "chunk": 8}
    found = model.ensemble(**given, device="gpu", **kept)
    assert found.identical(model.ensemble(**given))
    (tmp_path / "study" / "part-000000008.npz").unlink()
    assert model.ensemble(**given, **kept).identical(found)  # begun there, gone on with here


def test_memory_of_the_device_is_bounded(driver, monkeypatch) -> None:
    monkeypatch.setattr(gpu, "MOST_DEVICE_BYTES", 20_000)
    model, given = asked("double_pendulum", 300)
    found = model.ensemble(**given, device="gpu", workers=1)
    assert found.identical(model.ensemble(**given))
    assert sum(place.nbytes for place in driver.memory.values()) <= 20_000 + 64


def test_numbers_of_tables_travel_with_the_kernel(driver) -> None:
    scene = Scene("driven").parameter("gain", 1.0).rigid("rotor", mass=1.0, inertia=0.1)
    scene.revolute("axle", "ground.origin", "rotor.origin").measure("angle", "angle", of="rotor.origin")
    scene.table(
        "cam", x=[0.0, 1.0, 2.0, 3.0, 4.0], y=[0.0, 2.0, 1.0, -1.0, 0.5], interpolation="cubic", outside="extend"
    )
    model = scene.torque("motor", "rotor.origin", 'gain * table("cam", angle)').model()
    given = {
        "parameters": {"gain": np.linspace(0.5, 2.0, 21)}, "initial": {"rotor.theta": 0.3}, "scheme": "rk4",
        "dt": 1e-2, "t_end": 2.0, "reduce": {"rotor.theta": "end"},
    }  # fmt: skip
    assert model.ensemble(**given, device="gpu").identical(model.ensemble(**given))
    assert b"numbers_0" in driver.images[0] or driver.images[0][:4] == b"\x7fELF"


@pytest.mark.parametrize("name", MODELS)
def test_the_kernel_rounds_to_nearest_and_calls_nothing(name: str) -> None:
    """IEEE operations by themselves; what is fused is what the text fuses (sin, cos and exp)."""
    program = program_of(name)
    ptx, _ = gpu.ptx_of(program, "sm_80")
    arithmetic = re.findall(r"\b((?:add|sub|mul|div|sqrt|fma|mad|rcp|ex2|lg2|sin|cos|tanh)[.\w]*)", ptx)
    doubles = {one for one in arithmetic if "f64" in one}
    assert doubles <= {f"{one}.rn.f64" for one in ("add", "sub", "mul", "div", "rcp", "sqrt", "fma")}
    assert not [one for one in arithmetic if "f32" in one or "approx" in one]
    assert ".extern" not in ptx and ".visible .entry cases(" in ptx


def program_of(name: str):
    model, given = asked(name, 3)
    programs = []
    original = lane_programs.GpuCode
    fake = FakeDriver()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(lane_programs, "the_gpu", lambda: fake)
        patch.setattr(lane_programs, "GpuCode", lambda program, own: programs.append(program) or Halt.now())
        with pytest.raises(Halt):
            model.ensemble(**given, device="gpu")
    assert original is lane_programs.GpuCode
    return programs[0]


class Halt(Exception):
    @classmethod
    def now(cls):
        raise cls


@pytest.mark.every_push("double_pendulum-sm_90")
@pytest.mark.skipif(gpu.find_ptxas() is None, reason="ptxas is not installed: pip install nvidia-cuda-nvcc-cu12")
@pytest.mark.parametrize("architecture", ["sm_80", "sm_90"])
@pytest.mark.parametrize("name", MODELS)
def test_ptxas_takes_the_kernel(name: str, architecture: str) -> None:
    ptx, _ = gpu.ptx_of(program_of(name), architecture)
    code = gpu.assembled(ptx, architecture)
    assert code is not None and code[:4] == b"\x7fELF"
    with pytest.raises(gpu.NoGpu, match="ptxas does not take"):
        gpu.assembled(ptx.replace("add.rn.f64", "add.rn.f65"), architecture)


def test_what_is_missing_is_named(driver, monkeypatch) -> None:
    model, given = asked("double_pendulum", 3)
    with pytest.raises(ArgumentError, match="device: there is no 'tpu'; take one of cpu, gpu"):
        model.ensemble(**given, device="tpu")
    with pytest.raises(ArgumentError, match="device and executor"):
        model.ensemble(**given, device="gpu", executor=SimpleNamespace(submit=None))
    driver.full = True
    with pytest.raises(gpu.NoGpu, match="cuMemAlloc of the NVIDIA driver failed: CUDA_ERROR_OUT_OF_MEMORY"):
        model.ensemble(**given, device="gpu")


def test_no_library_and_no_card_are_named(monkeypatch, tmp_path) -> None:
    model, given = asked("hub_beam", 3)
    gpu.the_gpu.cache_clear()
    monkeypatch.setitem(sys.modules, "cuda.bindings", None)
    with pytest.raises(gpu.NoGpu, match=r"not installed: pip install 'symgen\[gpu\]'"):
        model.ensemble(**given, device="gpu", folder=tmp_path / "study")
    assert not (tmp_path / "study").exists()

    class NoCard(FakeDriver):
        def cuInit(self, flags):
            raise RuntimeError("libcuda.so.1 does not exist")

    bindings = ModuleType("cuda.bindings")
    bindings.driver = NoCard()
    monkeypatch.setitem(sys.modules, "cuda.bindings", bindings)
    with pytest.raises(gpu.NoGpu, match=r"no NVIDIA GPU can be used: libcuda\.so\.1"):
        model.ensemble(**given, device="gpu")
    gpu.the_gpu.cache_clear()


def test_functions_of_the_library_are_refused_by_name(driver) -> None:
    scene = Scene("worn").parameter("k", 1.0).rigid("block", mass=1.0, inertia=1.0)
    scene.prismatic("rail", "ground.origin", "block.origin").measure("place", "x", of="block.origin")
    model = scene.force("wear", "block.origin", "-k * atan(place)", 0).model()
    with pytest.raises(gpu.NoGpu, match="uses atan of the C library.*use the CPU"):
        model.ensemble({"k": [1.0, 2.0]}, scheme="rk4", dt=1e-3, t_end=0.1, reduce={"block.x": "end"}, device="gpu")
