#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A prediction before the measurement: voltage per curvature of bent strips, and the touch of a soft finger on a wet taxel, with
the range that unsure constants make. Writes a file with a date and a digest, for the page of that name.

    /usr/bin/python3 benchmarks/prediction.py build/ionskin docs/prediction.json
    /usr/bin/python3 benchmarks/prediction.py --check docs/prediction.json
"""

import argparse
import csv
import datetime
import hashlib
import json
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy

CASES = Path(__file__).resolve().parent.parent / "cases" / "evidence"
CURVATURE = 10.0  # 1/m
SAMPLES = 16
MEMORY = "from memory of Xie and Okada 1995 and 1996"

# What is varied, and where its range comes from. Keys without a source are varied over all that can be.
COMMON = {
    "water.drained_poissons_ratio": ("uniform(0.3, 0.45)", "no source"),
    "electrochemistry.diffusivity": ("loguniform(1e-10 m2/s, 2.5e-9 m2/s)", "sets milliseconds only: conductivities of all four forms lie within"),
}
SOAKED = COMMON | {
    "water.mobility": ("loguniform(1.5e-18 m2/(Pa s), 5e-16 m2/(Pa s))",
                       "from self-diffusion of water upwards: permeation and sorption are two decades apart (Majsztrik et al. 2007)"),
}


def form(drag, drag_source, modulus, modulus_source, least_water):
    """Ranges of one form of soaked Nafion 117; volumes of polymer and water added, from so many molecules for each sulfonate to 22."""
    water = f"{least_water} to 22 molecules of water for each sulfonate"
    charges = [1 / (1100 / 1.98e6 + 18.07e-6 * count) for count in (22, least_water)]
    shares = [18.07e-6 * count * charge for count, charge in zip((22, least_water), charges)]
    return SOAKED | {
        "water.drag_number": (f"uniform({drag})", drag_source),
        "materials.nafion_wet.youngs_modulus": (f"uniform({modulus})", modulus_source),
        "electrochemistry.fixed_charge_concentration": (f"uniform({charges[0]:.0f} mol/m3, {charges[1]:.0f} mol/m3)", water),
        "water.volume_fraction": (f"uniform({shares[1]:.3f}, {shares[0]:.3f})", water),
    }


ANY_MODULUS = ("64 MPa, 249 MPa", "no source: between soaked H+ and H+ at 50 % humidity; Li+ < Na+ < K+ (Kawano et al. 2002)")
FORMS = {
    "H+": form("2.5, 2.9", "Zawodzinski et al. 1993; 2.6 by Ise et al. 1999", "64 MPa, 114 MPa", "data sheet, soaked at 100 and at 23 degC", 19),
    "Li+": form("13, 16", MEMORY, *ANY_MODULUS, 18),
    "Na+": form("8.5, 10.5", MEMORY, *ANY_MODULUS, 15),
    "K+": form("4, 6", MEMORY, *ANY_MODULUS, 10),
}
AIR = {
    0.5: {"water.drag_number": ("uniform(0.4, 1)", "Springer et al. 1991; Park and Caton 2008; about 1 by Zawodzinski et al. 1995, from memory"),
          "materials.nafion_air.youngs_modulus": ("uniform(225 MPa, 275 MPa)", "data sheet, 249 MPa, with a tenth to both sides"),
          "water.mobility": ("loguniform(2.6e-20 m2/(Pa s), 2.4e-18 m2/(Pa s))", "Springer et al. 1991, a factor of 3 and of 30 to the sides")},
    0.9: {"water.drag_number": ("uniform(0.6, 1.3)", "Springer et al. 1991; Park and Caton 2008; about 1 by Zawodzinski et al. 1995, from memory"),
          "materials.nafion_air.youngs_modulus": ("uniform(150 MPa, 249 MPa)", "between the data sheet's two"),
          "water.mobility": ("loguniform(2e-19 m2/(Pa s), 1.7e-17 m2/(Pa s))", "Springer et al. 1991, a factor of 3 and of 30 to the sides")},
}
TOUCH = {key: FORMS["H+"][key] for key in ("water.drag_number", "materials.nafion_wet.youngs_modulus", "water.drained_poissons_ratio",
                                           "water.mobility")}


def span(values):
    """Lowest, middle and highest."""
    return {"lowest": float(numpy.min(values)), "middle": float(numpy.median(values)), "highest": float(numpy.max(values))}


class Study:
    """`ionskin uncertainty` of one case: the metrics of every sample."""

    def __init__(self, program, folder, case, ranges, metric, edits, samples):
        options = [word for edit in edits for word in ("--set", edit)]
        options += [word for key, (text, _) in ranges.items() for word in ("--vary", f"{key}={text}")]
        process = subprocess.run([program, "uncertainty", CASES / f"{case}.toml", "-o", folder, "--quiet", "--metrics", metric,
                                  "--samples", str(samples), *options], check=False)
        if process.returncode not in (0, 3) or not (folder / "samples.csv").exists():  # 3: no polynomial holds the metric
            sys.exit(process.returncode)
        with open(folder / "samples.csv", newline="", encoding="utf-8") as file:
            titles, *rows = csv.reader(file)
        self.columns = {title.split(" [")[0]: [row[place] for row in rows] for place, title in enumerate(titles)}

    def metric(self, name):
        return numpy.array([float(cell) for cell in self.columns[name]])


def strip(program, work, ion, microns, humidity=None):
    """One bent strip."""
    air = humidity is not None
    ranges = COMMON | AIR[humidity] if air else FORMS[ion]
    # Once the water has settled, within the run, dilution alone is left.
    edits = [f"skin.layers[1].thickness={microns} um", f"strain.curvature={CURVATURE} 1/m", "strain.duration=1000 s",
             "readout.sample_interval=1 s", "numerics.error_estimate=off"]
    if air:
        edits += [f"skin.humidity={humidity}"]
    study = Study(program, work / f"{ion}{microns}{humidity}", "bent_strip_air" if air else "bent_strip", ranges,
                  "peak_voltage,peak_dilution_voltage", edits, SAMPLES)
    peak, steady = study.metric("peak_voltage") / CURVATURE, study.metric("peak_dilution_voltage") / CURVATURE
    return {"cation": ion, "kept": f"air of {100 * humidity:.0f} % humidity" if air else "in water", "thickness_um": microns,
            "peak_V_m": span(peak), "steady_V_m": span(steady),
            "ranges": {key: {"range": text, "source": source} for key, (text, source) in ranges.items()}}


def touch(program, work):
    """The soft finger."""
    study = Study(program, work / "touch", "finger_taxel", TOUCH, "peak_taxel_voltage", ["numerics.error_estimate=off"], SAMPLES)
    folder = work / "nominal"
    subprocess.run([program, "run", CASES / "finger_taxel.toml", "-o", folder, "--no-report", "--quiet"], check=True)
    error = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["error_estimate"]["peak_taxel_voltage"]
    return {"force_N": 1.0, "peak_V": span(study.metric("peak_taxel_voltage")), "relative_numerical_error": error,
            "ranges": {key: {"range": text, "source": source} for key, (text, source) in TOUCH.items()}}


def digest_of(content):
    """SHA-256 of the content without its digest."""
    rest = {key: value for key, value in content.items() if key != "sha256"}
    return hashlib.sha256(json.dumps(rest, sort_keys=True, separators=(",", ":")).encode()).hexdigest()


def predict(program, work):
    """The content of the file."""
    jobs = [(ion, microns) for ion in FORMS for microns in (100, 200)]
    jobs += [("H+", microns, humidity) for humidity in AIR for microns in (100, 200)]
    with ThreadPoolExecutor(3) as pool:
        pressed = pool.submit(touch, program, work)
        strips = list(pool.map(lambda job: strip(program, work, *job), jobs))
    version = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    return {"format": "ionskin-prediction", "version": 1, "date": datetime.date.today().isoformat(), "program": version,
            "cases": {name: hashlib.sha256((CASES / f"{name}.toml").read_bytes()).hexdigest() for name in ("bent_strip", "bent_strip_air", "finger_taxel")},
            "curvature_1_m": CURVATURE, "samples": SAMPLES, "strips": strips, "touch": pressed.result()}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path, nargs="?", help="the ionskin program")
    parser.add_argument("file", type=Path, help="file to write, or to check")
    parser.add_argument("--check", action="store_true", help="whether the file is as it was written")
    options = parser.parse_args()
    if options.check:
        content = json.loads(options.file.read_text(encoding="utf-8"))
        if digest_of(content) != content["sha256"]:
            sys.exit(f"{options.file}: changed since {content['date']}")
        return
    if options.program is None:
        parser.error("the ionskin program is missing")
    with tempfile.TemporaryDirectory() as work:
        content = predict(options.program.resolve(), Path(work))
    content["sha256"] = digest_of(content)
    options.file.write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
