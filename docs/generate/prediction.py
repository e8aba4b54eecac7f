# SPDX-License-Identifier: Apache-2.0
"""The page "A prediction before the measurement", from the file that benchmarks/prediction.py wrote."""

import json
import subprocess
import sys

HEAD = """# A prediction before the measurement

What the law [`poroelastic`](model.md) says of strips and of a touch that have not been measured, so that a laboratory can hold it against us. Nothing is fitted:
each constant has a source that is not the signal, or is varied over all that it can be. The numbers of DATE stand in `docs/prediction.json`, whose content
has the SHA-256 digest

    DIGEST

`benchmarks/prediction.py --check docs/prediction.json` compares the two; `benchmarks/prediction.py build/ionskin FILE` makes the file anew
(`ionskin uncertainty`, SAMPLES samples a strip).

## Voltage per curvature of bent strips

Narrow strips between gold, bent by CURVATURE 1/m at once and held, terminals open: the highest voltage, and the one that stays when the water has settled, over the
curvature. Positive: the electrode on the stretched side is above the other. Lowest, middle and highest of all samples, in uV m:

"""
PROTOCOL = """
Forms in water other than H+ take drag numbers from memory, and moduli for which no source was found: their ranges say so. In air the constants of H+ alone have sources
([materials](materials.md)), from 50 % humidity upwards; what the other three do there is not predicted. Before water moves, the peak of a narrow strip is
$n_d V_w E h\\kappa/(3 v F)$, so that drag number and modulus make nearly all of its range: measured on the same strip, they leave a few per cent.

What would refute the law, whatever the constants are within their ranges:

- a peak that does not double with the thickness;
- a peak of Li+ that is not at least twice that of H+ at the same modulus;
- a steady voltage of the sign opposite to the peak;
- a decay of soaked strips that does not slow down with thickness, once that of the polymer is taken off.

## A soft finger on a wet taxel

A rubber sphere of 8 mm radius and 0.5 MPa presses with FORCE N on the middle one of three taxels on soaked Nafion 117 (`cases/evidence/finger_taxel.toml`), terminals open. The highest
voltage of that taxel against the bottom electrode is LOW to HIGH uV, MIDDLE uV in the middle; the mesh of `coarse` adds a stated error of ERROR %.

## The protocol

1. Cut strips of 30 mm by 5 mm from one sheet of Nafion 117 (183 um dry) and one of Nafion 1110 or 115, of another thickness, plate both faces with gold from the same bath, cut the edges afresh.
2. Exchange each into H+, Li+, Na+ and K+ (1 M chloride, twice, a day each), rinse, keep in water of the same temperature, 25 degC.
3. Bend by a template of known radius within 20 ms, hold for 1000 s, read with an instrument of 1 Gohm at least; ten times to each side, the mean of both signs taken apart.
4. Bend the same strips at 90 and 50 % humidity after a day in it, sealed by a coat of Parylene.
5. Write down the voltages before the constants below are worked out, and the constants before anyone compares.

Each constant is measured apart from the signal, on the same sheet:

| constant | by |
|---|---|
| drag number | electro-osmosis: water carried by a known charge between Ag/AgCl electrodes, or the streaming potential of the bare membrane under pressure |
| Young's modulus | force of the bent strip, at once and over 1000 s: that is the relaxation of the polymer, too, of a strip that is too thick for its water to move meanwhile |
| drained modulus | swelling in air of known humidity: content of water over its potential |
| permeability | water pressed through the bare membrane; in air, water that permeates between two humidities |
| diffusivity of the cation | resistance at 10 kHz to 1 MHz |
| double layers | impedance below 1 kHz, with `electrochemistry.interface_capacitance` |
| fixed charge and share of water | titration; weight and thickness, dry and as used |

## What was varied

"""


def row(strip):
    cells = [f"{1e6 * strip[name]['lowest']:.2g} | {1e6 * strip[name]['middle']:.2g} | {1e6 * strip[name]['highest']:.2g}"
             for name in ("peak_V_m", "steady_V_m")]
    return f"| {strip['cation']}, {strip['kept']} | {strip['thickness_um']} | {' | '.join(cells)} |"


def table(strips):
    """A row for each strip."""
    return "\n".join(["| strip | um | peak: lowest | middle | highest | steady: lowest | middle | highest |", "|---|---|---|---|---|---|---|---|",
                      *map(row, strips)]) + "\n"


def ranges(content):
    """What was varied, and from where, once for each kind of strip."""
    lines = ["| of | key | range | source |", "|---|---|---|---|"]
    seen = set()
    for name, one in [(f"{strip['cation']}, {strip['kept']}", strip) for strip in content["strips"]] + [("the touch", content["touch"])]:
        if name not in seen:
            seen.add(name)
            lines += [f"| {name} | `{key}` | `{value['range']}` | {value['source']} |" for key, value in one["ranges"].items()]
    return "\n".join(lines) + "\n"


def prediction(path):
    """Markdown of the page. A file that was changed since its day is refused."""
    subprocess.run([sys.executable, path.parent.parent / "benchmarks" / "prediction.py", "--check", path], check=True)
    content = json.loads(path.read_text(encoding="utf-8"))
    touch = content["touch"]
    head = (HEAD.replace("DATE", content["date"]).replace("DIGEST", content["sha256"])
            .replace("SAMPLES", str(content["samples"])).replace("CURVATURE", f"{content['curvature_1_m']:g}"))
    after = (PROTOCOL.replace("FORCE", f"{touch['force_N']:g}").replace("LOW", f"{1e6 * touch['peak_V']['lowest']:.2g}")
             .replace("HIGH", f"{1e6 * touch['peak_V']['highest']:.2g}").replace("MIDDLE", f"{1e6 * touch['peak_V']['middle']:.2g}")
             .replace("ERROR", f"{100 * touch['relative_numerical_error']:.2g}"))
    return head + table(content["strips"]) + after + ranges(content)
