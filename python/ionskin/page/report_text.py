# SPDX-License-Identifier: Apache-2.0
"""Words and numbers of the report of a run, taken from its Results."""

from ..analysis.derived import common_is_noise
from ..charts.readout import has_voltages, is_open, passes_nothing
from ..words import percent, quantity, readable_units
from . import quantities

HEADLINE = ["normal_force_slide", "mean_shear_slide", "peak_sampled_taxel_current", "peak_sampled_current_top",
            "peak_sampled_current_difference", "rms_current_difference", "rms_current_common", "peak_open_circuit_voltage", "open_circuit_voltage_per_newton"]
HEADLINE_OPEN = ["normal_force_slide", "mean_shear_slide", "peak_voltage", "rms_voltage",  # between the electrodes no current flows
                 "peak_open_circuit_voltage"]
DIGITS = 3

CASE_GROUPS = {"skin": "Skin", "slider": "Slider", "motion": "Motion", "contact": "Contact",
               "electrochemistry": "Ions", "coupling": "Coupling", "water": "Water", "strain": "Strain",
               "readout": "Readout", "numerics": "Numerics"}

SOURCES = {"cache": "read from the cache", "earlier run": "read from an earlier run", "another point": "shared with another point"}

NUMBERS_NOTE = ("Peaks are of the magnitude. Peaks of resolved currents are means over one time step at a contact event; the sampled "
                "ones converge with the time step. The last column names a number in summary.json and sweep.csv, which hold all digits.")

LIMITS = [
    "Linear elasticity with small strain, quasi-static. The slip direction neglects the convective part of the slip "
    "rate, which is of the order of the strain, and the drift of the footprint during the onset of sliding.",
    "Transport of one mobile cation against a fixed charge, as a dilute or a lattice solution, with constant diffusivity "
    "and permittivity. Both electrodes block; there is no reaction, and the ions do not act back on the mechanics.",
    "The difference current during the onset of sliding is a small remainder of large terms; its instantaneous peak "
    "there is 5 to 30 % uncertain.",
]
NO_WATER = "No water flows."
UNCALIBRATED = ("No measurement calibrates the coupling coefficient k: while the response is linear the currents are in "
                "proportion to it, and their absolute size is not a prediction.")

RIGID = "The slider is rigid: what it touches gives way, it does not."
SOFT = "The slider gives as a linear half-space, or a layer on a rigid body, under small strains."
SHARP = ("{slider} Its edges are sharp: stress and shear at the edges grow as the mesh is refined. Mean, rms "
         "and percentiles converge; a pointwise maximum does not, and the peak pressure is not a result.")
ROUND = ("{slider} Without sharp edges pressure and shear are finite, "
         "but the rim of the contact is known to one cell of the mesh only, and the pressure of that cell is uncertain.")

WET = ("The coupling law “poroelastic” has no fitted coefficient. Pressure drives water, which drags cations and dilutes "
       "them. The strain is that of the undrained skin and does not follow the water; the convention of the dilution "
       "(water.dilution) is a choice with a range; electro-osmosis does not move the water back.")

LAW_LIMITS = {
    "fixed-charge": "The coupling law “fixed-charge” creates net charge in the core, which both electrodes image: it "
    "drives the common current. Between the electrodes of an otherwise isolated cell an ammeter carries the difference "
    "current only.",
    "volume-neutral": "The coupling law “volume-neutral” subtracts the volume mean of the shear, so that the core stays "
    "neutral as a whole while single columns do not.",
    "column-neutral": "The coupling law “column-neutral” subtracts the mean over the thickness, so that every column of "
    "the core stays neutral.",
}


def headline(results):
    """Headline numbers of the page and the terminal: dict of metric name to label, value and error."""
    left_out = {"rms_current_common"} if "current_common" in results.sampled and common_is_noise(results) else set()
    if has_voltages(results):  # of taxels, which the opening sentence gives
        left_out.add("peak_sampled_taxel_current")
    names = HEADLINE_OPEN if is_open(results) else HEADLINE
    return {name: (quantities.words(name), value(results, name), error(results, name)) for name in names
            if name in results.metrics and name not in left_out}


def value(results, name):
    """Text of a metric with its unit, rounded for reading."""
    number, unit = results.metrics[name]
    if number is not None and quantities.is_share(name):
        return percent(number)
    return quantity(number, unit, DIGITS)


