# SPDX-License-Identifier: Apache-2.0
"""Cases within all allowed ranges, far from any real skin: contacts of micrometres, layers of very unlike stiffness, loads of
nanometres. Each ends, within the memory that it promised, with audits that say what it is worth."""

import json
import unittest

from program import ROOT, ProgramTest, summary

# Layers from below as (Young's modulus [Pa], Poisson's ratio, thickness).
CASES = {
    "barely pressed sphere": {
        "layers": [(1.2469e10, 0.4426, "736.9 um"), (3.8103e11, 0.499, "40.93 um"), (3.4661e9, 0.499, "105.8 um")],
        "slider": 'shape = "sphere"\nradius = "2.951 mm"', "width": 2, "preload": "18.01 nm", "friction": 2,
        "ions": ("8.716e-12 m2/s", "0.001466 F/m"), "coupling": ("volume-neutral", 1, "off-diagonal")},
    "deeply pressed rounded edges": {
        "layers": [(1.0848e9, 0.47976, "21.88 um"), (3.5709e11, 0.499, "32.36 um"), (2.8324e7, 0.499, "292.6 um")],
        "slider": 'shape = "flat"\nedge_radius = "0.05336 mm"', "width": 6, "preload": "68.81 um", "friction": 0.8522,
        "ions": ("1.518e-10 m2/s", "0.003454 F/m"), "coupling": ("column-neutral", 0.1, "deviatoric")},
    "cylinder on a stiff plate over a soft one": {
        "layers": [(1.2041e6, 0.062516, "99.33 um"), (1.5893e10, 0.499, "463.1 um"), (3.9618e9, 0.499, "89 um")],
        "slider": 'shape = "cylinder"\nradius = "5.144 mm"', "width": 6, "preload": "0.04424 N", "friction": 0,
        "ions": ("1.928e-12 m2/s", "0.003422 F/m"), "coupling": ("pair-generation", 1, "deviatoric")},
    "rounded edges without friction": {
        "layers": [(1.0182e6, 0.28074, "214.7 um"), (3.8125e10, 0.13738, "315.1 um"), (3.9272e10, 0.49719, "36.4 um")],
        "slider": 'shape = "flat"\nedge_radius = "0.1866 mm"', "width": 2, "preload": "0.001397 N", "friction": 0,
        "ions": ("1.237e-11 m2/s", "0.001218 F/m"), "coupling": ("volume-neutral", 1, "signed-xz")},
    "rounded edges pressed by a fifth of a nanometre": {
        "layers": [(6.3942e10, 0.49688, "939.4 um"), (4.216e11, 0.499, "234.7 um"), (9.9766e6, 0.45066, "162.1 um")],
        "slider": 'shape = "flat"\nedge_radius = "0.04633 mm"', "width": 6, "preload": "0.2094 nm", "friction": 2,
        "ions": ("3.461e-11 m2/s", "0.0005597 F/m"), "coupling": ("volume-neutral", 0.1, "deviatoric")},
    "sphere on a thick stiff electrode": {
        "layers": [(1.2759e8, 0.29124, "24.45 um"), (2.2705e5, 0.019007, "21.43 um"), (1.8406e10, 0.47574, "802.6 um")],
        "slider": 'shape = "sphere"\nradius = "44.87 mm"', "width": 6, "preload": "0.01554 N", "friction": 0,
        "ions": ("1.035e-12 m2/s", "0.000114 F/m"), "coupling": ("fixed-charge", 0.01, "off-diagonal")},
    "incompressible fingertip": {
        "layers": [(1.68e11, 0.38, "10 um"), (2.49e8, 0.49, "180 um"), (1.68e11, 0.38, "10 um")],
        "slider": 'shape = "sphere"\nradius = "8 mm"\nyoungs_modulus = "0.3 MPa"', "width": 6, "preload": "0.1 N", "friction": 0.3,
        "ions": ("7e-11 m2/s", "0.002 F/m"), "coupling": ("column-neutral", 0.1, "off-diagonal")},
    "incompressible film on a bone": {
        "layers": [(1.68e11, 0.38, "10 um"), (2.49e8, 0.49, "180 um"), (1.68e11, 0.38, "10 um")],
        "slider": 'shape = "sphere"\nradius = "8 mm"\nyoungs_modulus = "0.3 MPa"\npad_thickness = "0.2 mm"', "width": 6,
        "preload": "0.1 N", "friction": 0.3, "ions": ("7e-11 m2/s", "0.002 F/m"),
        "coupling": ("column-neutral", 0.1, "off-diagonal")},
}


