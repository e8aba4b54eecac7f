#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Processor time of `ionskin check` on cases with long lists, of n and of 2 n entries.

    benchmarks/check_scaling.py build/ionskin

What grows in proportion to the list doubles at most, beside the constant time of the program."""

import argparse
import pathlib
import resource
import subprocess
import sys
import tempfile

QUICK = pathlib.Path(__file__).parent.parent / "cases" / "paper" / "coarse.toml"


def with_motion(text: str, motion: str) -> str:
    begin, end = text.index("[motion]"), text.index("[contact]")
    start = text.index("start = ")
    text = text[:begin] + motion + "\n" + text[end:]
    return text[:start] + text[text.index("\n", start) + 1:]


def waypoint(i: int, count: int) -> tuple[float, float, float, str]:
    at = 4.5 + 6 * i / count
    return 1e-3 * i, at, 1.0, "1 mm" if i in (0, count - 1) else "-1 um"


def instants(count, folder):
    times = ",".join(f'"{3.5 * i / count:.6g} s"' for i in range(count))
    text = QUICK.read_text()
    return text[:text.index("[output]")] + f"[output]\nfields = [{times}]\n", []


def waypoint_sections(count, folder):
    rows = "".join(f'[[motion.waypoints]]\ntime = "{t:.6g} s"\nposition = ["{x:.9g} mm", "{y} mm"]\nheight = "{h}"\n'
                   for t, x, y, h in (waypoint(i, count) for i in range(count)))
    return with_motion(QUICK.read_text(), f'[motion]\nkind = "waypoints"\n{rows}'), []


def waypoint_line(count, folder):
    rows = ",".join(f'{{time="{t:.6g} s",position=["{x:.9g} mm","{y} mm"],height="{h}"}}'
                    for t, x, y, h in (waypoint(i, count) for i in range(count)))
    return with_motion(QUICK.read_text(), f'[motion]\nkind = "waypoints"\nwaypoints = [{rows}]\n'), []


def waypoint_file(count, folder):
    lines = ["time [s], x [mm], y [mm], height [mm]"]
    for i in range(count):
        t, x, y, h = waypoint(i, count)
        lines.append(f"{t:.6g}, {x:.9g}, {y}, {1 if h == '1 mm' else -0.001}")
    (folder / "path.csv").write_text("\n".join(lines))
    return with_motion(QUICK.read_text(), '[motion]\nkind = "waypoints"\nfile = "path.csv"\n'), []


def bad_waypoint_file(count, folder):
    text = waypoint_file(count, folder)
    file = folder / "path.csv"
    file.write_text(file.read_text().replace("-0.001", "-3"))
    return text


def unknown_keys(count, folder):
    return "".join(f"unknown_{i} = 1\n" for i in range(count)) + QUICK.read_text(), []


def unknown_keys_of_section(count, folder):
    keys = "".join(f"frictoin_{i} = 1\n" for i in range(count))
    return QUICK.read_text().replace("[contact]\n", "[contact]\n" + keys), []


def unknown_sections(count, folder):
    return QUICK.read_text() + "".join(f"[sektion_{i}]\na = 1\n" for i in range(count)), []


def materials(count, folder):
    rows = "".join(f'[materials.m{i}]\nyoungs_modulus = "1 GPa"\npoissons_ratio = 0.3\n' for i in range(count))
    return QUICK.read_text() + "\n" + rows, []


def taxels(count, folder):
    rows = "".join(f'[[readout.taxels]]\nname = "t{i}"\nlower = ["{15 * i / count:.9g} mm", "0 mm"]\n'
                   f'upper = ["{15 * (i + 0.5) / count:.9g} mm", "1 mm"]\n' for i in range(count))
    return QUICK.read_text() + "\n" + rows, []


def bad_taxels(count, folder):
    text, edits = taxels(count, folder)
    return text.replace('"1 mm"]', '"9 mm"]'), edits


def edits(count, folder):
    return QUICK.read_text(), [f"contact.k{i}=1" for i in range(count)]


def edits_of_one_key(count, folder):
    return QUICK.read_text(), [f"contact.friction={0.1 + 1e-6 * i:.7g}" for i in range(count)]


def edits_of_materials(count, folder):
    return QUICK.read_text(), [f"materials.m{i}.poissons_ratio=0.3" for i in range(count)]


def height_map(count, folder):
    side = int(count**0.5)
    steps = [3 * i / (side - 1) - 1.5 for i in range(side)]
    rows = ["mm," + ",".join(f"{x:.9g}" for x in steps)]
    rows += [f"{0.5 * y:.9g}," + ",".join(f"{1e-3 * x**2:.9g}" for x in steps) for y in steps]
    (folder / "map.csv").write_text("\n".join(rows))
    return QUICK.read_text().replace('size = ["3 mm", "1.5 mm"]', 'shape = "profile"\nsize = ["3 mm", "1.5 mm"]\nprofile = "map.csv"'), []


LISTS = [(instants, 5000), (waypoint_sections, 4000), (waypoint_line, 3000), (waypoint_file, 25000),
         (bad_waypoint_file, 25000), (unknown_keys, 12000), (unknown_keys_of_section, 12000),
         (unknown_sections, 6000), (materials, 4000), (taxels, 1000), (bad_taxels, 1000), (edits, 2000),
         (edits_of_one_key, 2000), (edits_of_materials, 2000), (height_map, 100000)]


def cost(program, make, count):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        text, changes = make(count, folder)
        case = folder / "case.toml"
        case.write_text(text)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        command = [program, "check", str(case)] + [f"--set={change}" for change in changes]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        answer = (result.stdout + result.stderr).strip().splitlines()
        return seconds, result.returncode, answer[0] if answer else ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("names", nargs="*", help="lists; all without")
    options = parser.parse_args()
    print(f"{'list':26} {'n':>7} {'n [s]':>8} {'2n [s]':>8} {'ratio':>6}  exit, answer")
    for make, count in LISTS:
        if options.names and make.__name__ not in options.names:
            continue
        one, _, _ = cost(options.program, make, count)
        two, code, answer = cost(options.program, make, 2 * count)
        print(f"{make.__name__:26} {count:7} {one:8.3f} {two:8.3f} {two / one:6.2f}  {code}, {answer[:70]}", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
