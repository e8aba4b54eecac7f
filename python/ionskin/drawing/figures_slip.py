# SPDX-License-Identifier: Apache-2.0
"""Figure 23: whether the currents tell a slip before it happens; and how the slide of one run begins."""

import numpy
from matplotlib.ticker import EngFormatter, NullFormatter

from ..analysis import slip
from ..words import quantity
from . import style
from .figures_contact import mirrored
from .figures_fields import fields_of
from .panels import STEP, peak_of, scaled, scaled_label

LOOKS = {"difference": (style.GREEN, "o"), "common": (style.PURPLE, "s")}
MAP = 2.35  # width of a map [inch]
BEHIND = 0.35  # of the time to full slip that is shown after it
NO_ONSET = "nothing sticks when the slide begins, or nothing slides"


def onset(results):
    """Figure of a run: where and when the contact slips, the stuck share, and the currents."""
    found = slip.onset(results)
    if found is None or fields_of(results) is None or not results.signals.has("stick_share"):
        return None
    with fields_of(results) as file:
        if "contact" not in file or not slip.onset_states(file):
            return None
        figure, maps, panels = layout(file)
        draw_maps(figure, maps, file, found)
    end = found.full if found.full is not None else float(results.phases()[-1].end)
    span = (end - found.begin) * (1 + BEHIND)
    divisor, label = scaled_label("time since the slide began", "s", span)
    stick_panel(panels[0], results, found, divisor)
    current_panels(panels[1:], results, found, divisor, span)
    for panel in panels:
        panel.set_xlim(-0.04 * span / divisor, span / divisor)
        mark(panel, found, divisor)
    for panel in panels[:-1]:
        panel.tick_params(labelbottom=False)
    panels[-1].set_xlabel(label)
    return figure


def layout(file):
    """A figure with two maps in the shape of the footprint above three panels over time."""
    x, (y, _) = file["contact/grid/x"][...], mirrored(file, slip.onset_states(file)[0]["slip_state"][...])
    tall = MAP * float(numpy.clip((y[-1] - y[0]) / (x[-1] - x[0]), 0.2, 1.0))
    height = tall + 3 * 1.15 + 1.95
    figure = style.canvas(height=height)
    top = 1 - 0.30 / height
    grid = figure.add_gridspec(1, 2, left=0.085, right=0.90, top=top, bottom=top - tall / height, wspace=0.55)
    maps = [figure.add_subplot(grid[0, column]) for column in (0, 1)]
    rows = figure.add_gridspec(3, 1, left=0.105, right=0.98, top=top - (tall + 0.80) / height, bottom=0.45 / height, hspace=0.30)
    first = figure.add_subplot(rows[0, 0])
    return figure, maps, [first, *(figure.add_subplot(rows[row, 0], sharex=first) for row in (1, 2))]


def draw_maps(figure, panels, file, found):
    """When each cell slips for good, with the front at four instants, and how far it has slipped at full slip."""
    x = file["contact/grid/x"][...] * 1e3
    y, times = mirrored(file, slip.release_times(file, found.begin))
    end = found.full if found.full is not None else found.begin + numpy.nanmax(times)
    way = mirrored(file, slip.slip_at(file, end))[1]
    for panel, values, name, unit, words in ((panels[0], times, "time", "s", "When it slips"),
                                             (panels[1], way, "slip", "m", "Slipped by full slip")):
        divisor, label = scaled_label(name, unit, peak_of(values))
        image = panel.pcolormesh(x, y * 1e3, values / divisor, cmap=style.SEQUENCE, vmin=0,
                                 vmax=peak_of(values) / divisor or 1, rasterized=True)
        bar = figure.colorbar(image, cax=panel.inset_axes((1.04, 0, 0.04, 1)))
        bar.set_label(label, fontsize=7)
        panel.set_aspect("equal")
        panel.grid(False)
        panel.set_xlabel("x from the slider's centre [mm]")
        style.title(panel, words)
    panels[0].set_ylabel("y [mm]")
    draw_fronts(panels[0], x, y * 1e3, times)


