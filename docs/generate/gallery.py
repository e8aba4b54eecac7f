# SPDX-License-Identifier: Apache-2.0
"""The figure gallery: what `ionskin report --figures` draws of a ten-point friction sweep."""

import shutil

HEAD = """# Figure gallery

What `ionskin report --figures` draws. Figures 1 to 16 are those of the paper (*Sensors* 2026, 26(10),
2930), 17 to 20 and 23 what it lacks; figures 21 and 22, of sampled sweeps, are not in this one. These are of the coarse
sweep

    ionskin sweep cases/paper/coarse.toml --over contact.friction=0.05:0.05:0.5 -o sweep
    ionskin report sweep --figures

and show layout, not reference numbers. Every figure is there as PNG, SVG and PDF.

"""
NOTHING = HEAD + "The figures were not there when these pages were built; `make docs` makes them.\n"
TITLES = {
    "fig01_model": "The model in three dimensions", "fig02_layers": "The layers",
    "fig03_stages": "Stages of the motion", "fig04_motion": "Motion of the slider",
    "fig05_shear": "Mean shear over time", "fig06_shear_map": "Mean shear over time and friction",
    "fig07_peaks": "Peaks against friction", "fig08_means": "Means against friction",
    "fig09_current": "Currents over time", "fig10_current_map": "Current over time and friction",
    "fig11_rate": "Current and rate of the shear", "fig12_current_motion": "Current and motion",
    "fig13_cycle": "One cycle", "fig14_phases": "Phases on the current", "fig15_normalised": "The three normalised",
    "fig16_correlation": "Peak current against peak shear", "fig17_stick_slip": "Stick and slip",
    "fig18_contact_maps": "Pressure and shear in contact", "fig19_ions": "Ions and potential",
    "fig20_charge": "Charge and its audit", "fig23_friction_window": "The friction window",
}


def gallery(figures, folder):
    """Copies the pictures into the folder and returns the Markdown of the page."""
    pictures = sorted(figures.glob("fig*.png")) if figures.exists() else []
    if not pictures:
        return NOTHING
    parts = []
    for picture in pictures:
        shutil.copy(picture, folder / picture.name)
        title = TITLES.get(picture.stem, picture.stem)
        parts.append(f"## {title}\n\n`ionskin report sweep --figure {picture.stem}`\n\n![{title}]({picture.name})\n")
    return HEAD + "\n".join(parts)
