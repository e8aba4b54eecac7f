# SPDX-License-Identifier: Apache-2.0
"""The problems of skin.py and cycle.py as cases of ionskin."""

import csv
from pathlib import Path

import h5py
import numpy
import small_cases

from . import cycle, skin

# Preset and numerics.mesh_refinement, from coarse to fine.
SETTINGS = {"contact": [("coarse", "1"), ("standard", "1")],
            "transport": [("coarse", "1"), ("standard", "1"), ("fine", "1")]}
FINE = {"transport": ("fine", "3")}


def case(part, setting):
    """Text of the case file."""
    length, width = (skin.LENGTH, skin.WIDTH) if part == "contact" else (cycle.LENGTH * 1e3, cycle.WIDTH * 1e3)
    text = f"""
title = "Beside other codes"
[skin]
length = "{length} mm"
width = "{width} mm"
{small_cases.layers()}[electrochemistry]
temperature = "{cycle.TEMPERATURE} K"
diffusivity = "{cycle.DIFFUSIVITY} m2/s"
permittivity = "{cycle.PERMITTIVITY} F/m"
fixed_charge_concentration = "{cycle.CONCENTRATION} mol/m3"
[coupling]
coefficient = {cycle.COUPLING}
[numerics]
preset = "{setting[0]}"
mesh_refinement = {setting[1]}
"""
    if part == "transport":
        return text + '[strain]\nsource = "file"\nfile = "strain.h5"\n'
    for name, (young, poisson) in {"platinum": skin.PLATINUM, "nafion": skin.NAFION}.items():
        text += f'[materials.{name}]\nyoungs_modulus = "{young} MPa"\npoissons_ratio = {poisson}\n'
    return text + f"""
[slider]
shape = "sphere"
radius = "{skin.RADIUS} mm"
size = ["{skin.WIDTH} mm", "{skin.WIDTH} mm"]
[contact]
friction = {skin.FRICTION}
[motion]
kind = "waypoints"
file = "path.csv"
"""


def path():
    """Waypoints: down, ten steps, up."""
    y, down = skin.WIDTH / 2, -skin.INDENTATION * 1e3
    rows = [f"0,{skin.START},{y},0.1", f"0.1,{skin.START},{y},{down}"]
    rows += [f"{0.1 + 0.01 * step:g},{skin.START + skin.STEP * step:g},{y},{down}" for step in range(1, skin.STEPS + 1)]
    rows.append(f"0.3,{skin.START + skin.SLIDE:g},{y},0.1")
    return "time [s], x [mm], y [mm], height [um]\n" + "\n".join(rows) + "\n"


def strain_file(name):
    """The history of cycle.py, in the format of docs/readouts.md."""
    x, y, shear = cycle.cells()
    height = numpy.array([0.0, cycle.CORE])
    with h5py.File(name, "w") as file:
        file.attrs.update(format="ionskin-strain", version=1, measure="off-diagonal", frame="skin")
        file["grid/x"], file["grid/y"], file["grid/z"], file["time"] = x, y, height, cycle.TIMES
        file["gamma"] = shear[:, None] * cycle.through(height / cycle.CORE)[:, None, None]
        file["gamma"].attrs["unit"] = "1"


def prepare(program, part, setting, folder):
    """Writes the input into `folder`; the command that runs it there, with nothing cached."""
    folder = Path(folder)
    (folder / "case.toml").write_text(case(part, setting), encoding="utf-8")
    if part == "contact":
        (folder / "path.csv").write_text(path(), encoding="utf-8")
    else:
        strain_file(folder / "strain.h5")
    command = [program, "run", "case.toml", "-o", "out", "--threads", "1",
               "--no-report", "--quiet"]
    return command + (["--only", "mechanics"] if part == "contact" else [])


def read(part, folder):
    """Figures of a run."""
    with open(Path(folder) / "out" / "signals.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    if part == "transport":
        times = [float(row["time [s]"]) for row in rows]
        charges = [(float(row["charge_top [C]"]) - float(row["charge_bottom [C]"])) / 2 for row in rows]
        return cycle.figures(times, charges)
    at = {time: min(rows, key=lambda row: abs(float(row["time [s]"]) - time)) for time in (0.1, 0.2)}
    names = {"normal_force": "normal_force [N]", "tangential_force": "tangential_force [N]", "mean_shear": "mean_shear [1]"}
    return flat({phase: {name: float(at[time][column]) for name, column in names.items()}
                 for phase, time in (("touch", 0.1), ("slide", 0.2))})


def flat(answer):
    """The figures that are compared, by name."""
    if "cycle" in answer:
        return answer["cycle"]
    return {"normal force": answer["touch"]["normal_force"], "shear of the touch": answer["touch"]["mean_shear"],
            "friction force": answer["slide"]["tangential_force"], "shear of the slide": answer["slide"]["mean_shear"]}
