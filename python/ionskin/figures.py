# SPDX-License-Identifier: Apache-2.0
"""The figures of one run. Each function takes Results and returns a Chart, None without its
data, or in words what the run would need for it."""

from typing import Callable, NamedTuple

import numpy

from .analysis import derived
from .charts import contact, ions, metal, onset, readout, skin, water
from .charts.chart import Axis, Cell, Chart, Curve, Mark, Note, current_axis, over_time, phase_spans, with_coincidence_noted, with_events
from .charts.colours import BLUE, GREEN, ORANGE, PALE, PURPLE, QUIET
from .charts.spans import rows_within, sampled_label, slide_start
from .page import report_text
from .reading.sliders import suffix


def motion(results):
    """Figure of the position of the sliders over time, with the phases of the motion."""
    signals = results.signals
    if not signals.has("slider_x", "slider_z"):
        return None

    def curves(axis):
        return [Curve(signals["time"], signals[f"slider_{axis}{end}"], name, colour) for name, end, colour in named_sliders(results)]

    panels = [("Centre of the slider along the skin", Axis("position x", "m"), curves("x"), 0.7)]
    if any(skin.moves_across(results, end) for _, end, _ in named_sliders(results)):
        panels.append(("Centre of the slider across the skin", Axis("position y", "m"), curves("y"), 0.7))
    panels.append(("Underside of the slider above the undeformed skin", Axis("height z", "m"), curves("z"), 0.7))
    chart = over_time(results, panels)
    (position,), *between, (height,) = chart.rows
    return chart._replace(rows=[[position._replace(spans=phase_spans(results, named=True))], *between,
                                [height._replace(marks=(Mark(0.0, "", "y"),))]])


def named_sliders(results):
    """Name, suffix of its signals and colour of each slider, as a list; the name is "" for a single slider."""
    count = len(results.sliders)
    return [(f"slider {number + 1}" if count > 1 else "", suffix(number), colour)
            for number, colour in zip(range(count), (BLUE, ORANGE, GREEN, PURPLE))]


def shear(results):
    """Figure of the shear of the core over time: mean, spread, and first moment over the thickness."""
    signals = results.signals
    if not signals.has("mean_shear"):
        return None
    time, law = signals["time"], report_text.law(results)
    return over_time(results, [
        ("Volume mean" + ": predicts the common charge" * (law == "fixed-charge"), Axis("mean shear"),
         [Curve(time, signals["mean_shear"])], 0.8),
        ("Spread over the core", Axis("shear"), [Curve(time, signals["p99_shear"], "99th percentile by volume", ORANGE),
                                                 Curve(time, signals["rms_shear"], "rms", GREEN)], 0.8),
        ("Mean of γ (ζ/h − ½)" + ": predicts the jumps of the difference charge" * (law != "poroelastic"), Axis("first moment"),
         [Curve(time, signals["shear_first_moment"], "", PURPLE)], 0.8)])


def forces(results):
    """Figure of the normal and tangential force of every slider on the full skin over time."""
    signals = results.signals
    if not signals.has("normal_force"):
        return None
    panels = []
    for name, end, _ in named_sliders(results):
        tangential = signals[f"tangential_force{end}"]
        if skin.moves_across(results, end) and signals.has(f"tangential_force_x{end}", f"tangential_force_y{end}"):
            # tangential_force is along the first slide
            tangential = numpy.hypot(signals[f"tangential_force_x{end}"], signals[f"tangential_force_y{end}"])
        panels.append(("Force on the full skin" + (f", {name}" if name else ""), Axis("force", "N"),
                       [Curve(signals["time"], signals[f"normal_force{end}"], "normal"),
                        Curve(signals["time"], tangential, "tangential", ORANGE)], 1.0))
    return over_time(results, panels)


def currents(results):
    """Figure of the currents of both electrodes over time, with their difference, which an
    ammeter between them reads, and common part."""
    signals, sampled = results.signals, results.sampled
    if not signals.has("current_top"):
        return None
    nothing = readout.passes_nothing(results)
    if readout.carries_nothing(results):
        return readout.OPEN
    time = signals["time"]
    noise = ": not above the noise of the solver" if derived.common_is_noise(results) else ""
    panels = [("Electrodes, resolved", current_axis(signals["current_top"], signals["current_bottom"]),
               [Curve(time, signals["current_top"], "top", BLUE, "over"),
                Curve(time, signals["current_bottom"], "bottom", ORANGE, "over", 0.8)], 1.1)]
    for name, title, colour in (("difference", "Difference (top − bottom)/2", GREEN),
                                ("common", f"Common (top + bottom)/2{noise}", PURPLE))[nothing:]:
        column = f"current_{name}"
        # Wide and pale below the resolved current, which it equals wherever nothing is fast.
        panels.append((title, current_axis(signals[column]),
                       [Curve(sampled["time"], sampled[column], sampled_label(results), PALE, "held", 2.6,
                              band=results.band("sampled", column)),
                        Curve(time, signals[column], "resolved", colour, "over", 0.8)], 1.1))
    return over_time(results, panels)


