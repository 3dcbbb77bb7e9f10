"""A model as a functional mock-up unit: co-simulation by its scheme and model exchange, with sources and binaries."""

from __future__ import annotations

import hashlib
import os
import platform
import shlex
import subprocess
import sys
import tempfile
import zipfile
from collections.abc import Sequence
from dataclasses import dataclass, field
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from runtime.contract.arguments import PLACE, arguments
from runtime.contract.cache import cache_folder, refused_folder
from runtime.contract.errors import CompilerError, ModelError
from runtime.contract.files import replacing
from runtime.contract.model import EmittedModel
from runtime.engine.c_source import find_compiler
from runtime.export.c_bundle import Exported, c_files, exported
from runtime.export.fmu_texts import description, fmu_source

FLAGS = ("-std=c99", "-O2", "-shared", "-fPIC", "-ffp-contract=off", "-fvisibility=hidden")


@dataclass(frozen=True)
class Platform:
    """Folders of binaries in both versions of the standard, ending of a library, and zig's name for the target."""

    second: str
    third: str
    ending: str
    target: str


PLATFORMS = {
    "linux64": Platform("linux64", "x86_64-linux", "so", "x86_64-linux-gnu"),
    "win64": Platform("win64", "x86_64-windows", "dll", "x86_64-windows-gnu"),
    "darwin64": Platform("darwin64", "x86_64-darwin", "dylib", "x86_64-macos"),
    "aarch64": Platform("aarch64-linux", "aarch64-linux", "so", "aarch64-linux-gnu"),
    "aarch64-darwin": Platform("aarch64-darwin", "aarch64-darwin", "dylib", "aarch64-macos"),
}


@dataclass(frozen=True)
class Written:
    """The file, the platforms that it has binaries for, and why there are none for others."""

    path: Path
    platforms: list[str]
    missing: dict[str, str] = field(default_factory=dict)


def this_platform() -> str:
    """The name of the platform that this runs on; "" if it is not among PLATFORMS."""
    arm = platform.machine().lower() in ("arm64", "aarch64")
    names = {"linux": ("linux64", "aarch64"), "win32": ("win64", ""), "darwin": ("darwin64", "aarch64-darwin")}
    return names.get(sys.platform, ("", ""))[arm]


def write_fmu(one: Exported, path: str | Path, fmi: int = 2, platforms: Sequence[str] | None = None) -> Written:
    """Write an FMU; sources always, binaries for platforms (None: this one) by $CC or ziglang where they are there.

    Raises ModelError for other versions and platforms, CompilerError where a compiler fails, OutputError.
    """
    if fmi not in (2, 3):
        raise ModelError(f"version {fmi} of FMI", "is not known", "take 2 or 3")
    wanted = list(platforms) if platforms is not None else [name for name in (this_platform(),) if name]
    unknown = [name for name in wanted if name not in PLATFORMS]
    if unknown:
        raise ModelError(f"platform {', '.join(unknown)}", "is not known", f"take some of {', '.join(PLATFORMS)}")
    files = fmu_texts(one, fmi)
    done, missing, binaries = list[str](), dict[str, str](), dict[str, bytes]()
    for name in wanted:
        compiler = _compiler(name)
        if compiler is None:
            missing[name] = "no compiler: set CC, or install 'symgen[zig]'"
            continue
        target = PLATFORMS[name]
        folder = target.second if fmi == 2 else target.third
        binaries[f"binaries/{folder}/{one.prefix[:-1]}.{target.ending}"] = _built(
            files, one.prefix[:-1], compiler, target
        )
        done.append(name)
    contents: dict[str, str | bytes] = {**files, **binaries}
    with replacing(path) as temporary:
        with zipfile.ZipFile(temporary, "w", zipfile.ZIP_DEFLATED) as archive:
            for inside, content in contents.items():
                archive.writestr(zipfile.ZipInfo(inside), content, zipfile.ZIP_DEFLATED)
    return Written(Path(path), done, missing)


@arguments(path=PLACE)
def export_fmu(
    model: EmittedModel, path: str | Path, fmi: int = 2, platforms: Sequence[str] | None = None, **steps: Any
) -> Written:
    """Write the model with a scheme as an FMU.

    Parameters
    ----------
    model : Model
        The mechanism.
    path : path
        The file, .fmu.
    fmi : {2, 3}, optional
        Version of the standard.
    platforms : sequence of str, optional
        Platforms that binaries are made for, where a compiler is there; this one by default.
    **steps
        scheme, dt [s], m, options, parameters, name: the step of co-simulation.

    Returns
    -------
    Written
        The file, and what its binaries are for; see `write_fmu`.

    Raises
    ------
    ModelError, SchemeError, CompilerError, OutputError
        For what cannot leave, unknown versions and platforms, a compiler that fails, a place that takes nothing.

    References
    ----------
    Modelica Association, Functional Mock-up Interface Specification, versions 2.0 and 3.0.
    """
    return write_fmu(exported(model, **steps), path, fmi, platforms)


def fmu_texts(one: Exported, fmi: int) -> dict[str, str]:
    """All files of an FMU but its binaries."""
    code, stem = c_files(one), one.prefix[:-1]
    token = hashlib.sha256(
        "".join([*code.values(), fmu_source(one, fmi, ""), description(one, fmi, "")]).encode()
    ).hexdigest()
    texts = {"modelDescription.xml": description(one, fmi, token)}
    texts |= {f"sources/{name}": text for name, text in code.items()}
    texts["sources/fmu.c"] = fmu_source(one, fmi, token)
    if fmi == 3:
        texts["sources/buildDescription.xml"] = (
            '<?xml version="1.0" encoding="UTF-8"?>\n<fmiBuildDescription fmiVersion="3.0">\n'
            f'<BuildConfiguration modelIdentifier="{stem}"><SourceFileSet language="C99">'
            f'<SourceFile name="fmu.c"/><SourceFile name="{stem}.c"/></SourceFileSet></BuildConfiguration>\n'
            "</fmiBuildDescription>\n"
        )
    return texts


def _compiler(name: str) -> list[str] | None:
    """A command that compiles for a platform: the machine's for its own, else zig."""
    own = find_compiler() if name == this_platform() else None
    if own:
        return shlex.split(own)
    if find_spec("ziglang") is not None:
        return [sys.executable, "-m", "ziglang", "cc", "-target", PLATFORMS[name].target]
    return None


def _built(files: dict[str, str], stem: str, compiler: list[str], target: Platform) -> bytes:
    """The library of an FMU's sources. Raises CompilerError."""
    with tempfile.TemporaryDirectory(prefix="symgen-fmu-") as folder:
        for name, text in files.items():
            if name.startswith("sources/"):
                (Path(folder) / Path(name).name).write_text(text, encoding="utf-8")
        flags = [flag for flag in FLAGS if flag != "-fPIC" or target.ending != "dll"]
        mathematics = [] if target.ending == "dll" else ["-lm"]
        library = f"{stem}.{target.ending}"
        command = [*compiler, *flags, "-o", library, "fmu.c", f"{stem}.c", *mathematics]
        kept = cache_folder() / "zig"  # its own libraries for each target, which take long to make
        environment = {**os.environ, "ZIG_GLOBAL_CACHE_DIR": folder if refused_folder(kept) else str(kept.resolve())}
        result = subprocess.run(command, cwd=folder, capture_output=True, text=True, env=environment)
        if result.returncode != 0:
            raise CompilerError(f"{shlex.join(compiler)} failed: {result.stderr.strip()[:2000]}")
        return (Path(folder) / library).read_bytes()
