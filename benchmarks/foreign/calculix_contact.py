#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Touch and slide in CalculiX: C3D20R elements, face-to-face penalty contact with linear pressure-overclosure and friction
as its manual describes them (Dhondt, CalculiX CrunchiX user's manual 2.20, "Face-to-Face Penalty Contact"), SPOOLES.

    calculix_contact.py SIZE_MM CORE_ELEMENTS

Writes its input into the folder where it runs, and prints one JSON object."""

import json
import re
import subprocess
import sys

import numpy
import skin

CORNERS = ((0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2))
MIDDLES = ((1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2),
           (0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1))
STIFFNESS = 1e7  # [MPa/mm] of the penalty: under the mean pressure the sphere sinks in by 4e-4 of the indentation
STICKING = 1e6  # [MPa/mm] until friction slips: after 2e-6 mm, a ten-thousandth of a step
NODES_A_LINE = 16  # of the input file


class Bricks:
    """Numbered nodes and 20-node bricks of a tensor mesh; `lift` moves the nodes of the lowest level."""

    def __init__(self, lines, first, lift=None):
        half = [numpy.sort(numpy.concatenate([line, (line[1:] + line[:-1]) / 2])) for line in lines]
        self.lines, self.shape = lines, [len(line) - 1 for line in lines]
        numbers, self.nodes, self.elements = {}, {}, {}
        for k in range(self.shape[2]):
            for j in range(self.shape[1]):
                for i in range(self.shape[0]):
                    nodes = []
                    for offset in CORNERS + MIDDLES:
                        place = tuple(2 * index + part for index, part in zip((i, j, k), offset))
                        if place not in numbers:
                            numbers[place] = first + len(numbers)
                            x, y, z = (line[index] for line, index in zip(half, place))
                            self.nodes[numbers[place]] = (x, y, z + lift(x, y) if lift and place[2] == 0 else z)
                        nodes.append(numbers[place])
                    self.elements[first + len(self.elements)] = (nodes, (i, j, k))


def sphere(x, y):
    """Height of its underside; near its lowest point a sphere is this paraboloid to 1e-4 of the indentation."""
    return ((x - skin.START)**2 + (y - skin.WIDTH / 2)**2) / (2 * skin.RADIUS)


def listing(keyword, numbers):
    numbers = list(numbers)
    return [keyword] + [", ".join(map(str, numbers[at:at + NODES_A_LINE])) for at in range(0, len(numbers), NODES_A_LINE)]


def bricks(name, chosen):
    lines = [f"*ELEMENT, TYPE=C3D20R, ELSET={name}"]
    for number, nodes in chosen:
        lines += [f"{number}, " + ", ".join(map(str, nodes[:15])) + ",", ", ".join(map(str, nodes[15:]))]
    return lines


def node_lines(name, nodes):
    return [f"*NODE, NSET={name}"] + [f"{number}, {x:.10g}, {y:.10g}, {z:.10g}" for number, (x, y, z) in nodes.items()]


def material(name, elements, constants):
    return [f"*MATERIAL, NAME={name}", "*ELASTIC", f"{constants[0]}, {constants[1]}",
            f"*SOLID SECTION, ELSET={elements}, MATERIAL={name}"]


def motion(increments, moves):
    """One step: it holds to what it had and moves the slider evenly; reactions and strains at its end."""
    lines = ["*STEP, INC=1000", "*STATIC", f"{1 / increments}, 1., 1e-5, {1 / increments}", "*BOUNDARY"]
    return lines + [f"SLIDER, {axis}, {axis}, {value}" for axis, value in moves] + [
        "*NODE PRINT, NSET=HELD, TOTALS=ONLY, FREQUENCY=1000", "RF",
        "*EL PRINT, ELSET=NAFION, FREQUENCY=1000", "E", "*END STEP"]


def write(name, body, indenter):
    x, y, _ = body.lines
    top = body.shape[2] - 1
    core = {number: nodes for number, (nodes, place) in body.elements.items() if 0 < place[2] < top}
    metal = {number: nodes for number, (nodes, place) in body.elements.items() if place[2] in (0, top)}
    touched = [number for number, (_, (i, j, k)) in body.elements.items()
               if k == top and y[j] > skin.WIDTH / 2 - skin.REACH - 1e-9
               and x[i] > skin.START - skin.REACH - 1e-9 and x[i + 1] < skin.START + skin.SLIDE + skin.REACH + 1e-9]
    lines = node_lines("SKIN", body.nodes) + node_lines("SLIDER", indenter.nodes)
    lines += bricks("NAFION", core.items()) + bricks("PLATINUM", metal.items())
    lines += bricks("INDENTER", ((number, nodes) for number, (nodes, _) in indenter.elements.items()))
    lines += listing("*NSET, NSET=HELD", (n for n, place in body.nodes.items() if place[2] == 0))
    lines += listing("*NSET, NSET=MIDDLE", (n for n, place in body.nodes.items() if place[1] == skin.WIDTH / 2))
    lines += material("PT", "PLATINUM", skin.PLATINUM) + material("NAF", "NAFION", skin.NAFION)
    lines += ["*SOLID SECTION, ELSET=INDENTER, MATERIAL=PT"]
    lines += listing("*ELSET, ELSET=TOUCHED", touched) + ["*SURFACE, NAME=TOP, TYPE=ELEMENT", "TOUCHED, S2"]
    lines += ["*SURFACE, NAME=UNDERSIDE, TYPE=ELEMENT"] + [f"{n}, S1" for n in indenter.elements]
    lines += ["*CONTACT PAIR, INTERACTION=RUB, TYPE=SURFACE TO SURFACE", "TOP, UNDERSIDE",
              "*SURFACE INTERACTION, NAME=RUB", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", f"{STIFFNESS:g}",
              "*FRICTION", f"{skin.FRICTION}, {STICKING:g}"]
    lines += ["*BOUNDARY", "HELD, 1, 3, 0.", "MIDDLE, 2, 2, 0.", "SLIDER, 1, 3, 0."]
    lines += motion(skin.TOUCH_STEPS, ((1, 0.0), (2, 0.0), (3, -skin.INDENTATION)))
    lines += motion(skin.STEPS, ((1, skin.SLIDE), (2, 0.0), (3, -skin.INDENTATION)))
    with open(f"{name}.inp", "w", encoding="ascii") as file:
        file.write("\n".join(lines) + "\n")


def read(name, body):
    """Forces and mean shear at the end of both steps, of the whole skin."""
    x, y, z = body.lines
    volume = {number: (x[i + 1] - x[i]) * (y[j + 1] - y[j]) * (z[k + 1] - z[k])
              for number, (_, (i, j, k)) in body.elements.items()}
    states, table = [], None
    with open(f"{name}.dat", encoding="ascii") as file:
        for line in file:
            words = line.split()
            if "total force" in line:
                states.append({"shear": 0.0, "volume": 0.0})
                table = "force"
            elif "strains" in line:
                table = "shear"
            elif words and table == "force":
                force = [2 * float(word) for word in words]
                states[-1].update(normal_force=force[2], tangential_force=-force[0])
            elif words and table == "shear":
                weight = volume[int(words[0])]  # the 8 points of C3D20R weigh alike
                states[-1]["shear"] += weight * 2 * numpy.sqrt(sum(float(word)**2 for word in words[5:8]))
                states[-1]["volume"] += weight
    return [{"normal_force": state["normal_force"], "tangential_force": state["tangential_force"],
             "mean_shear": state["shear"] / state["volume"]} for state in states]


def main(size, core_elements):
    body = Bricks(skin.mesh_lines(size, core_elements), 1)
    reach = skin.REACH + size
    x = numpy.linspace(skin.START - reach, skin.START + reach, 17)
    y = numpy.linspace(skin.WIDTH / 2 - reach, skin.WIDTH / 2 + size, 9)
    indenter = Bricks((x, y, numpy.array([skin.HEIGHT, skin.HEIGHT + 0.1])), 10**6, sphere)
    write("touch", body, indenter)
    with open("touch.log", "w", encoding="utf-8") as log:
        done = subprocess.run(["ccx", "touch"], stdout=log, stderr=log, check=False)
    with open("touch.log", encoding="utf-8", errors="replace") as log:
        text = log.read()
    if done.returncode or "*ERROR" in text:
        sys.exit("CalculiX gave up; the end of its output:\n" + text[-600:])
    touch, slide = read("touch", body)
    unknowns = int(re.search(r"number of equations\s+(\d+)", text).group(1))
    iterations = len(re.findall(r"^ iteration\s+\d+", text, re.M))
    print(json.dumps({"unknowns": unknowns, "iterations": iterations, "touch": touch, "slide": slide}))


if __name__ == "__main__":
    main(float(sys.argv[1]), int(sys.argv[2]))
