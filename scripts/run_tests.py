# SPDX-License-Identifier: Apache-2.0
"""Runs the tests of a preset and sums up: run_tests.py PRESET [options of ctest]

Every test must belong to a tier and have a time limit. Tells at the end the ten that took longest, how long all took, and what
was skipped; ends with 1 where a test failed, was skipped unexpectedly, or could not be run.
"""

import json
import pathlib
import re
import resource
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
TIERS = {"quick", "check", "long"}
TEST = re.compile(r'^"([^"\n]+)" start time: .*?^Output:\n(.*?)^<end of output>\nTest time = +([\d.]+) sec',
                  re.DOTALL | re.MULTILINE)
SKIPPED = re.compile(r"^skipped(?: unexpectedly)?: .*", re.MULTILINE)
PROCESSOR = re.compile(r"^processor time: ([\d.]+) s$", re.MULTILINE)


def folder_of(preset):
    """The build folder of a preset of tests."""
    presets = json.loads((ROOT / "CMakePresets.json").read_text(encoding="utf-8"))
    tests = {test["name"]: test for test in presets["testPresets"]}
    while "configurePreset" not in tests[preset]:
        preset = tests[preset]["inherits"]
    build, = (build for build in presets["configurePresets"] if build["name"] == tests[preset]["configurePreset"])
    return pathlib.Path(build["binaryDir"].replace("${sourceDir}", str(ROOT)))


def complaints(tests):
    """Complaints about tests that lack what every test has."""
    for test in tests:
        properties = {one["name"]: one["value"] for one in test["properties"]}
        if len(TIERS & set(properties.get("LABELS", []))) != 1:
            yield f"{test['name']} belongs to no tier: ionskin_tier in cmake/IonskinTests.cmake"
        if not properties.get("TIMEOUT"):
            yield f"{test['name']} has no TIMEOUT"


def sum_up(log, seconds, processor_seconds):
    """Prints the longest tests and the skipped ones of a log of ctest, and how long all took."""
    found = [(float(took), name, output) for name, output, took in TEST.findall(log)]
    print("\nThe longest tests, in seconds (of processor time where it is known):")
    for took, name, output in sorted(found, reverse=True)[:10]:
        processor = PROCESSOR.findall(output)
        print(f"  {took:7.1f}  {name}" + (f" ({processor[-1]})" if processor else ""))
    skipped = [(name, line) for _, name, output in found for line in SKIPPED.findall(output)]
    print(f"{len(found)} tests of ctest ran, {len(skipped)} tests in them were skipped")
    for name, line in skipped:
        print(f"  {name}: {line}")
    print(f"{seconds:.0f} s, {processor_seconds:.0f} s of processor time")


def main(preset, *options):
    """Command line."""
    listed = subprocess.run(["ctest", "--preset", preset, *options, "--show-only=json-v1"], cwd=ROOT, check=True, capture_output=True,
                          text=True)
    tests = json.loads(listed.stdout)["tests"]
    wrong = [*complaints(tests)] or ([] if tests else [f"no test belongs to the preset {preset}"])
    if wrong:
        sys.exit("\n".join(wrong))
    begun = time.monotonic()
    ended = subprocess.run(["ctest", "--preset", preset, *options], cwd=ROOT, check=False).returncode
    passed, used = time.monotonic() - begun, resource.getrusage(resource.RUSAGE_CHILDREN)
    log = folder_of(preset) / "Testing" / "Temporary" / "LastTest.log"
    sum_up(log.read_text(encoding="utf-8", errors="replace"), passed, used.ru_utime + used.ru_stime)
    sys.exit(1 if ended else 0)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
