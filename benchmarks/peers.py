#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""One touch with ten slide steps, and one cycle of ion transport, in other codes and in ionskin: time and memory beside
the error of what was asked for. The tables of docs/peers.md.

    /usr/bin/python3 benchmarks/peers.py build/ionskin [--part contact|transport] [--json FILE]

Uses those of the other codes that are installed, and says which Debian package brings one that is not. The references are
stored below; --reference computes them again.
"""

import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from foreign import ionskin_runs
from foreign.tables import equal_accuracy, markdown, with_errors

HERE = Path(__file__).resolve().parent / "foreign"
ONE_THREAD = {name: "1" for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")}
PYTHON = "/usr/bin/python3"  # Debian's modules are seen by Debian's Python alone

# name: Debian package, how its version is found
CODES = {
    "CalculiX": ("calculix-ccx", ["ccx", "-v"]),
    "GetFEM": ("python3-getfem", [PYTHON, "-c", "import getfem"]),
    "FEniCSx": ("python3-dolfinx", [PYTHON, "-c", "import dolfinx; print(dolfinx.__version__)"]),
}

# part: code, script, its settings, from coarse to fine
FOREIGN = {
    "contact": [("CalculiX", "calculix_contact.py", [("0.12", "2"), ("0.06", "3")]),
                ("GetFEM", "getfem_contact.py", [("0.12", "2"), ("0.06", "3")])],
    "transport": [("FEniCSx", "fenicsx_transport.py", [("20", "1", "2", "1.5", "0.1"), ("40", "1", "2", "1.4", "0.05")])],
}
# Runs whose mean is the reference of each part, of --reference. Contact: of two codes with different methods.
FINE = {"contact": [("GetFEM", "getfem_contact.py", ("0.03", "3")), ("ionskin", None, ("standard", "2"))],
        "transport": [("ionskin", None, ("fine", "3"))]}
REFERENCE = {
    "contact": {"normal force": 0.43126, "shear of the touch": 3.3271e-4, "friction force": 0.12935,
                "shear of the slide": 4.7843e-4},
    "transport": {"charge": 9.431565e-07, "current": -1.1926245e-06},
}
RESOLVED = {"contact": 3.5e-3, "transport": 0.0}  # errors below are alike: the two runs of the contact differ by up to 0.7 %


def version(code):
    """Installed version of a code, or None."""
    package, command = CODES[code]
    try:
        answer = subprocess.run(command, cwd="/", capture_output=True, text=True, check=False, timeout=60)
    except (OSError, subprocess.TimeoutExpired):
        return None
    if answer.returncode and code != "CalculiX":  # ccx -v ends with 201
        return None
    query = subprocess.run(["dpkg-query", "-W", "-f=${Version}", package], capture_output=True, text=True, check=False)
    return query.stdout or " ".join(answer.stdout.split())


# Peak memory of a child counts what its parent had before the child became another program: a small one starts it.
LAUNCHER = """
import json, os, sys
child = os.posix_spawnp(sys.argv[2], sys.argv[2:], os.environ)
_, status, usage = os.wait4(child, 0)
with open(sys.argv[1], "w") as file:
    json.dump([usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024 / 1e6], file)
sys.exit(1 if status else 0)
"""


def measure(command, folder):
    """Runs a child in `folder`; what it printed, processor time [s] and peak memory [MB] of it and its own children."""
    cost = Path(folder) / "cost"
    done = subprocess.run([sys.executable, "-I", "-S", "-c", LAUNCHER, cost, *command], cwd=folder, capture_output=True,
                          text=True, check=False, env={**os.environ, **ONE_THREAD})
    if done.returncode:
        raise RuntimeError(f"{command[0]} gave up: {done.stderr[-600:]}")
    return done.stdout, dict(zip(("processor_s", "peak_MB"), json.loads(cost.read_text())))


def run_foreign(code, script, setting):
    with tempfile.TemporaryDirectory() as folder:
        if code == "FEniCSx":  # compiles its forms once for all meshes: not counted
            measure([PYTHON, HERE / script, *setting, "1"], folder)
        printed, cost = measure([PYTHON, HERE / script, *setting], folder)
    answer = json.loads(printed.strip().splitlines()[-1])
    return {"code": code, "setting": " ".join(setting), "unknowns": answer["unknowns"], **cost,
            "figures": ionskin_runs.flat(answer)}


def run_ionskin(program, part, setting):
    with tempfile.TemporaryDirectory() as folder:
        command = ionskin_runs.prepare(program, part, setting, folder)
        _, cost = measure(command, folder)
        figures = ionskin_runs.read(part, folder)
        check = subprocess.run([program, "check", "case.toml", "--json"], cwd=folder, capture_output=True, text=True, check=True)
    unknowns = json.loads(check.stdout)["cost"]["mechanics_unknowns" if part == "contact" else "ion_unknowns"]
    return {"code": "ionskin", "setting": " ".join(setting), "unknowns": unknowns, **cost, "figures": figures}


def references(program, parts, versions):
    """The fine runs of each part and the means of their figures, of those codes that are installed."""
    for part in parts:
        runs = [run_foreign(code, script, setting) if script else run_ionskin(program, part, setting)
                for code, script, setting in FINE[part] if not script or versions[code]]
        means = {name: sum(run["figures"][name] for run in runs) / len(runs) for name in REFERENCE[part]}
        print(json.dumps({part: means, "runs": runs}, indent=1), flush=True)


def compare(program, part, versions, most):
    """All runs of one part, as they end."""
    for setting in ionskin_runs.SETTINGS[part]:
        yield run_ionskin(program, part, setting)
    for code, script, settings in FOREIGN[part]:
        for setting in settings[:most] if versions[code] else ():
            try:
                yield run_foreign(code, script, setting)
            except RuntimeError as error:
                print(f"{code} {' '.join(setting)}: {error}", file=sys.stderr)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="the program ionskin", nargs="?", default="build/ionskin")
    parser.add_argument("--part", choices=list(FOREIGN), help="one part alone")
    parser.add_argument("--settings", type=int, metavar="COUNT", help="only the COUNT coarsest settings of each other code")
    parser.add_argument("--json", metavar="FILE", help="write all figures there, too")
    parser.add_argument("--reference", action="store_true", help="compute the stored references again")
    arguments = parser.parse_args()
    program = shutil.which(arguments.program)
    if not program:
        parser.error(f"{arguments.program}: no such program; build it, or say where it is")
    parts = [arguments.part] if arguments.part else list(FOREIGN)
    versions = {code: version(code) for code in CODES}
    for code, installed in versions.items():
        print(f"{code}: {installed or 'not installed, left out: apt-get install ' + CODES[code][0]}", flush=True)
    if arguments.reference:
        return references(Path(program).resolve(), parts, versions)
    report = {"load": os.getloadavg(), "versions": versions, "reference": REFERENCE, "runs": {}}
    print("load of the machine: " + " ".join(f"{load:.1f}" for load in report["load"]))
    for part in parts:
        runs = []
        for run in compare(Path(program).resolve(), part, versions, arguments.settings):
            runs.append(with_errors(run, REFERENCE[part], RESOLVED[part]))
            print(f"  {run['code']} {run['setting']}: {run['processor_s']:.1f} s", file=sys.stderr, flush=True)
        report["runs"][part] = equal_accuracy(runs)
        print(f"\n{part}\n\n" + markdown(report["runs"][part]), flush=True)
        if arguments.json:
            Path(arguments.json).write_text(json.dumps(report, indent=1) + "\n", encoding="utf-8")
    return None


if __name__ == "__main__":
    main()
