# SPDX-License-Identifier: Apache-2.0
"""The page on the Studio, with the pictures that the test of its page took."""

import shutil

PICTURES = {"start-1300": "The start page", "case-1300": "A case as form and text", "mistake-1300": "A mistake at its line and field",
            "scene-1300": "Three runs over one another", "sweep-1300": "A sweep", "fit-1300": "A fit",
            "dark-1300": "Dark colours, logarithmic", "results-390": "On a phone"}


def studio(pictures, source):
    """Markdown of docs/studio.md, with pictures as far as they are there: `ctest -R studio_browser` takes them."""
    text = (source / "studio.md").read_text(encoding="utf-8")
    found = [(name, title) for name, title in PICTURES.items() if (pictures / f"{name}.png").exists()]
    if not found:
        return text
    (source / "images").mkdir(exist_ok=True)
    lines = [text, "## Pictures", ""]
    for name, title in found:
        shutil.copy(pictures / f"{name}.png", source / "images" / f"studio-{name}.png")
        lines += [f"### {title}", "", f"```{{image}} images/studio-{name}.png", f":alt: {title}",
                  f":width: {'40%' if name.endswith('390') else '90%'}", "```", ""]
    return "\n".join(lines)
