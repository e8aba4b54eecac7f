#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Accuracy and speed of reduced skins: trains one for each of a list of cases, compares it with the full model on
touches that it has not seen, and times its steps. The tables of docs/live-accuracy.md.

    benchmarks/live_table.py build [--preset coarse] [--refinement 1] [--only WORD ...] [--touches 100] [--keep FOLDER]

Two cases, each under three coupling laws and four laws of friction, with 4 x 4 taxels; the paper's touch on a wet skin; and
the finger over an area of 2 x 0.8 mm. Needs the programs `ionskin` and
the targets `live` and `live_accuracy` of the build folder. Skins and tables in the folder to keep are taken as they are.
"""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
TAXELS = "readout.taxels={rows = 4, columns = 4}"
FRICTION = {
    "coulomb": [],
    "regularised": ["contact.law=regularised", "contact.slip_length=0.1 um"],
    "stribeck": ["contact.law=stribeck", "contact.kinetic_friction=0.2", "contact.stribeck_speed=1 mm/s"],
    "anisotropic": ["contact.law=anisotropic", "contact.transverse_friction=0.15"],
}
# Case, coupling law, law of friction.
SKINS = [(case, coupling, friction)
         for case, own, others in (("paper", "fixed-charge", ("column-neutral", "pair-generation")),
                                   ("finger", "column-neutral", ("fixed-charge", "volume-neutral")))
         for coupling, friction in ((own, "coulomb"), *((other, "coulomb") for other in others), (own, "regularised"),
                                    (own, "stribeck"), (own, "anisotropic"))]
SKINS += [("poroelastic", "poroelastic", "coulomb"), ("area", "column-neutral", "coulomb")]
# Signals of the table, by what live_accuracy calls them.
COLUMNS = {"taxel charge": "charge_top_taxels", "charge": "charge_top", "sampled current": "sampled_current_top",
           "sampled difference": "sampled_current_difference", "taxel current": "sampled_current_top_taxels",
           "normal force": "normal_force", "tangential force": "tangential_force", "contact area": "contact_area"}


def case_file(keep, case):
    """The file of a case; that of the finger over an area is written."""
    if case != "area":
        return ROOT / "cases" / f"{case}.toml"
    finger = (ROOT / "cases" / "finger.toml").read_text(encoding="utf-8").replace('start = ["4.5 mm", "3 mm"]\n', "")
    motion = '[motion]\nkind = "waypoints"\n' + "".join(
        f'[[motion.waypoints]]\ntime = "{time} s"\nposition = ["{x} mm", "{y} mm"]\n{load}\n'
        for time, x, y, load in ((0, 4.5, 2.6, 'height = "0.1 mm"'), (0.5, 4.5, 2.6, 'force = "1 N"'),
                                 (1.5, 6.5, 3.4, 'force = "1 N"'), (2, 6.5, 3.4, 'height = "0.1 mm"')))
    path = keep / "area.toml"
    path.write_text(finger[:finger.index("[motion]")] + motion + "\n" + finger[finger.index("[contact]"):], encoding="utf-8")
    return path


def output(keep, name, command):
    """Output of a command, taken from the folder when it is there."""
    kept = keep / name
    if not kept.exists():
        ran = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
        kept.with_suffix(".part").write_text(ran.stdout, encoding="utf-8")
        kept.with_suffix(".part").rename(kept)
    return kept.read_text(encoding="utf-8")


def train(arguments, case, coupling, friction):
    """The file of a skin."""
    size = arguments.preset if arguments.refinement == 1 else f"{arguments.preset}_{arguments.refinement:g}"
    skin = arguments.keep / f"{case}_{coupling}_{friction}_{size}.live"
    if not skin.exists():
        settings = [TAXELS, f"numerics.preset={arguments.preset}", f"numerics.mesh_refinement={arguments.refinement:g}",
                    f"coupling.law={coupling}", *FRICTION[friction]]
        subprocess.run([arguments.build / "ionskin", "live", case_file(arguments.keep, case),
                        *(part for setting in settings for part in ("--set", setting)), "--validation",
                        str(arguments.validation), "--threads", str(arguments.threads), "--quiet", "-o", skin], check=True)
    return skin


def row(arguments, skin):
    """Cells of a skin: rms and worst of each signal, in per cent of its largest value, and the least share of touches
    that keep a stated error."""
    table = output(arguments.keep, f"{skin.stem}.accuracy",
                   [arguments.build / "benchmarks" / "live_accuracy", skin, "--touches", str(arguments.touches), "--threads",
                    str(arguments.threads)])
    errors = {name: [float(value) for value in values.replace("%", "").split()]
              for name, values in re.findall(r"^(\w+) +([\d. %-]+)$", table, re.M)}
    cells = ["{0[0]:.2g}, {0[1]:.2g}".format(errors[signal]) if signal in errors else "" for signal in COLUMNS.values()]
    return [*cells, "{:.0f} %".format(min(min(values[4:6]) for values in errors.values()))]


def speed(arguments, skin):
    """Lines that tell the latency of a skin."""
    return output(arguments.keep, f"{skin.stem}.latency",
                  [arguments.build / "benchmarks" / "live", skin]).splitlines()[:4]


def main():
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path, help="build folder")
    parser.add_argument("--preset", default="coarse", choices=["coarse", "standard", "fine"])
    parser.add_argument("--refinement", type=float, default=1, help="mesh refinement; 0.5 takes a sixth of the time")
    parser.add_argument("--no-latency", action="store_true", help="time no steps")
    parser.add_argument("--only", nargs="+", default=[""], help="only skins whose name holds one of these words")
    parser.add_argument("--touches", type=int, default=100, help="unseen touches that each skin is compared on")
    parser.add_argument("--validation", type=int, default=90, help="touches that tell the stated errors")
    parser.add_argument("--threads", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--keep", type=pathlib.Path, help="folder of the skins; a temporary one without")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        arguments.keep = arguments.keep or pathlib.Path(temporary)
        arguments.keep.mkdir(parents=True, exist_ok=True)
        latencies = []
        print(f"rms and worst over {arguments.touches} unseen touches at {arguments.preset}, mesh refinement "
              f"{arguments.refinement:g}, in % of the largest value; and the least share of touches that keep a stated error\n")
        print("| case | coupling | friction | " + " | ".join(COLUMNS) + " | keep |")
        print("|---" * (len(COLUMNS) + 4) + "|")
        for case, coupling, friction in SKINS:
            if any(word in f"{case}_{coupling}_{friction}" for word in arguments.only):
                skin = train(arguments, case, coupling, friction)
                print("| " + " | ".join([case, coupling, friction, *row(arguments, skin)]) + " |")
                sys.stdout.flush()
                if not arguments.no_latency:
                    latencies.append((skin.stem, speed(arguments, skin)))
        for name, lines in latencies:
            print("\n" + "\n".join([name, *lines]))


if __name__ == "__main__":
    main()
