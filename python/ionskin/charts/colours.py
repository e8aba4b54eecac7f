# SPDX-License-Identifier: Apache-2.0
"""Colours of every figure, which colour-blind readers tell apart."""

INK = "#22252a"
QUIET = "#6b7280"
GRID = "#dfe2e7"
PALE = "#b4bac4"
BAND = "#eef1f5"
BAND_STRONG = "#e0e5ec"
# Blue, vermilion, green and purple after Okabe and Ito (2008, jfly.uni-koeln.de/color).
BLUE = "#0072b2"
ORANGE = "#d55e00"
GREEN = "#00875f"
PURPLE = "#b3588f"
# What a page replaces by its own variables, so that figures follow light and dark.
THEMED_COLOURS = {
    INK: "ink", QUIET: "quiet", GRID: "grid", PALE: "pale", BAND: "band", BAND_STRONG: "band-strong",
    BLUE: "blue", ORANGE: "orange", GREEN: "green", PURPLE: "purple",
}
SEQUENCE = "viridis"  # perceptually even and safe for colour-blind readers
DIVERGING = "PuOr_r"
# Red, green and blue of a palette at equal distances, linear between: every sixteenth colour of matplotlib's viridis, and
# the eleven of PuOr of C. Brewer (colorbrewer2.org) in the reverse order.
PALETTES = {
    SEQUENCE: ["#440154", "#48186a", "#472d7b", "#424086", "#3b528b", "#33638d", "#2c728e", "#26828e", "#21918c",
               "#1fa088", "#28ae80", "#3fbc73", "#5ec962", "#84d44b", "#addc30", "#d8e219", "#fde725"],
    DIVERGING: ["#2d004b", "#542788", "#8073ac", "#b2abd2", "#d8daeb", "#f7f7f7", "#fee0b6", "#fdb863", "#e08214", "#b35806",
                "#7f3b08"],
}


def parts(colour):
    """Red, green and blue of "#rrggbb", each from 0 to 255."""
    return [int(colour[at:at + 2], 16) for at in (1, 3, 5)]


def mixed(palette, place):
    """The colour of a palette at a place from 0 to 1, as "#rrggbb"."""
    colours = PALETTES[palette]
    place = min(1.0, max(0.0, place)) * (len(colours) - 1)
    below = min(int(place), len(colours) - 2)
    return "#" + "".join(f"{round(a + (place - below) * (b - a)):02x}" for a, b in zip(parts(colours[below]), parts(colours[below + 1])))