def reading(results):
    """Figure of the reading of an ammeter between the shorted electrodes, enlarged at the first contact; None where a
    circuit joins them, or taxels have circuits of their own."""
    sampled = results.sampled
    if results.circuit is not None or readout.has_own_circuits(results) or not sampled.has("current_difference"):
        return None
    curve = Curve(sampled["time"], sampled["current_difference"], "", GREEN, "held", marks=True, band=results.band("sampled", "current_difference"))
    return with_events(results, [("Difference current", Axis("current", "A"), [curve], 1.2)])


def charge(results):
    """Figure of the charge on the metal of both electrodes over time."""
    signals = results.signals
    if not signals.has("charge_top"):
        return None
    if readout.carries_nothing(results):
        return "open electrodes keep their charge"
    time, top, bottom = (signals[name] for name in ("time", "charge_top", "charge_bottom"))
    panels = [("Charge on the electrodes", Axis("charge", "C"), [Curve(time, top, "top"), Curve(time, bottom, "bottom", ORANGE)], 0.9),
              ("Difference (top − bottom)/2", Axis("charge", "C"), [Curve(time, (top - bottom) / 2, "", GREEN)], 0.9)]
    return over_time(results, panels[:1] if readout.passes_nothing(results) else panels)


def join_time(results):
    """Instant at which the computed onset of sliding joins steady sliding in the first cycle [s]; None without an onset."""
    if not (results.folder / "results.h5").exists():
        return None
    with results.open_fields() as file:
        value = float(file["path"].attrs.get("join_time", 0.0)) if "path" in file else 0.0
    start = slide_start(results)
    return value if start is not None and value > start else None


def join(results):
    """Figure of the difference current where the onset of sliding joins steady sliding, at which it must not jump."""
    signals = results.signals
    start, joined = slide_start(results), join_time(results)
    if joined is None or not signals.has("current_difference"):
        return None
    if readout.passes_nothing(results):
        return readout.OPEN
    time, width = signals["time"] - start, joined - start
    cells = []
    for title, low, high, words in (("Onset of sliding, first cycle", 0.0, 4 * width, "steady sliding begins"),
                                    ("The join, enlarged", 0.5 * width, 2 * width, "")):
        shown = (time > low) & (time <= high)
        curve = Curve(time[shown], signals["current_difference"][shown], "", GREEN, "over", marks=True)
        cells.append(Cell(title, Axis("time since the start of the slide", "s", low, high), Axis("difference current", "A"), (curve,),
                          marks=(Mark(width),), phases=(Note(width, 1.0, words, "middle", QUIET),) if words else ()))
    return Chart([[cell] for cell in cells])


def relaxation(results):
    """Figure of the difference charge over each cycle, which shows the share that is left when the next cycle begins."""
    signals = results.signals
    spans = results.phases()
    if not spans or not signals.has("charge_top"):
        return None
    if readout.passes_nothing(results):
        return readout.OPEN
    time, half = signals["time"], (signals["charge_top"] - signals["charge_bottom"]) / 2
    within, detached, length = [], [], 0.0
    for cycle, (colour, look) in cycle_looks(spans):
        own = [span for span in spans if span.cycle == cycle]
        rows = (time >= own[0].start) & (time <= own[-1].end)
        within.append(Curve(time[rows] - own[0].start, half[rows], f"cycle {cycle}", colour, look=look))
        for span in own:
            if span.phase == "return":
                rows, length = rows_within(signals, span), span.end - span.start
                detached.append(Curve(time[rows] - span.start, signals["current_difference"][rows], f"cycle {cycle}", colour, look=look))
    first = [span for span in spans if span.cycle == spans[0].cycle]
    begin, end = first[0].start, first[-1].end
    names = [Note((span.start + span.end) / 2 - begin, 1.0, span.phase, "middle", QUIET) for span in first]
    cells = [Cell("Difference charge", Axis("time within the cycle", "s", 0.0, end - begin), Axis("difference charge", "C"),
                  tuple(within), phase_spans(results, begin, first[0].cycle), phases=tuple(names))]
    if detached:
        cells.append(Cell("Difference current during the detached return", Axis("time since the end of lift-off", "s", 0.0, length),
                          Axis("difference current", "A"), tuple(detached), height=0.9))
    return Chart([[cell] for cell in cells])


def cycle_looks(spans):
    """Pairs of cycle and (colour, look of the line), in order; later cycles are dashed, since cycles may coincide."""
    cycles = sorted({span.cycle for span in spans})
    colours, looks = [BLUE, ORANGE, GREEN, PURPLE], ["", "dashed", "dotted"]
    return [(cycle, (colours[i % 4], looks[min(i, 2)])) for i, cycle in enumerate(cycles)]


