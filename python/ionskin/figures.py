# SPDX-License-Identifier: Apache-2.0
"""The figures of one run. Each function takes Results and returns a Figure, None without its data, or in words what the
run would need for it."""

from typing import Callable, NamedTuple

from .analysis import derived
from .drawing import figures_contact, figures_fields, figures_model, figures_readout, figures_slip, figures_water, style
from .drawing.panels import (STEP, error_band, first_cycle_names, motion_panels, name_phases, peak_of, rows_within,
                             sampled_label, scaled, shade_phases, signed_log_axis, slide_start, time_axis)
from .page import report_text
from .sweep_results import Study


def motion(results):
    """Prescribed position of the slider and its phases."""
    if not results.signals.has("slider_x", "slider_z"):
        return None
    figure, axes = motion_panels(results, 0.7, (style.BLUE, style.BLUE))
    style.title(axes[0], "Centre of the slider along the skin")
    style.title(axes[1], "Underside of the slider above the undeformed skin")
    first_cycle_names(results, axes[0])
    return figure


def shear(results):
    """Shear of the core: mean, spread and first moment over the thickness."""
    signals = results.signals
    if not signals.has("mean_shear"):
        return None
    time = signals["time"]
    figure, axes = style.stacked(3, heights=[0.8, 0.8, 0.8])
    mean_unit = scaled(axes[0], "mean shear", "1", peak_of(signals["mean_shear"]))
    axes[0].plot(time, signals["mean_shear"] / mean_unit, color=style.BLUE)
    predicts = report_text.law(results) == "fixed-charge"
    style.title(axes[0], "Volume mean" + ": predicts the common charge" * predicts)
    spread = scaled(axes[1], "shear", "1", peak_of(signals["p99_shear"], signals["rms_shear"]))
    axes[1].plot(time, signals["p99_shear"] / spread, color=style.ORANGE, label="99th percentile by volume")
    axes[1].plot(time, signals["rms_shear"] / spread, color=style.GREEN, label="rms")
    style.title(axes[1], "Spread over the core")
    style.legend(axes[1])
    moment = scaled(axes[2], "first moment", "1", peak_of(signals["shear_first_moment"]))
    axes[2].plot(time, signals["shear_first_moment"] / moment, color=style.PURPLE)
    moves_water = report_text.law(results) == "poroelastic"
    style.title(axes[2], "Mean of γ (ζ/h − ½)" + ": predicts the jumps of the difference charge" * (not moves_water))
    time_axis(results, axes)
    return figure


def forces(results):
    """Normal and tangential force on the full skin."""
    signals = results.signals
    if not signals.has("normal_force"):
        return None
    figure, axes = style.stacked(1)
    unit = scaled(axes[0], "force", "N", peak_of(signals["normal_force"]))
    axes[0].plot(signals["time"], signals["normal_force"] / unit, color=style.BLUE, label="normal")
    axes[0].plot(signals["time"], signals["tangential_force"] / unit, color=style.ORANGE, label="tangential")
    style.title(axes[0], "Force on the full skin")
    style.legend(axes[0])
    time_axis(results, axes)
    return figure


def currents(results):
    """Currents of both electrodes, and what an ammeter between them can carry."""
    signals, sampled = results.signals, results.sampled
    if not signals.has("current_top"):
        return None
    time = signals["time"]
    figure, axes = style.stacked(3, heights=[1.1, 1.1, 1.1], left=0.125)
    axes[0].plot(time, signals["current_top"], color=style.BLUE, label="top", **STEP)
    axes[0].plot(time, signals["current_bottom"], color=style.ORANGE, label="bottom", lw=0.8, **STEP)
    signed_log_axis(axes[0], "A", peak_of(signals["current_top"], signals["current_bottom"]))
    style.title(axes[0], "Electrodes, resolved")
    for panel, name, colour in ((axes[1], "difference", style.GREEN), (axes[2], "common", style.PURPLE)):
        column = f"current_{name}"
        # Wide and pale below the resolved current, which it equals wherever nothing is fast.
        error_band(panel, results, "sampled", column, 1.0, colour)
        panel.plot(sampled["time"], sampled[column], color=style.PALE, lw=2.6, label=sampled_label(results), **STEP)
        panel.plot(time, signals[column], color=colour, lw=0.8, label="resolved", **STEP)
        signed_log_axis(panel, "A", peak_of(signals[column]))
    style.title(axes[1], "Difference (top − bottom)/2")
    noise = ": not above the noise of the solver" if derived.common_is_noise(results) else ""
    style.title(axes[2], f"Common (top + bottom)/2{noise}")
    for panel in axes:
        panel.set_ylabel("current")
    for panel in axes[:2] if noise else axes:  # its title needs the room
        style.legend(panel)
    time_axis(results, axes)
    return figure


