# SPDX-License-Identifier: Apache-2.0
"""Formatting of numbers and texts for readers."""

import re

LONGEST_LABEL = 48
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
PREFIXED = ("A", "C", "N", "V", "s", "Pa", "m", "J", "W", "Ohm", "Ω", "F", "Hz", "V/N")
POWERS = {"m2": ((1e-6, "mm²"), (1e-12, "µm²")), "m3": ((1e-9, "mm³"), (1e-18, "µm³"))}  # largest first
SIGNS = ((r"\bu(m|s|A|C|V|N|l)\b", r"µ\1"), (r"\bdegC\b", "°C"), (r"(?<=m)2\b", "²"), (r"(?<=m)3\b", "³"), (r"\b[oO]hms?\b", "Ω"))
FOLDERS = re.compile(r"(?<![\w./:~<])/(?:[^/\s\"'<>]+/)+([^/\s\"'<>]*)")
QUOTED_FOLDERS = re.compile(r"([\"'])/(?:[^/\"'<>]+/)+([^/\"'<>]*)\1")
PREFIXES = {-15: "f", -12: "p", -9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}


def si_scale(peak):
    """Divisor and SI prefix, such as (1e-6, "µ"), that bring the largest magnitude of some values between 1 and 1000."""
    exponent = 0
    if peak > 0:
        while peak < 10.0**exponent and exponent > -15:
            exponent -= 3
        while peak >= 10.0 ** (exponent + 3) and exponent < 9:
            exponent += 3
    return 10.0**exponent, PREFIXES[exponent]


def quantity(value, unit, digits=4):
    """Text of a number in an SI unit, with a prefix: 5e-7, "m" gives "500 nm"; without one for the unit "1"; "–" for None."""
    if value is None:
        return "–"
    value = float(f"{value:.{digits}g}")  # 0.9999999 N is 1 N, not 1e+03 mN
    if unit == "1":
        return without_e(f"{value:.{digits}g}")
    for size, name in POWERS.get(unit, ()):
        if abs(value) >= 0.01 * size or size == POWERS[unit][-1][0]:
            return f"{value / size:.{digits}g} {name}"
    if unit not in PREFIXED:
        return f"{value:.{digits}g} {unit}"
    divisor, prefix = si_scale(abs(value))
    text = f"{value / divisor:.{digits}g}"
    return f"{value / divisor:.0f} {prefix}{unit}" if "e" in text and abs(value / divisor) < 1000 else f"{text} {prefix}{unit}"


def without_e(text):
    """Replaces the exponent of a number's text: "9.42e-05" becomes "9.42 × 10⁻⁵"."""
    mantissa, _, power = text.partition("e")
    return f"{mantissa} × 10{str(int(power)).translate(SUPERSCRIPTS)}" if power else text


def percent(share):
    """Text of a share in percent, to two significant digits; "below 0.01 %" and "over 1000 %" for shares beyond."""
    value = 100 * share
    if 0 < value < 0.01:
        return "below 0.01 %"
    if value > 1000:
        return "over 1000 %"
    return f"{float(f'{value:.2g}'):.0f} %" if value >= 10 else f"{value:.2g} %"


def short(text, longest=LONGEST_LABEL):
    """Makes a text of a case or a file fit for a figure: printable, and cut to `longest` characters."""
    plain = "".join(letter if letter.isprintable() else " " for letter in str(text)).strip()
    return plain if len(plain) <= longest else f"{plain[:longest - 1]}…"


def aligned(rows):
    """Formats rows of texts as aligned lines; leaves out columns that are empty below the first row, the heading."""
    rows = [row for row in zip(*(column for column in zip(*rows) if any(column[1:])))]
    widths = [max(map(len, column)) for column in zip(*rows)]
    return ["  ".join(text.ljust(width) for text, width in zip(row, widths)).rstrip() for row in rows]


def readable_units(text):
    """Replaces units of a case file by printed ones: "10 um" becomes "10 µm", "7e-11 m2/s" becomes "7e-11 m²/s"."""
    for found, sign in SIGNS:
        text = re.sub(found, sign, text)
    return text


def without_folders(text):
    """Removes the folders of absolute paths, which say something of the user's machine:
    "/home/ada/x.toml" becomes "…/x.toml"."""
    return FOLDERS.sub(r"…/\1", QUOTED_FOLDERS.sub(r"\1…/\2\1", text))