def error(results, name):
    """Text of a metric's reported error estimate, "± 2 %"; "" where it has none."""
    share = results.summary.get("error_estimate", {}).get(name)
    if share is None or name in results.not_converging:
        return ""
    return f"± {percent(share)}".replace("± below", "below")


def subtitle(results):
    """Line below the title of the page: simulated time, time of solving, version and date."""
    program = results.manifest.get("program", {})
    time = results.signals["time"]
    parts = [f"{time[-1] - time[0]:.6g} s simulated"]
    timing = results.summary.get("timing", {})
    solving = sum(seconds for stage, seconds in timing.items() if stage not in ("output", "total"))
    if solving:
        parts.append(f"solved in {solving:.3g} s")
    if program:
        parts.append(f"ionskin {program.get('version', '')}")
    if results.manifest.get("started"):
        parts.append(results.manifest["started"].replace("T", " ").replace("Z", " UTC"))
    return " · ".join(parts)


def readable(value, between=", "):
    """Text of a value of a case file for reading; entries of a list are joined by `between`."""
    if isinstance(value, list) and value and isinstance(value[0], dict):
        return f"{len(value)} in the case file"
    if isinstance(value, list):
        return between.join(map(readable, value))
    if isinstance(value, bool):
        return "yes" if value else "no"
    return readable_units(str(value))


def layers(case):
    """Rows of the layer table, top layer first."""
    return [(layer.get("name", ""), layer.get("role", ""), layer.get("material", ""), readable(layer.get("thickness", "")))
            for layer in reversed(case.get("skin", {}).get("layers", []))]


def sheet_resistances(case):
    """Entries on the layers that have a sheet resistance, top layer first."""
    return [(f"sheet resistance, {layer.get('name', '')}", readable(layer["sheet_resistance"]))
            for layer in reversed(case.get("skin", {}).get("layers", [])) if "sheet_resistance" in layer]


def taxels(value):
    """Text of the taxels of a case: a grid by its size, single taxels by their number."""
    if not isinstance(value, dict):
        return str(len(value))
    return f"{value['rows']} rows × {value['columns']} columns" + (" that cross" if value.get("wiring") == "crossbar" else "")


def case_groups(case, sliders=()):
    """Pairs of heading and entries for every part of the case. `sliders` are the cases of further sliders."""
    groups = []
    for key, heading in CASE_GROUPS.items():
        entries = [(name.replace("_", " "), readable(value, " × " if name == "size" else ", ")) for name, value in case.get(key, {}).items()
                   if not isinstance(value, dict) and name not in ("layers", "taxels")]
        if key == "readout" and "taxels" in case.get(key, {}):
            entries.append(("taxels", taxels(case[key]["taxels"])))
        if key == "skin":
            entries += sheet_resistances(case)
        if key == "readout" and sheet_resistances(case) and "contact" not in case.get(key, {}):
            entries.append(("contact", "one end"))
        if entries:
            groups.append((heading, entries))
    for number, further in enumerate(sliders, 2):
        groups += further_slider(case, further, number)
    for name, material in case.get("materials", {}).items():
        groups.append((f"Material {name}", [(key.replace("_", " ").replace("youngs", "Young's").replace(
            "poissons", "Poisson's"), readable(value)) for key, value in material.items()]))
    return groups


def further_slider(case, further, number):
    """Groups of entries on a slider beside the first: its shape, and where its motion
    and contact differ from the first one's."""
    own = {"slider": further.get("slider", {})} | {
        key: {name: value for name, value in further.get(key, {}).items() if value != case.get(key, {}).get(name)}
        for key in ("motion", "contact")}
    return [(f"Slider {number}" if heading == CASE_GROUPS["slider"] else f"{heading} of slider {number}", entries)
            for heading, entries in case_groups(own)]


def metric_rows(results):
    """Rows of the table of metrics: words, identifier in the glossary, value, error estimate or why it has none, name."""
    return [(quantities.words(name), quantities.explained_by(name), value(results, name),
             f"does not converge: {results.not_converging[name]}" if name in results.not_converging else error(results, name), name)
            for name in results.metrics]


