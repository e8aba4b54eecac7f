# SPDX-License-Identifier: Apache-2.0
"""Parts of the small cases that several benchmarks run: layers, ions, laws of friction, and undersides as height maps."""


def layers(electrode=10, core=180):
    """Layers between two electrodes, thicknesses in um."""
    return "".join(f'[[skin.layers]]\nname = "{name}"\nrole = "{role}"\nmaterial = "{material}"\nthickness = "{thickness:.4g} um"\n'
                   for name, role, material, thickness in (("bottom electrode", "electrode", "platinum", electrode),
                                                           ("ionomer", "core", "nafion", core),
                                                           ("top electrode", "electrode", "platinum", electrode)))


def skin(length, width, electrode=10, core=180):
    """A skin and its ions, length and width in mm, thicknesses in um."""
    return f"""
[skin]
length = "{length:.4g} mm"
width = "{width:.4g} mm"
{layers(electrode, core)}
[electrochemistry]
temperature = "20 degC"
diffusivity = "7e-11 m2/s"
permittivity = "2e-3 F/m"
fixed_charge_concentration = "1200 mol/m3"
"""


# Keys of [contact] by law; what follows a comma tells two settings of one law apart.
FRICTION_LAWS = {
    "coulomb": "",
    "saturating": 'strength = "500 kPa"',
    "regularised": 'slip_length = "1 um"',
    "regularised, 0.1 um": 'slip_length = "0.1 um"',
    "viscous": 'reference_speed = "50 mm/s"',
    "stribeck": 'kinetic_friction = 0.25\nstribeck_speed = "10 mm/s"',
    "stribeck, strong": 'kinetic_friction = 0.1\nstribeck_speed = "1 mm/s"',
    "anisotropic": "transverse_friction = 0.1",
    "adhesive": 'work_of_adhesion = "1 J/m2"\ncohesive_strength = "1 MPa"',
}


def friction(law):
    """Keys of [contact] that name a law and its parameters."""
    return f'law = "{law.split(",")[0]}"\n{FRICTION_LAWS[law]}\n'


def height_map(xs, ys, height):
    """Text of a file of heights [mm] over x and y [mm]."""
    text = "mm," + ",".join(f"{x:.4f}" for x in xs) + "\n"
    return text + "".join(f"{y:.4f}," + ",".join(f"{height(x, y):.7f}" for x in xs) + "\n" for y in ys)
