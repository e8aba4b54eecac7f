#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Makes a wheel of what is built: the Python package, live skins, the program and its solver.

    scripts/make_wheel.py BUILD VERSION    prints the wheel, in BUILD/wheel

Libraries that a manylinux wheel must bring lie inside, found from where they stand (patchelf). The tag tells the GNU C library that
they ask for. The solver as a Python module is for the version of Python that it was built for; any other from 3.11 on has all else."""

import base64
import hashlib
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
# What the host has: the policy of PEP 600.
OF_HOST = re.compile(r"(linux-vdso|ld-linux.*|lib(c|m|dl|rt|pthread|util|resolv|nsl|stdc\+\+|gcc_s|z|expat))\.so(\.\d+)*")
PROGRAMS = ("ionskin-solver", "ionskin-extras", "ionskin-studio", "ionskin_live_fmu.so")
ENTRY = '''# SPDX-License-Identifier: Apache-2.0
"""The program of the wheel."""

import os
import pathlib
import sys


_HERE = pathlib.Path(__file__).resolve().parent
os.environ.setdefault("UDUNITS2_XML_PATH", str(_HERE / "share" / "udunits" / "udunits2.xml"))  # units of case files


def main() -> None:
    """Becomes the program, which makes its reports with this Python."""
    settings = {"IONSKIN_PYTHON": sys.executable, "IONSKIN_PYTHON_PATH": str(_HERE.parent),
                "IONSKIN_LIBRARIES": str(_HERE / "lib")}
    os.execve(_HERE / "bin" / "ionskin", ["ionskin", *sys.argv[1:]], {**os.environ, **settings})
'''


def run(*command) -> str:
    return subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True).stdout


def libraries(file: pathlib.Path) -> dict[str, pathlib.Path]:
    """Libraries that the loader finds for a file, without those of the host."""
    found = {}
    for name, place in re.findall(r"^\s*(\S+) => (/\S+)", run("ldd", file), re.MULTILINE):
        if not OF_HOST.fullmatch(name):
            found[name] = pathlib.Path(place)
    return found


def stage(build: pathlib.Path, into: pathlib.Path) -> list[pathlib.Path]:
    """Lays the files out as they are installed. Returns those that are loaded or executed."""
    shutil.copytree(ROOT / "python" / "ionskin", into / "ionskin", ignore=shutil.ignore_patterns("__pycache__"))
    program = into / "ionskin_program"
    for part in ("bin", "libexec/ionskin", "lib"):
        (program / part).mkdir(parents=True)
    (program / "__init__.py").write_text(ENTRY)
    for folder in ("cases", "materials"):
        shutil.copytree(ROOT / folder, program / "share" / "ionskin" / folder)
    shutil.copytree("/usr/share/xml/udunits", program / "share" / "udunits")
    shutil.copy(ROOT / "src" / "ionskin" / "live" / "interface" / "ionskin_live.h", into / "ionskin" / "live")
    files = [(build / "ionskin", program / "bin"), (build / "python" / "libionskin_live.so.1", into / "ionskin" / "live")]
    files += [(build / name, program / "libexec" / "ionskin") for name in PROGRAMS if (build / name).exists()]
    files += [(module, into) for module in sorted((build / "python").glob("_ionskin_solver*.so"))]
    own = [pathlib.Path(shutil.copy(file, place)) for file, place in files]
    needed = {}
    for file in own:
        needed |= libraries(file)
    brought = [pathlib.Path(shutil.copy(place, program / "lib" / name)) for name, place in sorted(needed.items())]
    for file in own + brought:
        file.chmod(0o755)
        run("strip", "--strip-unneeded", file)
        if libraries(file):
            depth = len(file.parent.relative_to(into).parts)
            # An old-fashioned path holds for what the libraries themselves load, too.
            run("patchelf", "--force-rpath", "--set-rpath", "$ORIGIN/" + "../" * depth + "ionskin_program/lib", file)
    licences(list(needed.values()), into / "ionskin_program" / "licences")
    return own + brought


def licences(places: list[pathlib.Path], into: pathlib.Path) -> None:
    """Writes the copyright of ionskin, and of each Debian package that a library is of."""
    into.mkdir()
    shutil.copy(ROOT / "packaging" / "copyright", into / "ionskin")
    for place in [*places, pathlib.Path("/usr/share/xml/udunits/udunits2.xml")]:
        file = str(place.resolve())  # which dpkg may know without /usr
        package = run("dpkg-query", "-S", f"*{file.removeprefix('/usr')}").split(":")[0]
        shutil.copy(pathlib.Path("/usr/share/doc") / package / "copyright", into / package)


def tag(files: list[pathlib.Path]) -> str:
    newest = max(int(minor) for file in files for minor in re.findall(r"GLIBC_2\.(\d+)", run("objdump", "-T", file)))
    platform = f"manylinux_2_{newest}_{sysconfig.get_platform().split('-', 1)[1].replace('-', '_')}"
    return f"py3-none-{platform}"


def describe(into: pathlib.Path, version: str, name: str) -> None:
    info = into / f"ionskin-{version}.dist-info"
    info.mkdir()
    (info / "METADATA").write_text(
        f"Metadata-Version: 2.1\nName: ionskin\nVersion: {version}\nSummary: simulator of ionic artificial skins\n"
        "License: Apache-2.0\nRequires-Python: >=3.11\nRequires-Dist: numpy\n"
        "Requires-Dist: h5py; extra == 'reports'\nRequires-Dist: matplotlib; extra == 'reports'\n"
        "Requires-Dist: jinja2; extra == 'reports'\nProvides-Extra: reports\n\n" + (ROOT / "README.md").read_text())
    (info / "WHEEL").write_text(f"Wheel-Version: 1.0\nGenerator: ionskin\nRoot-Is-Purelib: false\nTag: {name}\n")
    (info / "entry_points.txt").write_text("[console_scripts]\nionskin = ionskin_program:main\n")
    record = info / "RECORD"
    lines = []
    for file in sorted(path for path in into.rglob("*") if path.is_file()):
        digest = base64.urlsafe_b64encode(hashlib.sha256(file.read_bytes()).digest()).rstrip(b"=").decode()
        lines.append(f"{file.relative_to(into)},sha256={digest},{file.stat().st_size}\n")
    record.write_text("".join(lines) + f"{record.relative_to(into)},,\n")


def main() -> None:
    build, version = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    if shutil.which("patchelf") is None:
        sys.exit("error: patchelf is missing: apt-get install patchelf")
    with tempfile.TemporaryDirectory() as folder:
        into = pathlib.Path(folder) / "wheel"
        into.mkdir()
        files = stage(build, into)
        name = tag(files)
        describe(into, version, name)
        wheel = build / "wheel" / f"ionskin-{version}-{name}.whl"
        wheel.parent.mkdir(exist_ok=True)
        made = pathlib.Path(folder) / wheel.name
        with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as archive:
            for file in sorted(path for path in into.rglob("*") if path.is_file()):
                archive.write(file, file.relative_to(into))
        shutil.move(made, wheel)
    print(wheel)


if __name__ == "__main__":
    main()
