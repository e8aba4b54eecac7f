# SPDX-License-Identifier: Apache-2.0
"""SVG of matplotlib inside a page, and as a file."""

import re

from ..charts.colours import THEMED_COLOURS


def inline_svg(svg, name):
    """Makes an SVG file's text an element of a page: scalable, in the page's theme, with ids that begin with `name`."""
    body = svg[svg.index("<svg"):]
    body = re.sub(r"<metadata>.*?</metadata>", "", body, flags=re.S)
    body = re.sub(r'(<svg[^>]*?) width="[^"]*"', r"\1", body, count=1)
    body = re.sub(r'(<svg[^>]*?) height="[^"]*"', r"\1", body, count=1)
    body = re.sub(r'id="([^"]+)"', rf'id="{name}-\1"', body)
    body = re.sub(r'(url\(#|xlink:href="#)', rf"\1{name}-", body)
    for colour, variable in THEMED_COLOURS.items():
        body = body.replace(colour, f"var(--{variable})")
    return body


def white_background(svg):
    """Adds a white rectangle behind the drawing of an SVG text."""
    start = svg.index(">", svg.index("<svg")) + 1
    return f'{svg[:start]}\n <rect width="100%" height="100%" fill="white"/>{svg[start:]}'
