# SPDX-License-Identifier: Apache-2.0
"""Names of metrics and columns in words, and a glossary of these words."""

import re

NAMES = {
    "normal_force": "Normal force", "tangential_force": "Tangential force", "mean_shear": "Mean shear", "p99_shear": "Shear, 99th percentile",
    "p95_shear": "Shear, 95th percentile", "shear_first_moment": "First moment of the shear", "element_max_shear": "Largest shear of an element",
    "contact_area": "Contact area", "mean_pressure": "Mean pressure",
    "peak_pressure": "Peak contact pressure", "stick_fraction": "Stuck part of the contact",
    "peak_mean_shear": "Peak mean shear", "time_mean_shear": "Mean shear, mean over time", "rms_mean_shear": "Mean shear, rms",
    "tail_current_difference": "Difference current between the events", "external_work": "Work of the slider",
    "friction_work": "Work of friction", "energy_balance_error": "Error of the energy balance",
    "energy_creation_error": "Energy created from nothing", "micro_slip_time": "First micro-slip after",
    "micro_slip_force_ratio": "Tangential force at the first micro-slip, of full slip", "full_slip_time": "Full slip after",
    "slip_lead_time": "Time from micro-slip to full slip", "slip_lead_travel": "Way from micro-slip to full slip",
    "electrode_membrane_stress": "Membrane stress of the electrode", "precursor_noise_floor": "Noise floor of a reading",
    "sample_noise": "Noise of a reading", "sample_noise_thermal": "Thermal noise of a reading",
    "sample_noise_amplifier": "Amplifier noise of a reading", "sample_noise_quantisation": "Steps of the converter, rms",
    "signal_to_noise": "Peak reading over its noise",
    "nonlinearity": "Strength of the nonlinearity", "min_concentration_ratio": "Least concentration, of the initial one",
    "max_potential": "Largest potential in the core", "peak_voltage": "Peak voltage", "peak_amplifier_current": "Peak reading of the amplifier",
    "amplifier_clipped_time": "Time at the amplifier's limit", "charge_identity_error": "Error of the charge identity",
    "equilibrium_residual": "Residual of equilibrium", "complementarity_residual": "Residual of contact",
    "interpolation_error": "Error of the interpolated compliance", "peak_open_circuit_voltage": "Peak open-circuit voltage",
    "open_circuit_voltage_per_newton": "Open-circuit voltage per force", "peak_sampled_taxel_current": "Peak sampled current of a taxel",
    "peak_metal_drop": "Largest difference in potential along the metal",
    "peak_taxel_voltage": "Peak voltage of a taxel", "taxel_crosstalk": "Crosstalk between taxels",
    "taxel_balance_error": "Error of the sum of the taxels", "adhesion_loss": "Work lost to adhesion", "pull_off_force": "Pull-off force", "slider_strain": "Strain of the slider",
    "charge_difference_end": "Difference charge at the end",
    "charge_difference_slide_end": "Difference charge at the end of the slide",
    "largest_p99_shear": "Largest shear, 99th percentile", "peak_dilution_voltage": "Peak voltage by dilution",
    "peak_streaming_voltage": "Peak voltage by streaming", "peak_drive": "Peak drive of the water on the cations",
    "peak_pore_pressure": "Peak water pressure", "peak_pressure_difference": "Peak water pressure, top minus bottom",
    "pressure_asymmetry": "Asymmetry of the water pressure", "rms_voltage": "Rms of the voltage", "streaming_share": "Part of the voltage by streaming",
}
COLUMNS = {
    "slider_x": "Slider, x", "slider_y": "Slider, y", "slider_z": "Height of the slider", "tangential_force_x": "Tangential force, x",
    "tangential_force_y": "Tangential force, y", "rms_shear": "Shear, rms", "moment_x": "Moment, about x",
    "moment_y": "Moment, about y", "moment_z": "Moment, about z", "mean_shear_rate": "Rate of the mean shear",
    "stick_share": "Stuck part of the contact", "slip": "Way slipped since landing", "slip_state": "State of slip", "drive_x": "End of the drive, x",
    "drive_y": "End of the drive, y", "drive_force_x": "Force of the drive, x", "drive_force_y": "Force of the drive, y",
    "charge_top": "Charge, top", "charge_bottom": "Charge, bottom",
}
INSTANTS = {"touchdown": "end of touchdown", "slide": "mid-slide"}
SIDES = {"top": "current, top", "bottom": "current, bottom", "difference": "difference current", "common": "common current"}
KINDS = {"peak": "Peak resolved", "rms": "Rms of the resolved", "peak_sampled": "Peak sampled"}
CURRENT = re.compile(r"(peak|rms|peak_sampled)_current_(top|bottom|difference|common)")
OF_SLIDER = re.compile(r"(.*[a-z])_([2-9])")  # of several, but for the first
SHARES = ("stick_fraction", "micro_slip_force_ratio", "min_concentration_ratio", "streaming_share", "taxel_crosstalk")
PRECURSORS = {"correlation": "Correlation of the {} current with the stuck share", "current": "Change of the {} current before full slip",
              "lead_time": "The {} current shows slip this long before full slip",
              "signal_to_noise": "Change of the {} current before full slip, over the noise"}

