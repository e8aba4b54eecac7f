# SPDX-License-Identifier: Apache-2.0
"""Parts of a report page: escaped texts, sections, tables, contents, the frame of the page."""

import html
import pathlib
import re

STYLE_SHEET = pathlib.Path(__file__).with_name("report.css")


def escaped(value):
    """Text for HTML."""
    return html.escape(str(value), quote=True)


def section(identifier, heading, body):
    """One section of the page; nothing when it has no body."""
    return f'<section id="{identifier}"><h2>{escaped(heading)}</h2>{body}</section>' if body else ""


def table(head, rows, number_columns=()):
    """An HTML table of texts; columns of numbers are aligned to the right."""
    if not rows:
        return ""

    def cell(tag, column, text):
        kind = ' class="number"' if column in number_columns else ""
        return f"<{tag}{kind}>{escaped(text)}</{tag}>"

    top = "".join(cell("th", column, text) for column, text in enumerate(head))
    body = "".join("<tr>" + "".join(cell("td", column, text) for column, text in enumerate(row)) + "</tr>"
                   for row in rows)
    return f'<div class="scroll"><table><thead><tr>{top}</tr></thead><tbody>{body}</tbody></table></div>'


def contents(sections):
    """Links to the sections that the page has."""
    found = re.findall(r'<section id="([^"]+)"><h2>(.*?)</h2>', sections)
    return "<nav>" + "".join(f'<a href="#{identifier}">{heading}</a>' for identifier, heading in found) + "</nav>"


def frame(title, subtitle, body, script=""):
    """The whole page around its body; stands alone, without any network."""
    code = f"<script>{script}</script>" if script else ""
    return (f'<!doctype html><html lang="en"><head><meta charset="utf-8">'
            f'<meta name="viewport" content="width=device-width, initial-scale=1">'
            f'<meta name="color-scheme" content="light dark">'
            f"<title>{escaped(title)} – ionskin</title><style>{STYLE_SHEET.read_text(encoding='utf-8')}</style></head>"
            f"<body><main><header><h1>{escaped(title)}</h1><p>{escaped(subtitle)}</p></header>"
            f"{body}</main>{code}</body></html>\n")


def verdict_table(verdicts):
    """The claims of the paper with their verdicts."""
    rows = "".join(f'<tr><td>{escaped(entry.claim)}</td><td class="verdict {entry.verdict.split()[-1]}">'
                   f"{escaped(entry.verdict)}</td><td>{escaped(entry.number)}</td></tr>" for entry in verdicts)
    return (f'<div class="scroll"><table><thead><tr><th>claim</th><th>verdict</th><th>by the data</th></tr></thead>'
            f"<tbody>{rows}</tbody></table></div>")


def write_page(path, text):
    """Writes a page so that readers see the old one or the whole new one."""
    pending = path.with_suffix(".html.tmp")
    pending.write_text(text, encoding="utf-8")
    pending.replace(path)
    return path