def charge(results):
    """Charge on the metal of both electrodes."""
    signals = results.signals
    if not signals.has("charge_top"):
        return None
    time, top, bottom = (signals[name] for name in ("time", "charge_top", "charge_bottom"))
    figure, axes = style.stacked(2, heights=[0.9, 0.9])
    unit = scaled(axes[0], "charge", "C", peak_of(top, bottom))
    axes[0].plot(time, top / unit, color=style.BLUE, label="top")
    axes[0].plot(time, bottom / unit, color=style.ORANGE, label="bottom")
    style.title(axes[0], "Charge on the electrodes")
    half = (top - bottom) / 2
    half_unit = scaled(axes[1], "charge", "C", peak_of(half))
    axes[1].plot(time, half / half_unit, color=style.GREEN)
    style.title(axes[1], "Difference (top − bottom)/2")
    style.legend(axes[0])
    time_axis(results, axes)
    return figure


def join_time(results):
    """Instant at which the onset joins steady sliding in the first cycle [s], or None."""
    if not (results.folder / "results.h5").exists():
        return None
    with results.open_fields() as file:
        value = float(file["path"].attrs.get("join_time", 0.0)) if "path" in file else 0.0
    start = slide_start(results)
    return value if start is not None and value > start else None


def join(results):
    """The difference current where the onset of sliding joins steady sliding: it must not jump."""
    signals = results.signals
    start, joined = slide_start(results), join_time(results)
    if joined is None or not signals.has("current_difference"):
        return None
    time = (signals["time"] - start) * 1e3
    width = (joined - start) * 1e3
    figure, axes = style.stacked(2, share_x=False)
    for panel, low, high in ((axes[0], 0.0, 4 * width), (axes[1], 0.5 * width, 2 * width)):
        shown = (time > low) & (time <= high)
        values = signals["current_difference"][shown]
        unit = scaled(panel, "difference current", "A", peak_of(values))
        panel.plot(time[shown], values / unit, color=style.GREEN, marker="o", markersize=2, **STEP)
        panel.axvline(width, color=style.QUIET, lw=0.8, ls="--")
        panel.set_xlim(low, high)
        panel.set_xlabel("time since the start of the slide [ms]")
    axes[0].annotate("steady sliding begins", (width, 0.97), xycoords=axes[0].get_xaxis_transform(), xytext=(4, 0),
                     textcoords="offset points", va="top", fontsize=7.5, color=style.QUIET)
    style.title(axes[0], "Onset of sliding, first cycle")
    style.title(axes[1], "The join, enlarged")
    figure.subplots_adjust(hspace=0.5)
    return figure


def relaxation(results):
    """How much of the difference charge is left when the next cycle begins."""
    signals = results.signals
    spans = results.phases()
    if not spans or not signals.has("charge_top"):
        return None
    half = (signals["charge_top"] - signals["charge_bottom"]) / 2
    figure, axes = style.stacked(2, share_x=False, heights=[1.0, 0.9])
    charge_unit = scaled(axes[0], "difference charge", "C", peak_of(half))
    returns = [span for span in spans if span.phase == "return"]
    tails = [signals["current_difference"][rows_within(signals, span)] for span in returns]
    current_unit = scaled(axes[1], "difference current", "A", peak_of(*tails))
    for cycle, look in cycle_looks(spans):
        own = [span for span in spans if span.cycle == cycle]
        begin = own[0].start
        rows = (signals["time"] >= begin) & (signals["time"] <= own[-1].end)
        axes[0].plot(signals["time"][rows] - begin, half[rows] / charge_unit, label=f"cycle {cycle}", **look)
    for span, tail, (cycle, look) in zip(returns, tails, cycle_looks(returns)):
        axes[1].plot(signals["time"][rows_within(signals, span)] - span.start, tail / current_unit,
                     label=f"cycle {cycle}", **look)
        axes[1].set_xlim(0, span.end - span.start)
    first = [span for span in spans if span.cycle == spans[0].cycle]
    shade_phases(results, axes[0], first[0].start, first[0].cycle)
    name_phases(results, axes[0], first[0].start, first[0].cycle)
    axes[0].set_xlim(0, first[-1].end - first[0].start)
    axes[0].set_xlabel("time within the cycle [s]")
    axes[0].set_title("Difference charge", loc="left", pad=13, fontweight="bold")
    axes[0].legend(loc="lower right", bbox_to_anchor=(1.0, 1.07), ncol=4, borderaxespad=0.1)
    axes[1].set_xlabel("time since the end of lift-off [s]")
    style.title(axes[1], "Difference current during the detached return")
    height = figure.get_figheight()
    figure.subplots_adjust(hspace=0.5, top=1 - 0.36 / height)
    return figure


