"""Binaries of FMUs export what the headers of the standard declare, read from the files themselves on all platforms."""

from __future__ import annotations

import struct
import zipfile
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path

import pytest

from runtime.engine.c_source import find_compiler
from runtime.export.c_bundle import exported
from runtime.export.fmu import this_platform, write_fmu
from runtime.model import Model

# all functions that fmi2Functions.h and fmi3Functions.h declare, of 2.0 and 3.0
DECLARED = {
    2: """CancelStep CompletedIntegratorStep DeSerializeFMUstate DoStep EnterContinuousTimeMode EnterEventMode
        EnterInitializationMode ExitInitializationMode FreeFMUstate FreeInstance GetBoolean GetBooleanStatus
        GetContinuousStates GetDerivatives GetDirectionalDerivative GetEventIndicators GetFMUstate GetInteger
        GetIntegerStatus GetNominalsOfContinuousStates GetReal GetRealOutputDerivatives GetRealStatus GetStatus
        GetString GetStringStatus GetTypesPlatform GetVersion Instantiate NewDiscreteStates Reset SerializeFMUstate
        SerializedFMUstateSize SetBoolean SetContinuousStates SetDebugLogging SetFMUstate SetInteger SetReal
        SetRealInputDerivatives SetString SetTime SetupExperiment Terminate""",
    3: """ActivateModelPartition CompletedIntegratorStep DeserializeFMUState DoStep EnterConfigurationMode
        EnterContinuousTimeMode EnterEventMode EnterInitializationMode EnterStepMode EvaluateDiscreteStates
        ExitConfigurationMode ExitInitializationMode FreeFMUState FreeInstance GetAdjointDerivative GetBinary GetBoolean
        GetClock GetContinuousStateDerivatives GetContinuousStates GetDirectionalDerivative GetEventIndicators
        GetFMUState GetFloat32 GetFloat64 GetInt16 GetInt32 GetInt64 GetInt8 GetIntervalDecimal GetIntervalFraction
        GetNominalsOfContinuousStates GetNumberOfContinuousStates GetNumberOfEventIndicators
        GetNumberOfVariableDependencies GetOutputDerivatives GetShiftDecimal GetShiftFraction GetString GetUInt16
        GetUInt32 GetUInt64 GetUInt8 GetVariableDependencies GetVersion InstantiateCoSimulation InstantiateModelExchange
        InstantiateScheduledExecution Reset SerializeFMUState SerializedFMUStateSize SetBinary SetBoolean SetClock
        SetContinuousStates SetDebugLogging SetFMUState SetFloat32 SetFloat64 SetInt16 SetInt32 SetInt64 SetInt8
        SetIntervalDecimal SetIntervalFraction SetShiftDecimal SetShiftFraction SetString SetTime SetUInt16 SetUInt32
        SetUInt64 SetUInt8 Terminate UpdateDiscreteStates""",
}


def text_at(data: bytes, at: int) -> str:
    return data[at : data.index(b"\0", at)].decode()


def exported_by_elf(data: bytes) -> set[str]:
    """Names that are defined in .dynsym with default visibility."""
    first, size, count = *struct.unpack_from("<Q", data, 40), *struct.unpack_from("<HH", data, 58)
    sections = [struct.unpack_from("<IIQQQQII", data, first + k * size) for k in range(count)]
    table = next(one for one in sections if one[1] == 11)
    names = sections[table[6]][4]
    found = set()
    for at in range(table[4], table[4] + table[5], 24):
        name, info, other, section = struct.unpack_from("<IBBH", data, at)
        if section and info >> 4 == 1 and not other & 3:
            found.add(text_at(data, names + name))
    return found


def exported_by_pe(data: bytes) -> set[str]:
    """Names in the export directory."""
    head = struct.unpack_from("<I", data, 60)[0]
    count, optional = struct.unpack_from("<H", data, head + 6)[0], struct.unpack_from("<H", data, head + 20)[0]
    where = [struct.unpack_from("<III", data, head + 24 + optional + 40 * k + 12) for k in range(count)]

    def place(address: int) -> int:
        start, _, raw = next(one for one in where if one[0] <= address < one[0] + one[1])
        return raw + address - start

    table = place(struct.unpack_from("<I", data, head + 24 + 112)[0])
    entries, names = struct.unpack_from("<I", data, table + 24)[0], place(struct.unpack_from("<I", data, table + 32)[0])
    return {text_at(data, place(struct.unpack_from("<I", data, names + 4 * k)[0])) for k in range(entries)}


def exported_by_mach_o(data: bytes) -> set[str]:
    """External names of the symbol table that are not private, without their underscore."""
    at = 32
    for _ in range(struct.unpack_from("<I", data, 16)[0]):
        command, size = struct.unpack_from("<II", data, at)
        if command == 2:
            break
        at += size
    symbols, count, texts, _ = struct.unpack_from("<IIII", data, at + 8)
    entries = [struct.unpack_from("<IB", data, symbols + 16 * k) for k in range(count)]
    return {text_at(data, texts + name)[1:] for name, kind in entries if kind & 0x1F == 0x0F}


READERS: dict[str, Callable[[bytes], set[str]]] = {
    "so": exported_by_elf, "dll": exported_by_pe, "dylib": exported_by_mach_o
}  # fmt: skip
HERE = pytest.mark.skipif(find_compiler() is None or this_platform() != "linux64", reason="no C compiler for linux64")
BY_ZIG = [pytest.mark.skipif(find_spec("ziglang") is None, reason="no ziglang"), pytest.mark.long]
PLATFORMS = [
    pytest.param("linux64", marks=HERE),
    *(pytest.param(name, marks=BY_ZIG) for name in ("win64", "darwin64", "aarch64", "aarch64-darwin")),
]


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("platform", PLATFORMS)
def test_binaries_export_the_standards_functions_and_nothing_else(
    built_in: Callable[[str], Model], tmp_path: Path, platform: str, fmi: int
) -> None:
    """The unit's own functions stay inside, so that two units in one process do not meet."""
    path = tmp_path / "unit.fmu"
    assert write_fmu(exported(built_in("double_pendulum"), "rk4"), path, fmi, [platform]).platforms == [platform]
    with zipfile.ZipFile(path) as archive:
        (binary,) = (name for name in archive.namelist() if name.startswith("binaries/"))
        found = READERS[binary.rsplit(".", 1)[1]](archive.read(binary))
    declared = {f"fmi{fmi}{name}" for name in DECLARED[fmi].split()}
    assert declared <= found, sorted(declared - found)
    assert not {name for name in found - declared if name.startswith(("fmi", "double_pendulum"))}
