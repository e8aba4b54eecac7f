#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Comparison of stated errors with true ones: runs cases at a preset and at the next finer one and compares what the
first states with how far the second is from it. The table of docs/errors-of-results.md.

    benchmarks/error_coverage.py build/ionskin [--presets coarse standard] [--cases WORD ...] [--keep FOLDER] [--least SHARE]
                                 [--most-ratio RATIO] [--most-marked SHARE]

Twelve cases: both coupling families, four sliders, three motions, force and height, short and open circuit. The preset
fine is compared with itself refined by `--refine-fine` (1.3). Finished runs in the folder to keep
are taken as they are, so that the finer preset need not be run again. Standard against fine takes minutes
a case, although the sliders are of a millimetre. The finer value is itself uncertain, so that a ratio near 1 says little.
"""

import argparse
import json
import math
import pathlib
import statistics
import subprocess
import sys
import tempfile

import small_cases

# Keys of the slider, width of the skin [mm], load as a height and as a force.
SLIDERS = {
    "flat": ('size = ["1 mm", "0.6 mm"]', 1, "1 um", "2.5 N"),
    "rounded": ('size = ["1 mm", "0.6 mm"]\nedge_radius = "0.1 mm"', 1, "1 um", "2.5 N"),
    "sphere": ('shape = "sphere"\nradius = "2 mm"', 1, "4 um", "0.5 N"),
    "cylinder": ('shape = "cylinder"\nradius = "2 mm"\nsize = ["1 mm", "0.6 mm"]', 1, "2 um", "1 N"),
}

STROKES = """gap = "0.1 mm"
preload = "{load}"
touchdown = "0.5 s"
lift = "0.5 s"
return = "1 s"
"""
MOTIONS = {
    "slide": STROKES + 'stroke = "2 mm"\nslide = "1 s"\n',
    "reciprocating": STROKES + 'kind = "reciprocating"\nstrokes = 2\ndwell = "0.2 s"\nstroke = "1 mm"\nslide = "0.5 s"\n',
    "waypoints": 'kind = "waypoints"\n' + "".join(
        f'[[motion.waypoints]]\ntime = "{time} s"\nposition = ["{x} mm", "{{middle}} mm"]\n{level}\n'
        for time, x, level in ((0, 2, 'height = "0.1 mm"'), (0.5, 2, "{level}"), (1, 3.25, "{level}"),
                               (1.5, 4, "{level}"), (2, 4, 'height = "0.1 mm"'))),
}

CASES = [
    ("flat", "slide", "height", "fixed-charge", "short"),
    ("flat", "slide", "force", "column-neutral", "open"),
    ("flat", "reciprocating", "height", "pair-generation", "short"),
    ("flat", "waypoints", "force", "fixed-charge", "open"),
    ("rounded", "slide", "height", "column-neutral", "short"),
    ("rounded", "reciprocating", "force", "fixed-charge", "short"),
    ("rounded", "waypoints", "height", "volume-neutral", "open"),
    ("sphere", "slide", "force", "column-neutral", "short"),
    ("sphere", "reciprocating", "height", "fixed-charge", "open"),
    ("sphere", "waypoints", "force", "pair-generation", "short"),
    ("cylinder", "slide", "height", "fixed-charge", "short"),
    ("cylinder", "reciprocating", "force", "column-neutral", "open"),
]

FINER = {"coarse": "standard", "standard": "fine", "fine": "fine"}

# A metric belongs to the first family of which its name holds a part.
FAMILIES = {
    "largest values": ("element_max", "membrane_stress"),
    "resolved peak currents": ("peak_current",),
    "sampled peak currents": ("peak_sampled",),
    "rms currents": ("rms_current", "tail_current"),
    "charges and voltages": ("charge", "voltage", "amplifier"),
    "forces and works": ("force", "work"),
    "first moments": ("first_moment",),
    "percentiles of shear": ("p95", "p99", "nonlinearity"),
    "mean shear": ("mean_shear",),
    "contact": ("contact_area", "mean_pressure", "stick"),
    "ions": ("concentration", "potential"),
}


def case_text(slider, motion, control, law, circuit):
    """The TOML text of one case."""
    shape, width, height, force = SLIDERS[slider]
    load = height if control == "height" else force
    places = {"middle": width / 2, "load": load}
    if motion == "waypoints":
        places["level"] = f'height = "-{load}"' if control == "height" else f'force = "{load}"'
    start = "" if motion == "waypoints" else f'start = ["2 mm", "{width / 2} mm"]\n'
    return (small_cases.skin(length=6, width=width) + f"\n[contact]\nfriction = 0.3\n[slider]\n{shape}\n{start}\n[motion]\n"
            + MOTIONS[motion].format(**places) + f'\n[coupling]\nlaw = "{law}"\ncoefficient = 0.1\n'
            + f'\n[readout]\ncircuit = "{circuit}"\n')


def solve(program, name, text, preset, refinement, keep, states=True):
    """summary.json of a case, run unless the folder to keep holds it; without coarser solutions where it states no errors."""
    folder = keep / f"{name}_{preset}" if refinement == 1 else keep / f"{name}_{preset}_{refinement:g}"
    summary = folder / "summary.json"
    if not summary.exists() or (states and not json.loads(summary.read_text(encoding="utf-8")).get("error_estimate")):
        case = keep / f"{name}.toml"
        case.write_text(text, encoding="utf-8")
        subprocess.run([program, "run", case, "-o", folder, "--no-report", "--quiet", "--overwrite", "--set",
                        f"numerics.preset={preset}", "--set", f"numerics.mesh_refinement={refinement}",
                        *([] if states else ["--set", "numerics.error_estimate=off"])], check=True)
    return json.loads(summary.read_text(encoding="utf-8"))


def family(metric):
    """The family that a metric belongs to."""
    return next((name for name, parts in FAMILIES.items() if any(part in metric for part in parts)), "others")


def compare(stating, finer):
    """Rows of metric, stated and true relative error; and the names that state none."""
    rows, marked = [], []
    for name, error in stating["error_estimate"].items():
        value, other = stating["metrics"][name]["value"], finer["metrics"].get(name, {}).get("value")
        if name in stating["not_converging"]:
            marked.append(name)
        elif value and other is not None:
            rows.append((name, error, abs(other / value - 1)))
    return rows, marked


def covered_share(pairs, slack):
    """Share of true errors that the stated ones cover. What is below the resolution of a double sum is met by any
    error."""
    return sum(true <= stated + slack for stated, true in pairs) / len(pairs)


def shortcomings(rows, marked, arguments, slack=1e-9):
    """Complaints about the errors of a preset, by what is asked of them."""
    if not rows:
        yield "no stated error was compared"
        return
    share = covered_share([row[1:] for row in rows], slack)
    if share < arguments.least:
        yield f"{share:.1%} of the stated errors hold, less than {arguments.least:.0%}"
    ratio = statistics.median(stated / max(true, slack) for _, stated, true in rows)
    if ratio > arguments.most_ratio:
        yield f"the stated errors are {ratio:.1f} times the true ones in the median, more than {arguments.most_ratio:g}"
    if marked > arguments.most_marked * (marked + len(rows)):
        yield f"{marked} of {marked + len(rows)} metrics are marked as not converging, more than {arguments.most_marked:.0%}"


def table(rows, slack):
    """Lines: covered share and median ratio by family and over all."""
    lines = [f"{'family':26}{'errors':>8}{'covered':>9}{'median ratio':>14}"]
    for name in [*FAMILIES, "others", "all"]:
        chosen = [(stated, true) for metric, stated, true in rows if name in ("all", family(metric))]
        if chosen:
            covered = covered_share(chosen, slack)
            ratio = statistics.median(stated / max(true, slack) for stated, true in chosen)
            lines.append(f"{name:26}{len(chosen):8}{covered:9.1%}{ratio:14.1f}")
    return lines


def main():
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="build/ionskin")
    parser.add_argument("--presets", nargs="+", default=["coarse"], choices=list(FINER), help="presets that state errors")
    parser.add_argument("--cases", nargs="+", default=[""], help="only cases whose name holds one of these words")
    parser.add_argument("--keep", type=pathlib.Path, help="folder of the runs; a temporary one without")
    parser.add_argument("--refine-fine", type=float, default=1.3, help="mesh refinement that judges the preset fine")
    parser.add_argument("--misses", action="store_true", help="name every error that does not hold")
    parser.add_argument("--least", type=float, default=0, help="share of the errors that must hold; else this ends with 1")
    parser.add_argument("--most-ratio", type=float, default=math.inf, metavar="RATIO",
                        help="median of stated over true error that must not be exceeded, for errors that are too large always hold")
    parser.add_argument("--most-marked", type=float, default=1, metavar="SHARE",
                        help="share of the metrics that may be marked as not converging, which are not compared")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        keep = arguments.keep or pathlib.Path(temporary)
        keep.mkdir(parents=True, exist_ok=True)
        names = {"_".join(case): case for case in CASES}
        for preset in arguments.presets:
            rows, marked, solved = [], 0, 0
            for name, case in names.items():
                if not any(word in name for word in arguments.cases):
                    continue
                text = case_text(*case)
                refinement = arguments.refine_fine if preset == "fine" else 1
                stating = solve(arguments.program, name, text, preset, 1, keep)
                finer = solve(arguments.program, name, text, FINER[preset], refinement, keep,
                              FINER[preset] != preset and FINER[preset] in arguments.presets)
                compared, not_converging = compare(stating, finer)
                rows += compared
                marked += len(not_converging)
                solved += 1
                for metric, stated, true in compared:
                    if arguments.misses and true > stated + 1e-9:
                        print(f"  {name}: {metric} states {stated:.2%}, true {true:.2%}")
            print(f"{preset} against {FINER[preset]}: {solved} cases; {marked} metrics are marked as not converging")
            print("\n".join(table(rows, 1e-9)))
            if lacks := [*shortcomings(rows, marked, arguments)]:
                sys.exit("\n".join(lacks))


if __name__ == "__main__":
    main()