def timing_rows(results):
    """Rows of the timing table: stage, state, wall time, peak memory; the last row is their sum."""
    timing = results.summary.get("timing", {})
    stages = results.manifest.get("stages", {})
    rows = []
    for name, seconds in timing.items():
        if name in ("output", "total"):
            # The report is made while the output stage runs: the final figures stand in summary.json.
            continue
        stage = stages.get(name, {})
        if name not in stages and seconds == 0:  # whoever reads the strain needs no mechanics
            if name == "mechanics" and stages.get("strain", {}).get("source") in SOURCES:
                rows.append((name, SOURCES[stages["strain"]["source"]], "", ""))
            continue
        memory = stage.get("peak_memory_bytes", 0)
        state = SOURCES.get(stage.get("source"), stage.get("state", ""))
        rows.append((name, state, f"{seconds:.2f} s", f"{memory / 1e9:.2f} GB" if memory else ""))
    if rows:
        rows.append(("sum", "", f"{sum(timing[row[0]] for row in rows):.2f} s", ""))
    return rows


def counter_rows(results):
    """Rows of the counters of the solvers. Times are sums over threads, and can exceed the time of a stage."""
    rows = []
    for name, value in results.manifest.get("counters", {}).items():
        timed = name.startswith("seconds_")
        rows.append((name.removeprefix("seconds_").replace("_", " ") + (", summed over threads" if timed else ""),
                     f"{value:.6g}" + (" s" if timed else "")))
    return rows


def origin_rows(results):
    """Rows on the origin of the results: program, commit, compiler, command, threads, start, hash of the input."""
    manifest = results.manifest
    program = manifest.get("program", {})
    rows = [("program", f"{program.get('name', 'ionskin')} {program.get('version', '')}".strip()),
            ("commit", program.get("commit", "")), ("compiler", program.get("compiler", "")),
            ("command", manifest.get("command", "")), ("threads", manifest.get("threads", "")),
            ("started", manifest.get("started", "")), ("input hash", manifest.get("input_hash", ""))]
    return [row for row in rows if row[1] != ""]


def has_sharp_edges(slider):
    """True for a flat slider without rounded edges; also for a height map, whose edges are not known here."""
    shape = slider.get("shape", "flat")
    return shape == "profile" or shape == "flat" and str(slider.get("edge_radius", "0")).split()[0].strip("0.") == ""


def limits(results):
    """Sentences on those limits of the model that concern the case of a run."""
    texts = list(LIMITS)
    slider = results.case.get("slider")
    if slider:
        edges = SHARP if has_sharp_edges(slider) else ROUND
        texts.insert(1, edges.format(slider=SOFT if slider.get("youngs_modulus") else RIGID))
    if law(results) in LAW_LIMITS:
        texts.append(LAW_LIMITS[law(results)])
    texts.extend([WET] if law(results) == "poroelastic" else [NO_WATER, UNCALIBRATED])
    return texts


def law(results):
    """Name of the coupling law of a run's case."""
    return results.case.get("coupling", {}).get("law", "fixed-charge")


def contact_caption(results):
    """Caption of the contact maps; its words on the colours follow the slider."""
    where = "Under the slider and in its frame, seen from above; last row: section through the core at mid-width."
    if len(results.sliders) > 1:
        where = where.replace("the slider", "the first slider")
    if not has_sharp_edges(results.case.get("slider", {})):
        return where
    return (where + " Under sharp edges the peaks depend on the mesh: the colours end where 95 % of the area (tractions) and "
            "99 % of the section lie below.")


def metal_caption(results):
    """Caption of the potential along the metal, with its largest difference during the run."""
    drop = results.metrics["peak_metal_drop"]
    return ("Against the lead of the bottom electrode, at instants of output.fields. During the run it differs by up to "
            f"{quantity(drop.value, drop.unit, 3)} along one metal.")


def shear_caption(results):
    """Caption of the shear over time."""
    text = "Scalar shear γ in the ion-conducting layer."
    if has_sharp_edges(results.case.get("slider", {})):
        text += " The pointwise maximum depends on the mesh under the slider's sharp edges and is not shown."
    return text


def charge_caption(results):
    """Caption of the electrodes' charge, by the coupling law, since only some laws make a common part."""
    text = "Charge on the metal."
    if law(results) == "fixed-charge":
        text += " The common part follows the net fixed charge that the shear creates."
    return text + " The difference relaxes as the ions redistribute." * (not passes_nothing(results))
