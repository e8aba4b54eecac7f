# SPDX-License-Identifier: Apache-2.0
"""The page on installed materials, from their files: every value with the comment that stands above it."""

HEAD = """# Materials

A layer names its material: `material = "nafion_wet"`. What a case does not say of it in `[materials.nafion_wet]` comes
from the installed preset of that name. Ions are those of the core's material, where it has any, unless
`[electrochemistry]` says otherwise; `ionskin check CASE.toml --explain` tells where each value came from. Values
without a source are left out, and a case that needs one has to give it. No preset has a permittivity: the effective
one of an ionomer between rough electrodes belongs to the electrodes as much.

Numbers of a material may be lists over `humidity`, of which `skin.humidity` chooses, linear in between: `nafion_air` has those of Nafion in moist
air. Beyond the list a case is refused, as no number there has a source. A case that gives a number itself comes before the list.

A form that is not here, other cations or less water, takes a few lines of the case:

```toml
[materials.my_membrane]
youngs_modulus = "100 MPa"
poissons_ratio = 0.49
diffusivity = "1e-10 m2/s"                  # of the mobile cation
fixed_charge_concentration = "1100 mol/m3"  # of the wet membrane
valence = 1
```

"""


def entry(file):
    """Section of one preset: what it is, and its values with their sources."""
    comments, about, rows = [], "", []
    for line in file.read_text(encoding="utf-8").splitlines()[1:]:
        if line.startswith("#"):
            comments.append(line.lstrip("# "))
        elif line.startswith("["):
            about, comments = " ".join(comments), []
        elif "=" in line:
            key, value = (part.strip().strip('"') for part in line.split("=", 1))
            rows.append(f"| `{key}` | `{value}` | {' '.join(comments)} |")
            comments = []
    return "\n".join([f"## `{file.stem}`", "", about, "", "| key | value | source |", "|---|---|---|", *rows, ""])


def materials(folder):
    """Markdown of the page."""
    return HEAD + "\n".join(entry(file) for file in sorted(folder.glob("*.toml")))