def case_text(layers, slider, width, preload, friction, ions, coupling):
    """The TOML text of one case."""
    names, roles = ("bottom", "core", "top"), ("electrode", "core", "electrode")
    text = f'[skin]\nlength = "15 mm"\nwidth = "{width} mm"\n'
    for name, role, (_, _, thickness) in zip(names, roles, layers):
        text += f'[[skin.layers]]\nname = "{name}"\nrole = "{role}"\nmaterial = "{name}"\nthickness = "{thickness}"\n'
    for name, (modulus, ratio, _) in zip(names, layers):
        text += f'[materials.{name}]\nyoungs_modulus = "{modulus} Pa"\npoissons_ratio = {ratio}\n'
    law, coefficient, measure = coupling
    return text + f"""
[slider]
{slider}
size = ["3 mm", "1.5 mm"]
start = ["4.5 mm", "{width / 2} mm"]
[motion]
gap = "1 mm"
preload = "{preload}"
stroke = "6 mm"
touchdown = "0.5 s"
slide = "2 s"
lift = "0.5 s"
return = "1 s"
[contact]
friction = {friction}
[electrochemistry]
temperature = "20 degC"
diffusivity = "{ions[0]}"
permittivity = "{ions[1]}"
fixed_charge_concentration = "1200 mol/m3"
[coupling]
law = "{law}"
coefficient = {coefficient}
measure = "{measure}"
[numerics]
preset = "coarse"
mesh_refinement = 0.3
"""


class ExtremeCases(ProgramTest):
    def solved(self, name, *options):
        """summary.json of a case, after a look at its memory."""
        case = self.write("case.toml", case_text(**CASES[name]))
        promised = json.loads(self.run_program("check", case, "--json").stdout)["explanation"]
        self.run_case(case, "--quiet", *options, "-o", "out")
        manifest = json.loads((self.folder / "out" / "manifest.json").read_text(encoding="utf-8"))
        value, unit = next(line.split()[1:3] for line in promised.splitlines() if line.startswith("  memory "))
        used = max(stage["peak_memory_bytes"] for stage in manifest["stages"].values())
        self.assertLess(used, 2 * float(value) * {"GB": 1e9, "MB": 1e6}[unit], name)
        return summary(self.folder / "out")

    def test_check_refuses_a_contact_at_the_edge_of_the_skin_as_run_does(self):
        finger = ROOT / "cases" / "finger.toml"
        words = "reaches the edge of the skin along y: it needs more than the "

        def narrow(width, *edits):
            place = (f"skin.width={width} mm", f'slider.start=["4.5 mm", "{width / 2} mm"]', "numerics.preset=coarse")
            return [word for edit in (*place, *edits) for word in ("--set", edit)]

        self.run_program("check", finger)
        self.run_program("check", finger, *narrow(1))
        # The pull of the adhesion widens a contact, and so does a slider that gives.
        for edits in (narrow(0.3),
                      narrow(1, "contact.law=adhesive", "contact.work_of_adhesion=2 J/m2", "contact.cohesive_strength=0.3 MPa"),
                      narrow(1, "slider.youngs_modulus=5 MPa", "slider.poissons_ratio=0.4")):
            self.assertIn(words, self.run_program("check", finger, *edits, expect=2).stderr)
            self.assertIn(words, self.run_program("run", finger, *edits, "-o", "out", "--overwrite", expect=2).stderr)

    def test_each_passes_or_names_what_it_is_not_worth(self):
        for name in CASES:
            with self.subTest(name):
                found = self.solved(name, "--overwrite", "--set", "numerics.error_estimate=off")
                for audit, state in found["audits"].items():
                    if state["verdict"] != "passed":
                        self.assertEqual(state["verdict"], "warned", audit)
                        self.assertTrue(any(audit in text for text in found["warnings"]), audit)
                self.assertLess(found["audits"]["equilibrium_residual"]["value"], 2e-3)
                self.assertLess(found["audits"]["complementarity_residual"]["value"], 2e-3)

    def test_platinum_on_a_soft_gel(self):
        """Few cells at the edges of the slider bear the load on the stiff metal, and barely slip."""
        for modulus, force, friction in (("300 kPa", 0.5, 0.2), ("30 kPa", 0.02, 0.3)):
            with self.subTest(modulus):
                edits = (f"materials.nafion.youngs_modulus={modulus}", f"motion.preload={force} N", f"contact.friction={friction}",
                         "numerics.error_estimate=off")
                self.run_case(ROOT / "cases" / "quick.toml", *(word for edit in edits for word in ("--set", edit)), "--only",
                              "mechanics", "-o", "out", "--overwrite", "--quiet")
                metrics = summary(self.folder / "out")["metrics"]
                self.assertAlmostEqual(metrics["normal_force_slide"]["value"] / force, 1, 6)
                self.assertAlmostEqual(metrics["tangential_force_slide"]["value"] / (friction * force), 1, 6)

    def test_errors_above_the_value_are_reported(self):
        found = self.solved("rounded edges without friction")
        beyond = [name for name, error in found["error_estimate"].items()
                  if error > 1 and name not in found["not_converging"]]
        self.assertTrue(beyond)
        self.assertTrue(any("The stated error exceeds 20 % for" in text and "over 1000 %" in text for text in found["warnings"]))


if __name__ == "__main__":
    unittest.main()
