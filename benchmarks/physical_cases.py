# SPDX-License-Identifier: Apache-2.0
"""Random cases whose every key lies in a physical range, at the preset coarse; which keys there are is the schema's to say."""

import json
import math
import random

import small_cases

# Keys that no case here has, and why.
NOT_DRAWN = {
    "title": "says nothing",
    "strain.file": "needs a file of a run; tests/program/test_strain_file.py",
    "numerics.shared_positions.from": "has no effect any more",
    "numerics.shared_positions.to": "has no effect any more",
    "numerics.shared_positions.footprint": "has no effect any more",
}
SHAPES = ("flat", "rounded", "sphere", "cylinder", "profile")
LAWS = ("coulomb", "saturating", "regularised", "viscous", "stribeck", "anisotropic", "adhesive")
COUPLINGS = ("fixed-charge", "column-neutral", "pair-generation", "volume-neutral", "poroelastic")


def toml(table, name=""):
    """Text of a table: plain values first, then tables and arrays of tables."""
    text = "".join(f"{key} = {json.dumps(value)}\n" for key, value in table.items()
                   if not isinstance(value, dict) and not (isinstance(value, list) and value and isinstance(value[0], dict)))
    for key, value in table.items():
        inner = f"{name}.{key}" if name else key
        if isinstance(value, dict):
            text += f"[{inner}]\n{toml(value, inner)}"
        elif isinstance(value, list) and value and isinstance(value[0], dict):
            text += "".join(f"[[{inner}]]\n{toml(row, inner)}" for row in value)
    return text


def keys_of(table, name=""):
    """Keys of a case as `ionskin keys` writes them."""
    for key, value in table.items():
        inner = f"{name}.{key}" if name else key
        if name == "materials":
            inner = "materials.NAME"
        if isinstance(value, dict):
            yield from keys_of(value, inner)
        elif isinstance(value, list) and value and isinstance(value[0], dict):
            for row in value:
                yield from keys_of(row, f"{inner}[]")
        else:
            yield inner