# Words of the glossary that a page explains: identifier, what of a metric's name asks for it, heading, meaning.
GLOSSARY = [
    ("difference", "difference", "Difference current", "(top − bottom) / 2: what flows from one electrode to the other through a wire between "
     "them, and what an ammeter in that wire shows."),
    ("common", "common", "Common current", "(top + bottom) / 2: what flows into both electrodes at once, from the ground. It needs a net charge in "
     "the core; an ammeter between the electrodes does not see it."),
    ("sampled", "sampled", "Sampled current", "What an instrument shows that integrates over readout.sample_interval: the charge gained over an "
     "interval divided by it, known at the interval's end."),
    ("electrode", "current_top|current_bottom|charge_top|charge_bottom", "Top and bottom current", "The current into each electrode, which is the "
     "rate of its charge. A positive one carries positive charge into it."),
    ("resolved", "peak_current", "Resolved current", "That of the solver's own time steps, with spikes as short as the events that make them."),
    ("rms", "^rms", "Rms", "Root mean square over the whole run, weighted by time. That of a resolved current counts its spikes of microseconds, "
     "and so may be larger than the peak of the sampled one."),
    ("moment", "first_moment", "First moment", "Mean of the shear times its place across the core, from −½ at the bottom to ½ at the top. It "
     "predicts the difference charge."),
    ("shear", "shear|nonlinearity", "Shear γ", "How much the core is sheared at a point, a pure number: 0.01 means that two horizontal planes 100 µm "
     "apart are shifted by 1 µm against each other. The mean shear is the mean over the core's volume."),
    ("slip", "slip|stick|precursor", "Stick and slip", "A part of the contact sticks while friction holds it and slips once it does not. Slip grows "
     "inwards from the rim until everything slips."),
    ("audit", "_error|residual", "Audits", "What exact numbers would make 0. They say how well the equations are solved, not how fine the mesh is."),
    ("touchdown", "touchdown", "Touchdown, slide, lift, return", "The four phases of a cycle: down to the preload, along the skin, up, and back "
     "through the air. Numbers are of the first cycle."),
    ("slide", "_slide", "Mid-slide", "The middle of the slide of the first cycle."),
]


def words(name):
    """Name of a metric in words; the name itself for an unknown metric."""
    return known_words(name) or name.replace("_", " ").capitalize()


def known_words(name):
    """Name of a metric in words; "" for an unknown metric."""
    if (found := OF_SLIDER.fullmatch(name)) is not None and (own := known_words(found[1])):
        return f"{own}, slider {found[2]}"
    if (found := CURRENT.fullmatch(name)) is not None:
        return f"{KINDS[found[1]]} {SIDES[found[2]]}"
    if name in NAMES:
        return NAMES[name]
    for suffix, instant in INSTANTS.items():
        if name.endswith(f"_{suffix}") and name.removesuffix(f"_{suffix}") in NAMES:
            return f"{NAMES[name.removesuffix(f'_{suffix}')]}, {instant}"
    for part, pattern in PRECURSORS.items():
        if name.startswith(f"precursor_{part}_"):
            return pattern.format(name.removeprefix(f"precursor_{part}_"))
    if name.startswith("initial_charge_"):
        return f"Charge at the start, {name.removeprefix('initial_charge_')}"
    return ""


def in_words(text):
    """Replaces names of metrics in a sentence by words: "mean_shear_slide (30 %)" becomes "mean shear, mid-slide (30 %)"."""
    def word(found):
        known = known_words(found[0])
        return known[:1].lower() + known[1:] if known else found[0]

    return re.sub(r"(?<![\w.])[a-z0-9]+(?:_[a-z0-9]+)+(?![\w.]*=)", word, text)


def column_words(table, name):
    """Name of a column of a table of signals in words; the name itself for an unknown column."""
    if name.startswith("current_") and name.removeprefix("current_") in SIDES:
        side = SIDES[name.removeprefix("current_")]
        return f"Sampled {side}" if table == "sampled" else side.capitalize()
    if (found := OF_SLIDER.fullmatch(name)) is not None and found[1] in COLUMNS:
        return f"{COLUMNS[found[1]]}, slider {found[2]}"
    return COLUMNS.get(name) or words(name)


def is_share(name):
    """True if a metric is shown in percent."""
    found = OF_SLIDER.fullmatch(name)
    return (found[1] if found else name).removesuffix("_touchdown").removesuffix("_slide") in SHARES


def explained_by(name):
    """Identifier of the glossary's entry that explains a metric's name; "" for none."""
    return next((identifier for identifier, asks, *_ in GLOSSARY if re.search(asks, name)), "")


def glossary(names):
    """Entries of the glossary for some metrics, as rows of identifier, word and meaning."""
    asked = {explained_by(name) for name in names}
    return [(identifier, heading, meaning) for identifier, _, heading, meaning in GLOSSARY if identifier in asked]