def draw_fronts(panel, x, y, times):
    """Lines between what sticks and what slips, at a fifth to four fifths of the last time."""
    if min(times.shape) < 2 or not peak_of(times):
        return
    levels = peak_of(times) * numpy.array([0.2, 0.4, 0.6, 0.8])
    panel.contour((x[1:] + x[:-1]) / 2, (y[1:] + y[:-1]) / 2, numpy.nan_to_num(times), levels=levels, colors="white",
                  linewidths=0.7)


def mark(panel, found, divisor):
    """Lines at the first micro-slip and at full slip."""
    panel.axvline((found.micro - found.begin) / divisor, color=style.QUIET, lw=0.8, ls=":")
    if found.full is not None:
        panel.axvline((found.full - found.begin) / divisor, color=style.QUIET, lw=0.8, ls="--")


def stick_panel(panel, results, found, divisor):
    """The stuck share with the names of both lines."""
    time = (results.signals["time"] - found.begin) / divisor
    panel.plot(time, results.signals["stick_share"], color=style.BLUE, marker="o", markersize=1.8)
    panel.set(ylabel="stuck share", ylim=(-0.03, 1.05))
    lines = [panel.plot([], [], color=style.QUIET, lw=0.8, ls=look)[0] for look in (":", "--")]
    names = ["first micro-slip", "full slip"]
    panel.legend(lines, names, loc="lower right", bbox_to_anchor=(1.0, 0.98), ncol=2, borderaxespad=0.1)
    style.title(panel, "Part of the contact that sticks")


def current_panels(panels, results, found, divisor, span):
    """Difference and common current, with three times the noise floor about the current at the first micro-slip."""
    signals = results.signals
    time = signals["time"] - found.begin
    shown = (time > 0) & (numpy.roll(time, 1) <= span)  # with the step that goes on beyond the end
    for panel, current in zip(panels, slip.CURRENTS):
        column = f"current_{current}"
        tells = slip.told(results, current)
        r = slip.value(results, f"precursor_correlation_{current}")
        if r is None:
            panel.text(0.5, 0.5, "no current above rounding", ha="center", va="center", transform=panel.transAxes,
                       color=style.QUIET, fontsize=7.5)
            panel.set_yticks([])
            style.title(panel, f"{current.capitalize()} current")
            continue
        unit = scaled(panel, "current", "A", peak_of(signals[column][shown]))
        panel.plot(time[shown] / divisor, signals[column][shown] / unit, color=LOOKS[current][0], lw=1.0, **STEP)
        value = float(numpy.interp(found.micro, signals["time"], signals[column]))
        if numpy.isfinite(tells.noise):
            panel.axhspan((value - slip.SEEN * tells.noise) / unit, (value + slip.SEEN * tells.noise) / unit,
                          color=style.PALE, alpha=0.5, lw=0)
        seen = "" if tells.departure > tells.noise else "; no reading before full slip shows it"
        style.title(panel, f"{current.capitalize()} current, correlation with the stuck share {r:.2f}{seen}")


def friction_window(study):
    """Figure 23: lead time and what the currents show before full slip, against the swept key."""
    told = {current: [slip.told(member.results, current) for member in study.members] for current in slip.CURRENTS}
    leads = numpy.array(study.metric("slip_lead_time"))
    if study.single:
        return "a single run has no window: sweep contact.friction"
    if not numpy.isfinite(leads).any():
        return NO_ONSET
    figure = style.canvas(height=2.9, left=0.105, right=0.975, top=0.90, bottom=0.17, wspace=0.36)
    axes = figure.subplots(1, 2)
    lead_panel(study, axes[0], leads, told)
    departure_panel(study, axes[1], told)
    for panel, unit in zip(axes, "sA"):
        panel.set_yscale("log")
        panel.yaxis.set_major_formatter(EngFormatter(unit))
        panel.yaxis.set_minor_formatter(NullFormatter())
        panel.set_xlabel(study.axis_label())
        shade_window(panel, study, told)
    style.title(axes[0], "Lead before full slip")
    style.title(axes[1], "Departure")
    axes[1].set_title(window_words(study, told), loc="right", pad=4, color=style.QUIET, fontsize=7.5)
    return figure


