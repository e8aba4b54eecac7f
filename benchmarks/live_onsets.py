#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Reduced skins where slip begins: a finger presses, rests and begins to slide, on a path and on the mirrored path, by the full
model and by a reduced skin that it trained. The table of docs/live-accuracy.md.

    benchmarks/live_onsets.py build [--preset standard] [--only WORD ...] [--keep FOLDER]

Four fingers, each under three laws of friction, with 4 x 4 taxels. Skins and runs in the folder to keep are taken as they are.
"""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy

ROOT = pathlib.Path(__file__).resolve().parents[1]
READOUT = 'sample_interval = "10 ms"\ntaxels = {rows = 4, columns = 4}'
SOFT = 'youngs_modulus = "1 MPa"\npoissons_ratio = 0.49'
FINGERS = {
    "rigid": 'shape = "sphere"\nradius = "8 mm"',
    "soft": f'shape = "sphere"\nradius = "8 mm"\n{SOFT}',
    "padded": f'shape = "sphere"\nradius = "8 mm"\n{SOFT}\npad_thickness = "3 mm"',
    "rounded": f'shape = "flat"\nsize = ["2 mm", "2 mm"]\nedge_radius = "0.5 mm"\n{SOFT}',
}
FRICTION = {
    "coulomb": "friction = 0.3",
    "regularised": 'law = "regularised"\nfriction = 0.3\nslip_length = "1 um"',
    "stribeck": 'law = "stribeck"\nfriction = 0.3\nkinetic_friction = 0.2\nstribeck_speed = "1 mm/s"',
}
TRAINED_FROM, START, ACROSS, LENGTH = 4.5e-3, 6e-3, 3e-3, 15e-3  # m
FORCE, SPEED = 0.6, 2e-3  # N, m/s
STEP = 1e-3  # s
PRESSED, SLIDES, LIFTS, OFF = 300, 600, 900, 1000  # the first step of each part
ONSET = slice(SLIDES, SLIDES + 100)  # steps
SAMPLE = 10  # steps in a sampled current


def case_text(preset: str, **sections: str) -> str:
    """Text of cases/finger.toml with other sections; the section of a motion of waypoints has no place where it starts."""
    text = (ROOT / "cases" / "finger.toml").read_text(encoding="utf-8").replace('preset = "standard"', f'preset = "{preset}"')
    text = text.replace('fields = ["0.5 s", "1.5 s"]', "fields = []").replace("[numerics]\n", '[numerics]\nerror_estimate = "off"\n')
    for name, lines in sections.items():
        text = re.sub(rf"^\[{name}\]\n(.+\n)*", f"[{name}]\n{lines}\n", text, flags=re.M)
    return text


def touch(mirrored: bool) -> dict:
    """Arguments of `Skin.run`: times, positions and forces."""
    steps = numpy.arange(1, OFF + 1)
    x = START + SPEED * STEP * numpy.clip(steps - SLIDES, 0, LIFTS - SLIDES)
    force = FORCE * numpy.interp(steps, [0, PRESSED, LIFTS, OFF], [0, 1, 1, 0])
    return {"times": STEP * steps, "positions": numpy.c_[LENGTH - x if mirrored else x, numpy.full(OFF, ACROSS)], "forces": force}


class Comparison:
    """One finger under one law of friction: the reduced skin and both full runs."""

    def __init__(self, arguments, finger: str, friction: str) -> None:
        self.arguments, self.name = arguments, f"{finger}_{friction}_{arguments.preset}"
        self.slider, self.contact = FINGERS[finger], FRICTION[friction]

    def program(self, *words) -> None:
        subprocess.run([self.arguments.build / "ionskin", *words, "--threads", str(self.arguments.threads), "--quiet"], check=True)

    def skin(self):
        """The trained skin."""
        from ionskin.live import Skin

        case, file = (self.arguments.keep / f"{self.name}{ending}" for ending in (".toml", ".live"))
        if not file.exists():
            slider = f'{self.slider}\nstart = ["{1e3 * TRAINED_FROM:g} mm", "{1e3 * ACROSS:g} mm"]'
            case.write_text(case_text(self.arguments.preset, slider=slider, contact=self.contact, readout=READOUT), encoding="utf-8")
            self.program("live", case, "--validation", str(self.arguments.validation), "-o", file)
        return Skin(file)

    def full(self, skin, mirrored: bool) -> numpy.ndarray:
        """Charge of the top electrode by the full model after each step [C]."""
        from ionskin import Results
        from ionskin.live import touch_path

        folder = self.arguments.keep / f"{self.name}_{'mirrored' if mirrored else 'path'}"
        if not (folder / "sampled.csv").exists():
            case, path = (folder.with_suffix(ending) for ending in (".toml", ".csv"))
            touch_path(touch(mirrored), skin).write(path, overwrite=True)
            motion = f'kind = "waypoints"\nfile = "{path.name}"'
            case.write_text(case_text(self.arguments.preset, slider=self.slider, contact=self.contact, motion=motion,
                                      readout=f'sample_interval = "{STEP:g} s"'), encoding="utf-8")
            self.program("run", case, "-o", folder, "--no-report", "--overwrite")
        sampled = Results(folder).sampled
        charge = STEP * numpy.cumsum(sampled["current_top"])
        return numpy.interp(touch(mirrored)["times"], sampled["time"], charge)


def onset(charge: numpy.ndarray, steps: int = 1) -> numpy.ndarray:
    """Currents of an onset [A]: means over so many steps."""
    taken = charge[ONSET.start - 1:ONSET.stop:steps]
    return numpy.diff(taken) / (steps * STEP)


def rms(values: numpy.ndarray) -> float:
    return float(numpy.sqrt(numpy.mean(numpy.square(values))))


def row(comparison: Comparison) -> list[str]:
    """Cells of the table."""
    skin = comparison.skin()
    full = [comparison.full(skin, mirrored) for mirrored in (False, True)]
    live = []
    for mirrored in (False, True):
        skin.reset()
        live.append(skin.run(**touch(mirrored))["charge_top"])
    stated = skin.event_errors["slip_onset"]
    charges = [each[ONSET] - each[ONSET.start - 1] for each in (full[0], live[0])]
    sampled = [onset(each, SAMPLE) for each in (full[0], live[0])]
    of_charge, of_sampled = rms(live[0][ONSET] - full[0][ONSET]), rms(sampled[1] - sampled[0])
    largest = numpy.abs(onset(full[0])).max()
    kept = of_charge <= stated["charge_top"].rms and of_sampled <= stated["sampled_current_top"].rms
    return [f"{1e9 * rms(onset(full[0])):.0f}", f"{1e9 * rms(onset(live[0]) - onset(full[0])):.0f}",
            f"{1e9 * rms(sampled[0]):.0f}", f"{1e9 * of_sampled:.1f}", f"{1e9 * stated['sampled_current_top'].rms:.1f}",
            f"{1e9 * rms(charges[0]):.2f}", f"{1e9 * of_charge:.2f}", f"{1e9 * stated['charge_top'].rms:.2f}",
            *(f"{numpy.abs(onset(pair[1]) - onset(pair[0])).max() / largest:.1g}" for pair in (full, live)), "yes" if kept else "no"]


COLUMNS = ("current, rms [nA]", "error of live, rms [nA]", "sampled current, rms [nA]", "error [nA]", "stated [nA]",
           "charge, rms [nC]", "error [nC]", "stated [nC]", "full, mirrored", "live, mirrored", "kept")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path, help="build folder")
    parser.add_argument("--preset", default="coarse", choices=["coarse", "standard", "fine"])
    parser.add_argument("--only", nargs="+", default=[""], help="only skins whose name holds one of these words")
    parser.add_argument("--validation", type=int, default=12, help="touches that tell the stated errors")
    parser.add_argument("--threads", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--keep", type=pathlib.Path, help="folder of the skins and runs; a temporary one without")
    arguments = parser.parse_args()
    arguments.build = arguments.build.resolve()
    sys.path.insert(0, str(arguments.build / "python"))
    with tempfile.TemporaryDirectory() as temporary:
        arguments.keep = arguments.keep or pathlib.Path(temporary)
        arguments.keep.mkdir(parents=True, exist_ok=True)
        print(f"the first {STEP * (ONSET.stop - ONSET.start):g} s of slip at {arguments.preset}, currents of {1e3 * STEP:g} ms and sampled "
              f"ones of {1e3 * SAMPLE * STEP:g} ms; mirrored: largest difference over the largest current\n")
        print("| finger | friction | " + " | ".join(COLUMNS) + " |\n" + "|---" * (len(COLUMNS) + 2) + "|", flush=True)
        for finger in FINGERS:
            for friction in FRICTION:
                comparison = Comparison(arguments, finger, friction)
                if any(word in comparison.name for word in arguments.only):
                    print("| " + " | ".join([finger, friction, *row(comparison)]) + " |", flush=True)


if __name__ == "__main__":
    main()