class Entry(NamedTuple):
    """Figure of the report of a run: name, heading and caption, and the function that makes its Chart of Results."""

    name: str
    heading: str
    caption: str | Callable  # of the results, where it follows the case
    draw: Callable

    def words(self, results):
        """Caption of the figure, which may depend on the run."""
        return self.caption(results) if callable(self.caption) else self.caption


FIGURES = [
    Entry("reading", "What can be read", "What an instrument between the electrodes shows that integrates over each readout interval, at the "
          "instant at which it can show it; beside it enlarged, one mark per reading. Shaded: its stated error.", reading),
    Entry("model", "Skin and slider", "Before touchdown.", skin.model),
    Entry("plan", "Path from above", "The skin, the way of the slider's centre over it, and the slider where it begins.", skin.plan),
    Entry("motion", "Motion", "Motion of the slider: its height under a force, and its place on a drive, are results. Bands, here and "
          "below: pale where slider and skin touch, darker while it slides.", motion),
    Entry("contact", "Contact", report_text.contact_caption, contact.contact_maps),
    Entry("slip", "How the slide begins", "Above, in the slider's frame: when each place slips for good, with the front between what "
          "sticks and what slips at a fifth to four fifths of that time in white, and how far the slider has slipped over it. Below: "
          "the stuck share and the currents; grey about a current: three times the noise floor of a reading.", onset.onset),
    Entry("shear", "Shear of the core", report_text.shear_caption, shear),
    Entry("currents", "Electrode currents", "Currents on a symmetric logarithmic axis, linear around zero. A resolved "
          "current is the mean over one time step: its spikes are as high as the events are short. The sampled current "
          "is the charge gained over each readout interval divided by it, which an integrating instrument shows from the interval's end on.",
          currents),
    Entry("circuit", "Readout circuit", "The top electrode's potential against the bottom one's, or what the amplifier reads; "
          "circuit.csv holds the numbers.", readout.circuit),
    Entry("water_voltage", "What the water drives", "Voltage that the open cell would have at once, whatever the circuit of the "
          "run: water drags cations (streaming) and thins them where it gathers (dilution). water.csv holds the numbers.",
          water.voltage),
    Entry("water_section", "Water in the core", "Section along the skin at mid-width at instants of output.fields; each panel "
          "has its own colours.", water.section),
    Entry("water_walls", "Pressure between the walls", "Water pressure at the top wall minus that at the bottom one, from above: "
          "its mean is what the whole electrode sees, its map what taxels see.", water.wall_difference),
    Entry("taxel_voltage_map", "Voltages of the taxels", "The skin from above: largest magnitude of each taxel's voltage during the "
          "run; every taxel has a circuit of its own, of a crossbar every column and every row.", readout.taxel_voltage_map),
    Entry("taxel_voltages", "Voltage of each taxel", "Against the bottom electrode, or of a column against a row where they cross, "
          "over time on common axes; taxels.csv holds the numbers.", readout.taxel_voltages),
    Entry("taxel_map", "Taxels", "The skin from above: largest magnitude of each taxel's charge during the run.",
          readout.taxel_map),
    Entry("taxels", "Taxel signals", "Charge of each taxel over time on common axes; taxels.csv holds the currents too.",
          readout.taxel_charges),
    Entry("metal", "Potential along the metal", report_text.metal_caption, metal.potential),
    Entry("ions", "Ions through the thickness", "Concentration and potential in one column of the core at the instants of "
          "output.fields; the outer panels enlarge the double layers.", ions.ions),
    Entry("forces", "Forces", "Contact forces; under full slip the tangential force is the friction coefficient times "
          "the normal force.", forces),
    Entry("charge", "Electrode charge", report_text.charge_caption, charge),
    Entry("join", "From the onset to steady sliding", "Difference current, one mark per time step. A jump of the shear "
          "between the two parts of the contact path would show as a spike at the dashed line.", join),
    Entry("relaxation", "Relaxation between cycles", "The contact repeats exactly, the ions do not: what has not "
          "relaxed during the return is the start of the next cycle.", relaxation),
]


def charts(results):
    """Yields (Entry, Chart) for every figure that the run has data for, or (Entry, text) for what it would need."""
    for entry in FIGURES:
        chart = entry.draw(results)
        if chart is not None:
            yield entry, chart if isinstance(chart, str) else with_coincidence_noted(chart)


def draw_all(results):
    """Yields (Entry, Figure of matplotlib) for every figure that the run has data for, or (Entry, text) for what it lacks."""
    from .drawing.draw_chart import draw  # a page needs no matplotlib

    for entry, chart in charts(results):
        yield entry, chart if isinstance(chart, str) else draw(chart)