class Draw:
    """One case by its number."""

    def __init__(self, number):
        self.rng = random.Random(f"physical {number}")
        self.number = number
        self.case, self.files = {}, {}
        self.poroelastic = self.maybe(0.2)
        self.prescribed = self.poroelastic and self.maybe(0.3)
        self.skin()
        if self.prescribed:
            self.load()
        else:
            self.contact()
        self.ions()
        self.readout()
        self.numerics()
        self.case["readout"]["instrument"] = self.rng.choice(("ad8605", "opa140", "ideal"))  # last: each number keeps its case

    def maybe(self, probability):
        """True so often."""
        return self.rng.random() < probability

    def between(self, low, high):
        """A number whose logarithm is uniform."""
        return float(f"{math.exp(self.rng.uniform(math.log(low), math.log(high))):.4g}")

    def quantity(self, low, high, unit):
        """A quantity drawn between two bounds, as text with its unit."""
        return f"{self.between(low, high):.4g} {unit}"

    def skin(self):
        """Layers and materials."""
        self.length, self.width = round(self.rng.uniform(4, 10), 2), round(self.rng.uniform(1.2, 4), 2)
        metal, polymer = "gold", "nafion"
        if self.maybe(0.7):
            metal, polymer = "metal", "polymer"
            self.case["materials"] = {
                "metal": {"youngs_modulus": self.quantity(5, 200, "GPa"), "poissons_ratio": self.between(0.2, 0.45)},
                "polymer": {"youngs_modulus": self.quantity(30, 1500, "MPa"), "poissons_ratio": self.between(0.35, 0.495)},
            }
        thickness = self.quantity(2, 20, "um")
        layers = [("bottom", "electrode", metal, thickness), ("core", "core", polymer, self.quantity(60, 300, "um")),
                  ("top", "electrode", metal, thickness)]
        if self.maybe(0.15):
            layers.append(("cover", "electrode", "platinum", self.quantity(1, 10, "um")))
        self.case["skin"] = {
            "length": f"{self.length} mm", "width": f"{self.width} mm", "sides": "symmetry" if self.maybe(0.2) else "free",
            "layers": [dict(zip(("name", "role", "material", "thickness"), layer)) for layer in layers],
        }

    def contact(self):
        """Slider, motion and friction."""
        shape = self.rng.choice(SHAPES)
        size = [round(self.rng.uniform(0.6, min(3, self.length / 4)), 2), round(self.rng.uniform(0.5, self.width / 2), 2)]
        plan = [f"{side} mm" for side in size]
        slider = {"shape": "flat" if shape == "rounded" else shape}
        if shape != "sphere":
            slider["size"] = plan
        if shape == "rounded":
            slider["edge_radius"] = self.quantity(0.05, 0.2, "mm")
        if shape in ("sphere", "cylinder"):
            slider["radius"] = self.quantity(2, 12, "mm")
        if shape == "profile":
            slider["profile"] = "profile.csv"
            self.files["profile.csv"] = self.ridges(size)
        if self.case["skin"]["sides"] == "free" and self.maybe(0.25):
            slider["youngs_modulus"] = self.quantity(1, 3000, "MPa")
            slider["poissons_ratio"] = self.between(0.3, 0.5)
            if self.maybe(0.5):
                slider["pad_thickness"] = self.quantity(0.3, 5, "mm")
        if self.case["skin"]["sides"] == "free" and self.maybe(0.25):
            slider |= self.angles()
        self.case["slider"] = slider
        self.case["contact"] = self.friction()
        round_below = shape in ("sphere", "cylinder", "profile")
        self.case["motion"] = self.motion(size, self.maybe(0.5), self.between(0.05, 3 if round_below else 1))
        drives = self.case["contact"]["law"] == "adhesive"
        if not drives and self.maybe(0.2):
            drives = True
            self.case["motion"]["drive"] = {"stiffness": self.quantity(1e3, 1e5, "N/m"), "damping": self.quantity(0.5, 20, "N s/m"),
                                            "mass": "0 g" if self.maybe(0.2) else self.quantity(0.3, 20, "g")}

        waypoints = self.case["motion"].get("waypoints", [])
        if not drives and waypoints and self.case["skin"]["sides"] == "free" and self.maybe(0.3):
            for waypoint in waypoints:
                waypoint |= self.angles()

    def angles(self):
        """Roll, pitch and yaw by which the slider stays within the room that it has."""
        return {"roll": self.angle(0.3), "pitch": self.angle(0.3), "yaw": self.angle(3)}

    def angle(self, most):
        return f"{self.rng.uniform(-most, most):.3f} deg"

    def ridges(self, size):
        """Text of the file of some ridges along y [mm]."""
        count = self.rng.randint(2, 4)
        return small_cases.height_map([size[0] * (i / 40 - 0.5) for i in range(41)], [size[1] * (i / 16 - 0.5) for i in range(17)],
                                      lambda x, y: 0.001 * (1 - math.cos(2 * math.pi * x / (size[0] / count))) / 2)

    def friction(self):
        """Keys of [contact]."""
        law, friction = self.rng.choice(LAWS), self.between(0.05, 0.8)
        own = {
            "coulomb": {},
            "saturating": {"strength": self.quantity(1e5, 1e7, "Pa"), "sharpness": self.between(1, 10)},
            "regularised": {"slip_length": self.quantity(0.03, 100, "um")},
            "viscous": {"reference_speed": self.quantity(20, 500, "mm/s")},
            "stribeck": {"kinetic_friction": round(friction * self.rng.uniform(0.3, 1), 4),
                         "stribeck_speed": self.quantity(0.5, 20, "mm/s"), "lag_time": self.quantity(1, 20, "ms")},
            "anisotropic": {"transverse_friction": self.between(0.05, 0.8)},
            "adhesive": {"work_of_adhesion": self.quantity(0.01, 2, "J/m2"), "cohesive_strength": self.quantity(0.1, 5, "MPa")},
        }[law]
        return {"law": law, "friction": friction, **own}

    def motion(self, size, by_force, load):
        """Keys of [motion], and of [slider] where it starts; a load in N or um."""
        room = [self.length / 2 - size[0] / 2 - 0.5, self.width / 2 - size[1] / 2 - 0.2]
        oblique = room[1] > 0.2 and self.case["skin"]["sides"] == "free" and self.maybe(0.3)
        direction = [1, 0] if not oblique else [round(self.rng.uniform(-1, 1), 3), round(self.rng.uniform(0.1, 1), 3)]
        norm = math.hypot(*direction)
        unit = [part / norm for part in direction]
        longest = min(2 * room[i] / abs(unit[i]) for i in (0, 1) if abs(unit[i]) > 1e-9)
        stroke = longest * self.rng.uniform(0.02, 0.5)
        start = [self.length / 2 - unit[0] * stroke / 2, self.width / 2 - unit[1] * stroke / 2]
        kind = self.rng.choice(("touch-slide-lift", "reciprocating", "waypoints"))
        if kind == "waypoints":
            return self.waypoints(start, unit, stroke, by_force, load)
        self.case["slider"]["start"] = [f"{part:.4f} mm" for part in start]
        motion = {"kind": kind, "gap": self.quantity(0.01, 1, "mm"), "preload": f"{load} {'N' if by_force else 'um'}",
                  "stroke": f"{stroke:.4f} mm", "direction": direction}
        for leg, most in (("touchdown", 1), ("slide", 2), ("lift", 1), ("return", 1)):
            motion[leg] = self.quantity(0.1, most, "s")
        if kind == "reciprocating":
            motion |= {"strokes": self.rng.randint(2, 4), "dwell": self.quantity(0.01, 0.3, "s")}
        return motion | {"cycles": self.rng.choice((1, 1, 2))}

    def waypoints(self, start, unit, stroke, by_force, load):
        """Rows in the case or in a file: presses, rests, turns and lift-offs."""
        level = "force" if by_force else "height"
        rows, time, way = [(0.0, 0.0, "height", 0.1)], 0.5, 0.0
        for _ in range(self.rng.randint(3, 12)):
            if self.maybe(0.1):
                rows.append((time, way, "height", 0.1))
            else:
                value = load * self.rng.uniform(0.1, 1)
                rows.append((time, way, level, value if by_force else -value / 1000))
            if self.maybe(0.8):
                way = stroke * self.rng.random()
            time += self.rng.uniform(0.02, 0.3)
        rows.append((time, way, "height", 0.1))
        places = [(t, start[0] + unit[0] * w, start[1] + unit[1] * w, kind, value) for t, w, kind, value in rows]
        if self.maybe(0.5):
            text = "time [s], x [mm], y [mm], height [mm], force [N]\n"
            for t, x, y, kind, value in places:
                text += f"{t:.4f},{x:.5f},{y:.5f},{f'{value:.7f},' if kind == 'height' else f',{value:.5f}'}\n"
            self.files["path.csv"] = text
            return {"kind": "waypoints", "file": "path.csv"}
        return {"kind": "waypoints", "waypoints": [
            {"time": f"{t:.4f} s", "position": [f"{x:.5f} mm", f"{y:.5f} mm"],
             kind: f"{value:.7f} {'mm' if kind == 'height' else 'N'}"} for t, x, y, kind, value in places]}

    def load(self):
        """A prescribed load in the place of a contact."""
        strain = {"source": "prescribed", "duration": self.quantity(0.5, 5, "s")}
        kind = self.rng.choice(("pressure", "compression", "curvature"))
        strain[kind] = {"pressure": self.quantity(1e3, 1e6, "Pa"), "compression": self.quantity(0.001, 0.1, "um"),
                        "curvature": self.quantity(0.1, 20, "1/m")}[kind]
        strain["waveform"] = self.rng.choice(("step", "ramp", "sine"))
        if strain["waveform"] == "ramp":
            strain["rise"] = self.quantity(0.01, 0.4, "s")
        if strain["waveform"] == "sine":
            strain["frequency"] = self.quantity(1, 10, "Hz")
        self.case["strain"] = strain

    def ions(self):
        """Electrochemistry, coupling and water; constants of the ionomer stand with its material at times."""
        concentration = self.between(100, 3000)
        ions = {"temperature": f"{self.rng.uniform(0, 80):.1f} degC", "diffusivity": self.quantity(1e-12, 2e-9, "m2/s"),
                "permittivity": self.quantity(7e-10, 1e-2, "F/m"), "fixed_charge_concentration": f"{concentration} mol/m3",
                "valence": self.rng.choice((1, 1, 2))}
        water = {"drag_number": self.between(0.5, 5), "volume_fraction": self.between(0.1, 0.6)}
        if "materials" in self.case and self.maybe(0.3):
            polymer = self.case["materials"]["polymer"]
            polymer |= {key: ions.pop(key) for key in ("diffusivity", "fixed_charge_concentration", "valence")}
            polymer |= {key: water.pop(key) for key in list(water) if self.poroelastic}
            if self.poroelastic and self.maybe(0.5):
                polymer["mobility"] = self.quantity(1e-17, 1e-14, "m2/(Pa s)")
            if self.maybe(0.5):
                self.over_humidity(polymer)
        model = self.rng.choice(("dilute", "dilute", "steric", "thin-layers") if self.poroelastic else ("dilute", "dilute", "steric"))
        ions["ion_model"] = model
        if model == "steric":
            ions["largest_concentration"] = f"{concentration * self.between(2.5, 20):.1f} mol/m3"
        self.case["electrochemistry"] = ions
        if self.poroelastic:
            self.case["coupling"] = {"law": "poroelastic"}
            self.case["water"] = water | self.water()
            outside = any(key.endswith("_pressure") for key in self.case["water"])
            if self.prescribed and "materials" in self.case and not outside and "compression" not in self.case["strain"] and self.maybe(0.5):
                self.relaxation(self.case["materials"]["polymer"])
            return
        self.case["coupling"] = {"law": self.rng.choice(COUPLINGS[:-1]),
                                 "coefficient": self.rng.choice((1, -1)) * self.between(0.01, 1),
                                 "measure": self.rng.choice(("off-diagonal", "deviatoric", "signed-xz"))}
        if self.case["coupling"]["law"] != "fixed-charge" and self.maybe(0.2):
            ions["permittivity"] = self.quantity(1e-10, 1e-9, "F/m")
            place = self.case["materials"]["polymer"] if "materials" in self.case and self.maybe(0.3) else ions
            place["interface_capacitance"] = self.quantity(10, 200, "F/m2")

    def relaxation(self, material):
        """A Prony series of its shear modulus."""
        count = self.rng.randint(1, 3)
        material["relaxation_times"] = [f"{self.between(low, 10 * low):.4g} s" for low in (1e-3, 0.1, 10)[:count]]
        material["relaxation_shares"] = [self.between(0.01, 0.3) for _ in range(count)]

    def over_humidity(self, material):
        """Gives a material its modulus and diffusivity as lists over the humidity, one of which is the skin's."""
        material["humidity"] = sorted({round(self.rng.uniform(0.05, 1), 3) for _ in range(5)})
        for key in ("youngs_modulus", "diffusivity"):
            number, unit = material[key].split(" ", 1)
            material[key] = [f"{float(number) * self.between(0.8, 1.2):.4g} {unit}" for _ in material["humidity"]]
        self.case["skin"]["humidity"] = round(self.rng.uniform(material["humidity"][0], material["humidity"][-1]), 4)

    def water(self):
        """Keys of [water] beside those of the material."""
        water = {"dilution": self.rng.choice(("mixture", "pore-water"))}
        for side in ("bottom", "top"):
            wall = water[f"{side}_wall"] = self.rng.choice(("sealed", "open", "permeable"))
            if wall == "permeable":
                water[f"{side}_conductance"] = self.quantity(1e-15, 1e-11, "m/(Pa s)")
            if wall != "sealed" and "compression" not in self.case.get("strain", {}) and self.maybe(0.3):
                water[f"{side}_pressure"] = self.quantity(10, 10000, "Pa")
        if self.maybe(0.5):
            water["drained_poissons_ratio"] = self.between(0.1, 0.3)
        else:
            water["drained_modulus"] = self.quantity(50, 500, "MPa")
        if "mobility" in self.case.get("materials", {}).get("polymer", {}) and self.maybe(0.5):
            return water
        way = self.rng.choice(("permeability", "mobility", "consolidation_coefficient"))
        water[way] = {"permeability": self.quantity(1e-20, 1e-17, "m2"), "mobility": self.quantity(1e-17, 1e-14, "m2/(Pa s)"),
                      "consolidation_coefficient": self.quantity(1e-11, 1e-8, "m2/s")}[way]
        if way == "permeability":
            water["viscosity"] = self.quantity(0.3, 2, "mPa s")
        return water

    def readout(self):
        """Circuit, sampling and taxels."""
        circuit = self.rng.choice(("short", "short", "open", "load", "parallel-rc", "amplifier"))
        readout = {"sample_interval": self.quantity(2, 50, "ms"), "circuit": circuit}
        if circuit in ("load", "parallel-rc"):
            readout["load_resistance"] = self.quantity(10, 1e7, "ohm")
        if circuit == "parallel-rc":
            readout["load_capacitance"] = self.quantity(1e-11, 1e-6, "F")
        if circuit == "amplifier":
            readout |= {"amplifier_bandwidth": self.quantity(50, 5000, "Hz"), "noise_seed": self.rng.randint(1, 1000),
                        "amplifier_noise_density": self.quantity(1e-15, 1e-12, "A/sqrt(Hz)"),
                        "amplifier_range": self.quantity(1e-6, 1e-3, "A")}
        if self.maybe(0.3):
            readout |= {"instrument_voltage_noise": self.quantity(1e-9, 1e-7, "V/sqrt(Hz)"), "instrument_bits": self.rng.randint(8, 24),
                        "instrument_current_noise": self.quantity(1e-16, 1e-12, "A/sqrt(Hz)")}
        if not self.prescribed and self.maybe(0.3):
            readout["taxels"] = {"rows": self.rng.randint(1, 2), "columns": self.rng.randint(2, 4), "gap": self.quantity(0.05, 0.2, "mm")}
        elif not self.prescribed and self.maybe(0.2):
            readout["taxels"] = [{"name": name, "lower": [f"{low * self.length:.3f} mm", "0 mm"],
                                  "upper": [f"{high * self.length:.3f} mm", f"{self.width} mm"]}
                                 for name, low, high in (("left", 0, 0.4), ("right", 0.5, 1))]
        if "taxels" in readout and circuit != "amplifier" and self.case["electrochemistry"]["ion_model"] != "thin-layers" and self.maybe(0.5):
            self.taxel_circuits(readout)
        if "taxels" not in readout and self.case["electrochemistry"]["ion_model"] != "thin-layers" and self.maybe(0.3):
            readout["contact"] = self.rng.choice(("everywhere", "one end", "both ends", "corner"))
            for layer in self.case["skin"]["layers"]:
                if layer["role"] == "electrode" and self.maybe(0.8):
                    layer["sheet_resistance"] = self.quantity(0.01, 100, "ohm")
        self.case["readout"] = readout

    def taxel_circuits(self, readout):
        """Taxels as conductors of their own, some with other circuits than the rest, some scanned."""
        readout["taxel_circuit"] = self.rng.choice(("short", "open", "load", "parallel-rc"))
        if isinstance(readout["taxels"], list):
            readout["taxels"][0] |= self.rng.choice((
                {"circuit": "parallel-rc", "load_resistance": self.quantity(10, 1e7, "ohm"), "load_capacitance": self.quantity(1e-11, 1e-6, "F")},
                {"circuit": "amplifier", "amplifier_bandwidth": self.quantity(50, 5000, "Hz"), "noise_seed": self.rng.randint(1, 1000),
                 "amplifier_noise_density": self.quantity(1e-15, 1e-12, "A/sqrt(Hz)"), "amplifier_range": self.quantity(1e-6, 1e-3, "A")},
                {"circuit": "shared"}))
        elif self.maybe(0.4):
            self.crossbar(readout)
        if self.maybe(0.3):
            readout["scan"] = {"dwell": self.quantity(20, 200, "ms"), "others": self.rng.choice(("grounded", "open"))}

    def crossbar(self, readout):
        """Lines that cross in the place of taxels with leads of their own; a line of either face is at the ground."""
        readout["taxels"].pop("gap")
        readout["taxels"]["wiring"] = self.rng.choice(("single", "crossbar", "crossbar"))
        if readout["taxels"]["wiring"] == "crossbar":
            readout["row_circuit"] = "short" if readout["taxel_circuit"] != "short" else self.rng.choice(("short", "open", "load"))

    def numerics(self):
        """Coarse and quick; errors for some."""
        self.case["numerics"] = {"preset": "coarse", "mesh_refinement": self.rng.choice((0.4, 0.5)),
                                 "time_refinement": self.rng.choice((0.5, 1)), "time_tolerance": self.rng.choice((0, 0, 1e-3)),
                                 "error_estimate": "on" if self.maybe(0.1) else "off"}
        fields = self.maybe(0.3) and self.case["electrochemistry"]["ion_model"] != "thin-layers"  # which have none
        self.case["output"] = {"fields": [f"{self.rng.uniform(0.1, 0.4):.3f} s"] if fields else []}

    def name(self):
        """Name that says what is special about the case, in words."""
        if self.prescribed:
            said = f"prescribed {self.case['strain']['waveform']}"
        else:
            motion = self.case["motion"]
            said = ", ".join((self.case["slider"]["shape"], motion["kind"], self.case["contact"]["law"]))
            said += ", drive" if "drive" in motion else ""
            said += ", soft" if "youngs_modulus" in self.case["slider"] else ""
        said += f", {self.case['coupling']['law']}, {self.case['electrochemistry']['ion_model']}"
        return f"{said}, {self.case['readout']['circuit']}"


def undrawn_keys(schema, cases=400):
    """Keys of the schema that neither one of so many cases has nor NOT_DRAWN names."""
    drawn = {key for number in range(cases) for key in keys_of(Draw(number).case)}
    return sorted({row["key"] for row in schema} - drawn - set(NOT_DRAWN))