def lead_panel(study, panel, leads, told):
    """From the first micro-slip, and from where each current is seen, to full slip."""
    values = [member.value for member in study.members]
    line = "" if study.scattered else "-"
    errors = numpy.array([slip.error(member.results, "slip_lead_time") for member in study.members])
    panel.errorbar(values, leads, below(leads, errors), color=style.BLUE, marker="^", markersize=3.5, ls=line,
                   capsize=2, lw=0.9, label="micro-slip")
    for current, (colour, marker) in LOOKS.items():
        own = numpy.array([each.lead for each in told[current]])
        if numpy.isfinite(own).any():
            panel.plot(values, own, color=colour, marker=marker, markersize=3, ls=line and "--", lw=0.9,
                       markerfacecolor="white", label=current)
    interval = told["difference"][0].interval
    if numpy.isfinite(interval):
        panel.axhline(interval, color=style.INK, lw=0.8, ls=":", label="readout interval")
    panel.set_ylabel("lead")
    panel.legend(fontsize=6.5, loc="lower right", bbox_to_anchor=(1.0, 0.2), frameon=True, framealpha=0.85, facecolor="white", edgecolor="none")


def below(values, errors):
    """Bars of a logarithmic axis: downwards they end at a fifth of the value."""
    return numpy.array([numpy.minimum(errors, 0.8 * numpy.abs(values)), errors])


def departure_panel(study, panel, told):
    """The departure of each current with its stated error, and the noise floor."""
    values = [member.value for member in study.members]
    line = "" if study.scattered else "-"
    for current, (colour, marker) in LOOKS.items():
        own = numpy.array([each.departure for each in told[current]])
        noise = numpy.array([each.noise for each in told[current]])
        if not (own > noise).any():
            continue
        errors = numpy.array([each.error for each in told[current]])
        panel.errorbar(values, own, below(own, errors), color=colour, marker=marker, markersize=3.5, ls=line,
                       capsize=2, lw=0.9, label=current)
    floor = slip.SEEN * numpy.array([each.noise for each in told["difference"]])
    if numpy.isfinite(floor).any():
        panel.plot(values, floor, color=style.INK, lw=0.8, ls=":", label=f"{slip.SEEN} × noise floor")
    panel.set_ylabel("departure of a reading")
    panel.legend(fontsize=6.5, loc="lower right", bbox_to_anchor=(1.0, 0.1), frameon=True, framealpha=0.85, facecolor="white", edgecolor="none")


def inside(told):
    """Per member whether any current tells."""
    return [any(each.told for each in pair) for pair in zip(*told.values())]


def shade_window(panel, study, told):
    """Shades the values whose slip is told, half way to their neighbours."""
    if study.scattered:
        return
    values = numpy.array([member.value for member in study.members])
    middles = (values[1:] + values[:-1]) / 2
    edges = numpy.concatenate([values[:1], middles, values[-1:]])
    for low, high, tells in zip(edges, edges[1:], inside(told)):
        if tells:
            panel.axvspan(low, high, color=style.BAND_STRONG, lw=0, zorder=0)


def window_words(study, told):
    """The shaded values in words: "told at 0.1–0.3, 0.5"."""
    unit = study.unit if study.unit != "1" else ""
    runs = []
    for before, member, tells in zip([False, *inside(told)], study.members, inside(told)):
        if tells:
            words = quantity(member.value, unit, 3) if unit else f"{member.value:.3g}"
            runs = [*runs[:-1], (runs[-1][0], words)] if before else [*runs, (words, words)]
    texts = [first if first == last else f"{first}–{last}" for first, last in runs]
    return "told at " + ", ".join(texts) if texts else "no window"
