#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Compares packages.txt with what the tree looks for: searches of CMake, headers in angle brackets, Python modules and
programs. Each is named by a package of a tier that is there when it is looked for, no package is named for nothing, and
where dpkg knows the files, they belong to the package that is named."""

import functools
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
KINDS = ("cmake", "include", "import", "run", "named", "needs")
FIRST = "program"
# What Debian's compiler and CMake bring by themselves.
OF_CMAKE = {"Threads"}
OF_THE_C_LIBRARY = re.compile(r"^(sys|arpa|netinet|net|linux)/|^(assert|ctype|dlfcn|errno|fcntl|float|grp|inttypes|limits|link|"
                              r"locale|malloc|math|netdb|omp|poll|pthread|pwd|sched|signal|spawn|std\w+|string|strings|"
                              r"sysexits|termios|time|unistd|xlocale|x86intrin|immintrin|cpuid)\.h$")
# Interfaces of ours that are found by themselves.
ALIASES = {"ionskin_live.h": None, "ionskin_live.hpp": None}
# Programs of others that benchmarks compare with, installed by hand: their modules.
OF_OTHERS = {"dolfinx", "ufl", "petsc4py", "mpi4py", "getfem", "gmsh"}
# A tier that a folder may count on, beside the first.
FOLDERS = {"src/ionskin/study/fit": "parts", "src/ionskin/live/fmu": "parts", "apps/ionskin/studio": "parts",
           "python/bindings": "parts", "tests": None, "benchmarks": None, "fuzz": None, "examples": None}
SEARCH = re.compile(r"\b(find_package|pkg_check_modules|find_path|find_library|find_program|ionskin_find_library)\s*\(([^)]*)\)")


def read_packages(text):
    """{package: (tier, [(kind, name), ...])} and the messages of what cannot be read."""
    packages, mistakes, tier = {}, [], None
    for number, line in enumerate(text.splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        if match := re.fullmatch(r"\[([a-z]+)\] \S.*\.", line) or re.fullmatch(r"\[([a-z]+)\] \S.*`", line):
            tier = match[1]
            continue
        match = re.fullmatch(r"([a-z0-9.+-]+)((?:\s+(?:%s):\S+)+)\s+(\S.*\.)" % "|".join(KINDS), line)
        if not match or tier is None or match[1] in packages:
            mistakes.append(f"packages.txt:{number}: not 'package kind:name ... A sentence.', or named twice: {line}")
            continue
        packages[match[1]] = tier, [tuple(word.split(":", 1)) for word in match[2].split()]
    return packages, mistakes


def listed(generator):
    """The values of a generator, made once."""
    return functools.cache(lambda: list(generator()))


@functools.cache
def sources(*patterns):
    """Files that git tracks or would, by pattern."""
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", *patterns], cwd=ROOT, capture_output=True, text=True,
                            check=True).stdout.splitlines()
    return [name for name in listed if (ROOT / name).is_file()]


@listed
def searches():
    """(file, what is looked for, whether it must be there) of each search of CMake."""
    for file in sources("CMakeLists.txt", "*/CMakeLists.txt", "cmake/*.cmake"):
        if file.startswith("examples/"):
            continue
        text = re.sub(r"#.*", "", (ROOT / file).read_text())
        for call, arguments in SEARCH.findall(text):
            words = arguments.split()
            if words[0].startswith("${"):
                continue  # inside a function of ours, whose calls are found too
            required = "REQUIRED" in words or call == "ionskin_find_library"
            if call == "find_package":
                yield file, words[0], required
            elif call == "pkg_check_modules":
                yield file, next(word for word in words[1:] if word not in ("REQUIRED", "QUIET", "IMPORTED_TARGET")), required
            else:
                names = [word for word in words[1:] if word != "NAMES"]
                yield file, names[0], required


@listed
def headers():
    """(file, header) of each header in angle brackets that neither C++ nor the C library has."""
    for file in sources("*.cpp", "*.hpp", "*.c", "*.h"):
        for header in re.findall(r"^\s*#\s*include\s*<([^>]+)>", (ROOT / file).read_text(), re.MULTILINE):
            header = ALIASES.get(header, header)
            if header and ("." in header or "/" in header) and not OF_THE_C_LIBRARY.match(header):
                yield file, header


@listed
def modules():
    """(file, module) of each Python module that neither Python nor this tree has."""
    own = {"_ionskin_solver"}.union(*({*pathlib.PurePath(file).parts[:-1], pathlib.PurePath(file).stem} for file in sources("*.py")))
    for file in sources("*.py"):
        for words in re.findall(r"^\s*(?:import ([A-Za-z_][\w.]*)|from ([A-Za-z_][\w.]*) import )", (ROOT / file).read_text(), re.MULTILINE):
            module = max(words).split(".")[0]
            if module not in own and module not in sys.stdlib_module_names and module not in OF_OTHERS:
                yield file, module


@functools.cache
def script():
    """Text of every file that may name a program or a word."""
    files = sources("Makefile", "CMakePresets.json", "scripts/*.sh", "*CMakeLists.txt", "cmake/*.cmake", "*.py", "*.mjs", "apps/*.cpp")
    return "\n".join((ROOT / file).read_text() for file in files if file != "scripts/check_packages.py")


@functools.cache
def is_named(word):
    """True if a file of `script` holds a word."""
    return re.search(rf"(?<![\w-]){re.escape(word)}(?![\w-])", script()) is not None


def allowed(file):
    """The tiers that a file may count on; None: every one."""
    for folder, tier in FOLDERS.items():
        if file.startswith(folder + "/"):
            return None if tier is None else {FIRST, tier}
    return {FIRST}


def misplaced(packages):
    """Yields a message for each thing that is looked for and that no package of the right tier brings."""
    brought = {}
    for package, (tier, names) in packages.items():
        for kind, name in names:
            brought.setdefault((kind, name), set()).add(tier)

    def tiers_of(name, *kinds):
        return set().union(*(brought.get((kind, name), set()) for kind in kinds))

    for file, name, required in searches():
        tiers = tiers_of(name, "cmake", "include", "run")
        if name in OF_CMAKE:
            continue
        if not tiers and "/" in name:
            tiers = tiers_of(name.split("/")[0], "include")
        if not tiers:
            tiers = tiers_of(name, "include") | tiers_of(f"{name}.h", "include") | tiers_of(f"{name}2.h", "include")
        if not tiers:
            yield f"{file}: looks for {name}, which no package of packages.txt brings"
        elif required and not file.startswith("tests/") and FIRST not in tiers:
            yield f"{file}: requires {name}, which is not in the tier '{FIRST}': leave a part out where it is missing"
        elif not required and FIRST in tiers and len(tiers) == 1:
            yield f"{file}: does without {name}, which is in the tier '{FIRST}': require it, or move the package"
    for file, header in headers():
        tiers = tiers_of(header, "include", "cmake") or tiers_of(header.split("/")[0], "include")
        fits = allowed(file)
        if not tiers:
            yield f"{file}: includes <{header}>, which no package of packages.txt brings"
        elif fits is not None and not tiers & fits:
            yield f"{file}: includes <{header}> of the tier '{min(tiers)}', which it cannot count on"
    for file, module in modules():
        tiers = tiers_of(module, "import")
        if not tiers:
            yield f"{file}: imports {module}, which no package of packages.txt brings"


def unused(packages):
    """Yields a message for each package that nothing looks for."""
    looked_for = {name for _, name, _ in searches()}
    included = {part for _, header in headers() for part in (header, header.split("/")[0])} | {"Python.h"}
    imported = {module for _, module in modules()}
    for package, (_, names) in packages.items():
        for kind, name in names:
            seen = {"cmake": name in looked_for, "include": name in included, "import": name in imported,
                    "needs": name in packages}
            if not (seen[kind] if kind in seen else is_named(name)):
                yield f"packages.txt: {package} is there for {kind}:{name}, which nothing in the tree looks for"


def strangers(packages):
    """Yields a message for each file that dpkg says to be another package's."""
    if shutil.which("dpkg-query") is None:
        return
    places = {"include": ("/usr/include/{}", "/usr/include/*/{}"), "run": ("/usr/bin/{}", "/usr/sbin/{}"),
              "import": ("/usr/lib/python3/dist-packages/{}",)}
    known = subprocess.run(["dpkg-query", "-W", "-f", "${Package} ${db:Status-Status} ${Depends}\n", *packages], capture_output=True,
                           text=True, check=False).stdout
    depends = {line.split()[0]: set(re.findall(r"[a-z0-9][a-z0-9.+-]+", line)) for line in known.splitlines() if " installed " in line}
    for package in depends:
        for kind, name in packages[package][1]:
            patterns = [place.format(name) for place in places.get(kind, ())]
            owners = set()
            if patterns:
                answer = subprocess.run(["dpkg-query", "-S", *patterns], capture_output=True, text=True, check=False).stdout
                owners = {owner.split(":")[0] for line in answer.splitlines() if "diversion" not in line
                          for owner in line.rsplit(": ", 1)[0].split(", ")}
            if owners and not owners & depends[package]:
                yield f"packages.txt: {kind}:{name} belongs to {', '.join(sorted(owners))}, not to {package}"


def main():
    packages, found = read_packages((ROOT / "packages.txt").read_text())
    found += [*misplaced(packages), *unused(packages), *strangers(packages)]
    for message in found:
        print(message)
    print(f"packages: {len(found)} differences")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
