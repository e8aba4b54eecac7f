# SPDX-License-Identifier: Apache-2.0
"""Numbers and texts as a reader sees them."""

LONGEST_LABEL = 48
PREFIXED = ("A", "C", "N", "V", "s", "Pa", "m", "J", "W", "Ohm", "Ω", "F", "Hz")
PREFIXES = {-15: "f", -12: "p", -9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}


def si_scale(peak):
    """Divisor and prefix that bring a largest magnitude between 1 and 1000: (1e-6, "µ")."""
    exponent = 0
    if peak > 0:
        while peak < 10.0**exponent and exponent > -15:
            exponent -= 3
        while peak >= 10.0 ** (exponent + 3) and exponent < 9:
            exponent += 3
    return 10.0**exponent, PREFIXES[exponent]


def quantity(value, unit, digits=4):
    """A number with its unit and an SI prefix; pure numbers stay plain."""
    if value is None:
        return "–"
    value = float(f"{value:.{digits}g}")  # 0.9999999 N is 1 N, not 1e+03 mN
    if unit == "1":
        return f"{value:.{digits}g}"
    if unit not in PREFIXED:
        return f"{value:.{digits}g} {unit}"
    divisor, prefix = si_scale(abs(value))
    return f"{value / divisor:.{digits}g} {prefix}{unit}"


def percent(share):
    """A share in percent to two significant digits; beyond 1,000 % it only tells that nothing is known."""
    value = 100 * share
    if value > 1000:
        return "over 1000 %"
    return f"{float(f'{value:.2g}'):.0f} %" if value >= 10 else f"{value:.2g} %"


def short(text, longest=LONGEST_LABEL):
    """A text of a case or a file as a figure can show it: printable, and not longer than there is room for."""
    plain = "".join(letter if letter.isprintable() else " " for letter in str(text)).strip()
    return plain if len(plain) <= longest else f"{plain[:longest - 1]}…"
