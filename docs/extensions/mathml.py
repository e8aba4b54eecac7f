# SPDX-License-Identifier: Apache-2.0
"""Equations as MathML, which browsers show without a script, a font or a network; labelled ones with their label."""

import re

from docutils.nodes import SkipNode
from docutils.utils.math.latex2mathml import tex2mathml
from sphinx.errors import SphinxError


def mathml(node, inline):
    """One line of MathML: its line breaks would show as spaces. Names the equation that is not understood."""
    try:
        tree = tex2mathml(node.astext(), inline=inline)
    except SyntaxError as error:
        raise SphinxError(f"{error} in the equation {node.astext()}") from error
    return re.sub(r">\s+<", "><", tree)


def visit_inline(writer, node):
    writer.body.append(mathml(node, inline=True))
    raise SkipNode


def visit_block(writer, node):
    label = f'<span class="equation-label">({node["label"]})</span>' if node.get("label") else ""
    writer.body.append(f'<div class="equation">{label}{mathml(node, inline=False)}</div>')
    raise SkipNode


def setup(app):
    app.add_html_math_renderer("mathml", (visit_inline, None), (visit_block, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
