# SPDX-License-Identifier: Apache-2.0
"""Lets every call of the system in a run and in a sweep fail, one after the other, and resumes each to its end.

    IONSKIN_FAULTS=build/tests/fault_injection/libionskin_fault_injection.so /usr/bin/python3 faults.py [--faults N]

Each faulty run must end with 0, 2 or 3 and a message, and `--resume` must then give the result of an undisturbed run to
the last bit. Prints a table of faults tried; ends with 1 where one was not survived.
"""

import argparse
import collections
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PROGRAM = os.environ.get("IONSKIN_PROGRAM", str(ROOT / "build" / "ionskin"))
FAULTS = os.environ.get("IONSKIN_FAULTS",
                        str(ROOT / "build" / "tests" / "fault_injection" / "libionskin_fault_injection.so"))
SMALL = [str(ROOT / "cases" / "paper" / "coarse.toml"), "--no-report", "--quiet", "--threads", "1", "--set",
         "numerics.mesh_refinement=0.3", "--set", "skin.sides=symmetry"]
VERBS = {"run": ["run", *SMALL], "sweep": ["sweep", *SMALL, "--over", "coupling.coefficient=0.05,0.1"]}
SHORT = ["--set", "numerics.error_estimate=off", "--set", "numerics.time_refinement=0.3"]
CALLS = ("write", "rename", "fsync", "open", "malloc")
RESULTS = ("signals.csv", "sampled.csv", "sweep.csv")


class Driver:
    """Runs one verb in a scratch folder."""

    def __init__(self, arguments, folder):
        self.arguments, self.folder = arguments, folder
        self.expected = None

    def run(self, out, *options, **faults):
        """Runs the program with the given variables IONSKIN_FAULT_..."""
        environment = os.environ | {"OPENBLAS_NUM_THREADS": "1"}
        if faults:
            environment |= {"LD_PRELOAD": FAULTS, "IONSKIN_FAULT_FOLDER": str(self.folder / "work")}
            environment |= {f"IONSKIN_FAULT_{name.upper()}": str(value) for name, value in faults.items()}
        return subprocess.run([PROGRAM, *self.arguments, "-o", self.folder / "work" / out, *options], env=environment,
                              capture_output=True, text=True, check=False, cwd=self.folder, timeout=300)

    def clear(self):
        """An empty place for outputs."""
        shutil.rmtree(self.folder / "work", ignore_errors=True)
        (self.folder / "work").mkdir()

    def results(self):
        """Bytes of the tables by name."""
        out = self.folder / "work" / "out"
        return {str(path.relative_to(out)): path.read_bytes() for path in sorted(out.rglob("*.csv")) if path.name in RESULTS}

    def count(self, call):
        """Number of such calls that an undisturbed run makes; its results are what is expected."""
        self.clear()
        counter = self.folder / "count"
        process = self.run("out", call=call, number=0, count=counter)
        if process.returncode != 0:
            sys.exit(f"the undisturbed run failed: {process.stderr}")
        self.expected = self.results()
        return int(counter.read_text())

    def complaint(self, call, number, stays):
        """Complaint about the answer to a fault; empty when nothing is."""
        self.clear()
        process = self.run("out", call=call, number=number, stays=stays)
        last = process.stderr.strip().splitlines()[-1:] or [""]
        if process.returncode not in (0, 2, 3):
            return process.returncode, f"ended with {process.returncode}: {last[0]}"
        if process.returncode != 0 and "error" not in process.stderr and "points failed; sweep.csv" not in process.stderr:
            return process.returncode, f"no message: {process.stderr}"
        again = self.run("out", *(["--resume"] if (self.folder / "work" / "out").exists() else []))
        if again.returncode != 0:
            return process.returncode, f"not resumed ({again.returncode}): {again.stderr.strip()}"
        if self.results() != self.expected:
            return process.returncode, "another result"
        left = list((self.folder / "work").rglob("*.ionskin-pending"))
        return process.returncode, f"left behind {left[0].name}" if left else ""


def faults(total, most):
    """Pairs of the call that fails, and whether all later ones do: all of them, or so many over the whole run."""
    if most is None or most >= 2 * total:
        return [(number, stays) for number in range(1, total + 1) for stays in (0, 1)]
    return [(1 + (2 * i + 1) * total // (2 * most), i % 2) for i in range(most)]


def main():
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--faults", type=int, help="so many of each kind of call, instead of all")
    parser.add_argument("--short", action="store_true", help="runs of few steps without stated errors")
    parser.add_argument("--verb", choices=VERBS, action="append")
    parser.add_argument("--call", choices=CALLS, action="append")
    arguments = parser.parse_args()
    complaints = 0
    with tempfile.TemporaryDirectory(prefix="ionskin-faults-") as scratch:
        for verb in arguments.verb or VERBS:
            driver = Driver([*VERBS[verb], *(SHORT if arguments.short else [])], pathlib.Path(scratch))
            for call in arguments.call or CALLS:
                total = driver.count(call)
                if not total:
                    sys.exit(f"{verb} never calls {call}: the faults are not injected")
                tried, codes = 0, collections.Counter()
                for number, stays in faults(total, arguments.faults):
                    code, complaint = driver.complaint(call, number, stays)
                    tried, codes[code] = tried + 1, codes[code] + 1
                    if complaint:
                        complaints += 1
                        print(f"{verb}, {call} {number}{' and later' * stays} of {total}: {complaint}", flush=True)
                print(f"{verb}: {call} called {total} times, {tried} faults, exit codes {dict(sorted(codes.items()))}",
                      flush=True)
    print(f"{complaints} faults not survived")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