def cycle_looks(spans):
    """Pairs of cycle and line look, in order; later cycles are dashed, as they may coincide."""
    cycles = sorted({span.cycle for span in spans})
    colours = [style.BLUE, style.ORANGE, style.GREEN, style.PURPLE]
    dashes = ["-", (0, (5, 2)), (0, (1.5, 1.5))]
    return [(cycle, {"color": colours[i % 4], "ls": dashes[min(i, 2)]}) for i, cycle in enumerate(cycles)]


class Entry(NamedTuple):
    """One figure of the report."""

    name: str
    heading: str
    caption: str | Callable  # of the results, where it follows the case
    draw: Callable

    def words(self, results):
        """The caption."""
        return self.caption(results) if callable(self.caption) else self.caption


def of_run(draw):
    """A numbered figure as one of a run, whose reasons for its absence are plain there."""
    def drawn(results):
        figure = draw(Study(results.folder, results))
        return None if isinstance(figure, str) else figure

    return drawn


def ions(results):
    """Concentration and potential through the core."""
    figure = figures_fields.ions(Study(results.folder, results)) if results.signals.has("current_top") else None
    return figure if figure != figures_fields.NO_FIELDS else None


FIGURES = [
    Entry("model", "Skin and slider", "Before touchdown.", of_run(figures_model.model)),
    Entry("motion", "Motion", "Prescribed motion of the slider. Bands, here and below: pale where slider and skin touch, darker "
          "while it slides.", motion),
    Entry("contact", "Contact", report_text.contact_caption, of_run(figures_contact.contact_maps)),
    Entry("slip", "How the slide begins", "Above, in the slider's frame: when each place slips for good, with the front between what "
          "sticks and what slips at a fifth to four fifths of that time in white, and how far the slider has slipped over it. Below: "
          "the stuck share and the currents; grey about a current: three times the noise floor of a reading.", figures_slip.onset),
    Entry("shear", "Shear of the core", report_text.shear_caption, shear),
    Entry("currents", "Electrode currents", "Currents on a symmetric logarithmic axis, linear around zero. A resolved "
          "current is the mean over one time step: its spikes are as high as the events are short. The sampled current "
          "is the charge gained over each readout interval divided by it, which an integrating instrument sees.",
          currents),
    Entry("circuit", "Readout circuit", "The top electrode's potential against the bottom one's, or what the amplifier reads; "
          "circuit.csv holds the numbers.", figures_readout.circuit),
    Entry("water_voltage", "What the water drives", "Voltage that the open cell would have at once, whatever the circuit of the "
          "run: water drags cations (streaming) and thins them where it gathers (dilution). water.csv holds the numbers.",
          figures_water.voltage),
    Entry("water_section", "Water in the core", "Section along the skin at mid-width at instants of output.fields; each panel "
          "has its own colours.", figures_water.section),
    Entry("water_walls", "Pressure between the walls", "Water pressure at the top wall minus that at the bottom one, from above: "
          "its mean is what the whole electrode sees, its map what taxels see.", figures_water.wall_difference),
    Entry("taxel_map", "Taxels", "The skin from above: largest magnitude of each taxel's charge during the run.",
          figures_readout.taxel_map),
    Entry("taxels", "Taxel signals", "Charge of each taxel over time on common axes; taxels.csv holds the currents too.",
          figures_readout.taxel_charges),
    Entry("ions", "Ions through the thickness", "Concentration and potential in one column of the core at the instants of "
          "output.fields; the outer panels enlarge the double layers.", ions),
    Entry("forces", "Forces", "Contact forces; under full slip the tangential force is the friction coefficient times "
          "the normal force.", forces),
    Entry("charge", "Electrode charge", report_text.charge_caption, charge),
    Entry("join", "From the onset to steady sliding", "Difference current, one mark per time step. A jump of the shear "
          "between the two parts of the contact path would show as a spike at the dashed line.", join),
    Entry("relaxation", "Relaxation between cycles", "The contact repeats exactly, the ions do not: what has not "
          "relaxed during the return is the start of the next cycle.", relaxation),
]


def draw_all(results):
    """Yields (Entry, Figure) for every figure that the run has data for, or (Entry, text) for what it would need."""
    for entry in FIGURES:
        figure = entry.draw(results)
        if figure is not None:
            yield entry, figure
