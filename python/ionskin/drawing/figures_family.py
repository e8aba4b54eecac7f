# SPDX-License-Identifier: Apache-2.0
"""Figures 5 to 10 and 16: the family of runs along the swept key."""

import numpy
from matplotlib.colors import SymLogNorm
from matplotlib.ticker import EngFormatter

from ..analysis import regimes
from ..charts.spans import peak_of, sampled_label, scaled_label
from ..words import short
from . import event_panels, style
from .panels import scaled, shade_phases

NO_CURRENT = "the runs have no currents"
NEEDS_SEVERAL = "it needs several runs of a sweep"
SEVERAL_KEYS = "several keys vary at once: fig21_scatter shows the points"
MAP_COLUMNS = 1500
MOST_MEMBERS = 24  # of a family in one figure
CURRENTS = [("top", style.BLUE, "o"), ("bottom", style.ORANGE, "s"), ("difference", style.GREEN, "^"),
            ("common", style.PURPLE, "D")]


def family_grid(study, row_height, columns):
    """One cell of panels per member: for every column the whole run and the first contact enlarged. Returns the figure and,
    per member, a list of event_panels.Row, whose vertical axes are common along each column."""
    shown = study.members[::-(-len(study.members) // MOST_MEMBERS)]
    beside = 2 if columns == 1 and len(shown) > 1 else 1  # members side by side
    lines = -(-len(shown) // beside)
    height = max(row_height, 1.6 / lines) * lines + 1.0
    figure = style.canvas(height=height, left=0.095, right=0.985, top=1 - 0.50 / height, bottom=0.42 / height, hspace=0.42,
                          wspace=0.10 if columns == 1 else 0.38)
    enlarged = event_panels.windows(study.typical.results)[:1]
    widths = ([1.5, 1.0] if enlarged else [1.0]) * columns * beside
    panels = figure.subplots(lines, len(widths), sharex=False, sharey=False, squeeze=False,
                             gridspec_kw={"width_ratios": widths})
    each = len(widths) // beside
    cells = [panels[i // beside, (i % beside) * each:(i % beside + 1) * each] for i in range(len(shown))]
    for panel in panels.ravel()[len(shown) * each:]:
        panel.set_visible(False)
    per_column = each // columns
    rows = [[event_panels.Row(cell[k * per_column:(k + 1) * per_column]) for k in range(columns)] for cell in cells]
    for i, (member, cell) in enumerate(zip(shown, rows)):
        for k, row in enumerate(cell):
            finish_row(member, row, enlarged, rows[0][k], last=i + beside >= len(shown))
            row.panels[0].tick_params(labelleft=i % beside == 0)
    return figure, list(zip(shown, rows))


def finish_row(member, row, enlarged, model, last):
    """Limits, common axes and labels of one member's panels."""
    time = member.results.signals["time"]
    whole, *rest = row.panels
    whole.set_xlim(time[0], time[-1])
    for panel, window in zip(rest, event_panels.windows(member.results) or enlarged):
        event_panels.enlarge(panel, window)
        panel.tick_params(labelleft=False)
    for panel in row.panels:
        shade_phases(member.results, panel)
        if panel is not model.panels[0]:
            panel.sharey(model.panels[0])
        panel.tick_params(labelbottom=last)
        panel.set_xlabel(("time [s]" if panel is whole else "ms from contact") if last else "")


def shear(study):
    """Figure 5: mean shear over time, one cell per member, common y axis."""
    if not study.typical.results.signals.has("mean_shear"):
        return "the runs have no shear"
    figure, cells = family_grid(study, 0.86, 1)
    peak = max(peak_of(member.results.signals["mean_shear"]) for member in study.members)
    divisor, label = scaled_label("mean shear γ", "1", peak)
    for member, (row,) in cells:
        signals = member.results.signals
        row.plot(signals["time"], signals["mean_shear"] / divisor, color=style.BLUE, lw=1.0)
        row.panels[0].set_title(short(study.panel_label(member), 36), loc="left", fontsize=7.5, pad=2)
    cells[0][1][0].set_ylim(min(0, *(1.08 * numpy.nanmin(member.results.signals["mean_shear"]) / divisor
                                     for member in study.members)), 1.08 * peak / divisor or 1)
    figure.supylabel(label, fontsize=8, x=0.005)
    return figure


def currents(study):
    """Figure 9: sampled currents over time, one line per member, common y axis per column."""
    if not study.typical.results.sampled.has("current_top"):
        return NO_CURRENT
    figure, cells = family_grid(study, 0.74, 2)
    columns = [peak_of(*(member.results.sampled[column] for member in study.members))
               for column in ("current_top", "current_difference")]
    (electrodes, label), (difference, difference_label) = (scaled_label("current", "A", peak) for peak in columns)
    for member, (left, right) in cells:
        sampled = member.results.sampled
        for name, colour in (("top", style.BLUE), ("bottom", style.ORANGE)):
            left.plot(sampled["time"], sampled[f"current_{name}"] / electrodes, color=colour, lw=0.8, label=name,
                      drawstyle="steps-pre", ls="-" if name == "top" else (0, (4, 1.5)))
        right.plot(sampled["time"], sampled["current_difference"] / difference, color=style.GREEN, lw=0.9,
                   drawstyle="steps-pre", label="difference (top − bottom)/2")
        left.panels[0].set_title(short(study.panel_label(member), 26), loc="left", fontsize=7, pad=2)
        for row, signal in ((left, "current_top"), (right, "current_difference")):
            row.panels[-1].set_title(f"resolved peak {significant(peak_of(member.results.signals[signal]))}", loc="right",
                                     fontsize=6, pad=2, color=style.QUIET)
    for row, peak, divisor in zip(cells[0][1], columns, (electrodes, difference)):
        row.set_ylim(-1.1 * peak / divisor or -1, 1.1 * peak / divisor or 1)
    height = figure.get_figheight()
    for row, x, words in zip(cells[0][1], (0.095, 0.56), (label, difference_label)):
        handles, names = row.panels[0].get_legend_handles_labels()
        figure.legend(handles, [f"{name}" for name in names], loc="upper left", bbox_to_anchor=(x, 1 - 0.02 / height), ncol=2,
                      fontsize=7, title=f"{words}, {sampled_label(study.typical.results)}", title_fontsize=7,
                      alignment="left", borderaxespad=0.0)
    return figure


def value_edges(values):
    """Edges of cells around ascending values."""
    values = numpy.asarray(values)
    middle = (values[1:] + values[:-1]) / 2
    return numpy.concatenate([[values[0] - (middle[0] - values[0])], middle, [values[-1] + (values[-1] - middle[-1])]])


def time_grid(study):
    """Edges and centres of the columns of a map over the run."""
    time = study.typical.results.signals["time"]
    edges = numpy.linspace(time[0], time[-1], MAP_COLUMNS + 1)
    return edges, (edges[1:] + edges[:-1]) / 2


def shear_map(study):
    """Figure 6: mean shear over time and the swept key."""
    if study.single:
        return NEEDS_SEVERAL
    if study.scattered:
        return SEVERAL_KEYS
    edges, centres = time_grid(study)
    rows = numpy.array([member.results.signals.at("mean_shear", centres) for member in study.members])
    figure, axes = style.stacked(1, heights=[1.5], left=0.09)
    figure.subplots_adjust(right=0.945)
    image = axes[0].pcolormesh(edges, value_edges([member.value for member in study.members]), rows * 1e3,
                               cmap=style.SEQUENCE, vmin=0, rasterized=True)
    axes[0].set(xlabel="time [s]", ylabel=study.axis_label())
    axes[0].grid(False)
    style.title(axes[0], "Mean shear γ of the core")
    figure.colorbar(image, ax=axes[0], pad=0.015, fraction=0.05).set_label("γ [10⁻³]")
    return figure


def current_map(study):
    """Figure 10: sampled currents over time and the swept key, on a symmetric logarithmic scale."""
    if study.single:
        return NEEDS_SEVERAL
    if study.scattered:
        return SEVERAL_KEYS
    if not study.typical.results.sampled.has("current_top"):
        return NO_CURRENT
    figure, axes = style.stacked(3, heights=[0.85] * 3, left=0.09)
    figure.subplots_adjust(hspace=0.3, right=0.955)
    edges = value_edges([member.value for member in study.members])
    for panel, (name, words) in zip(axes, (("top", "Top electrode"), ("bottom", "Bottom electrode"),
                                           ("difference", "Difference (top − bottom)/2"))):
        column = f"current_{name}"
        time = study.typical.results.sampled["time"]
        starts = numpy.concatenate([[study.typical.results.signals["time"][0]], time])
        rows = numpy.array([member.results.sampled[column][:len(time)] for member in study.members])
        peak = peak_of(rows) or 1e-12  # a scale for runs without any current
        norm = SymLogNorm(linthresh=peak * 1e-3, vmin=-peak, vmax=peak)
        image = panel.pcolormesh(starts, edges, rows, cmap=style.DIVERGING, norm=norm, rasterized=True)
        panel.set_ylabel(study.axis_label() if panel is axes[1] else "")
        panel.grid(False)
        style.title(panel, f"{words}, {sampled_label(study.typical.results)}")
        ticks = [-peak, -peak / 30, 0, peak / 30, peak]
        bar = figure.colorbar(image, ax=panel, pad=0.015, fraction=0.05, ticks=ticks)
        bar.ax.set_yticklabels([significant(tick) for tick in ticks], fontsize=6.5)
        bar.ax.minorticks_off()
    axes[-1].set_xlabel("time [s]")
    return figure


def significant(current):
    """A current with two digits and a prefix: "-41 mA"."""
    divisor, prefix = style.si_scale(abs(current))
    value = current / divisor
    return f"{value:.0f} {prefix}A" if abs(value) >= 10 else f"{value:.2g} {prefix}A" if current else "0"


def plot_metric(study, panel, name, divisor, **look):
    """A metric against the swept key, with error bars where an error is estimated."""
    values = numpy.array(study.metric(name)) / divisor
    errors = numpy.nan_to_num(numpy.array(study.errors(name)) * numpy.abs(values))
    panel.errorbar([member.value for member in study.members], values, yerr=errors if errors.any() else None,
                   capsize=2, lw=1.0, **{**look, **({"ls": ""} if study.scattered else {})})


def mark_regimes(study, panel, name, divisor):
    """The regimes found in the data: the two power laws, their exponents and the place of the break."""
    if study.scattered:
        return
    fit = regimes.fit([member.value for member in study.members], study.metric(name))
    if fit is None:
        return
    x = numpy.geomspace(fit.values[0], fit.values[-1], 200)
    panel.plot(x, fit(x) / divisor, color=style.INK, lw=0.8, ls=(0, (1, 1.2)), zorder=5)
    if fit.two:
        panel.axvline(fit.break_at, color=style.QUIET, lw=0.7, ls="--")
        panel.text(0.98, 0.04, f"below {study.label(study.members[0]).split(' = ', maxsplit=1)[0]} = "
                   f"{fit.break_at:.2g}: exponent {fit.low:.2f} ± {fit.low_error:.2f}\nabove: "
                   f"{fit.high:.2f} ± {fit.high_error:.2f}", transform=panel.transAxes, ha="right", va="bottom",
                   fontsize=7, bbox=style.BEHIND_TEXT)
    else:
        panel.text(0.98, 0.04, f"one power law: exponent {fit.low:.2f} ± {fit.low_error:.2f}",
                   transform=panel.transAxes, ha="right", va="bottom", fontsize=7, bbox=style.BEHIND_TEXT)


def current_panel(study, panel, prefix, name_of, title):
    """Peaks or rms of the currents against the swept key on a logarithmic axis; nothing without currents."""
    if not numpy.isfinite(study.metric(name_of.format("top"))).any():
        panel.set_visible(False)
        return
    for name, colour, marker in CURRENTS:
        metric = name_of.format(name)
        if numpy.isfinite(study.metric(metric)).any():
            plot_metric(study, panel, metric, 1.0, color=colour, marker=marker, markersize=3.5,
                        label=f"{name}{prefix[0]}")
        sampled = f"peak_sampled_current_{name}"
        if prefix[1] and numpy.isfinite(study.metric(sampled)).any():
            plot_metric(study, panel, sampled, 1.0, color=colour, marker=marker, markersize=3.5, ls="--",
                        markerfacecolor="white", label=f"{name}{prefix[1]}")
    panel.set_yscale("log")
    panel.yaxis.set_major_formatter(EngFormatter("A"))
    panel.set_xlabel(study.axis_label())
    style.title(panel, title)
    panel.legend(fontsize=6.3, loc="upper left", bbox_to_anchor=(1.0, 1.02), handlelength=2.6)


def shear_panel(study, metric, label, title):
    """A metric of the shear against the swept key; the figure and its second panel, with room for a legend on the right."""
    figure = style.canvas(height=2.75, left=0.085, right=0.80, top=0.91, bottom=0.16, wspace=0.34)
    panel, free = figure.subplots(1, 2)
    divisor = scaled(panel, label, "1", peak_of(study.metric(metric)))
    plot_metric(study, panel, metric, divisor, color=style.BLUE, marker="o", markersize=3.5)
    upper = numpy.array(study.metric(metric)) * (1 + numpy.nan_to_num(numpy.array(study.errors(metric))))
    panel.set_ylim(0, 1.08 * peak_of(upper) / divisor or 1)
    panel.set_xlabel(study.axis_label())
    mark_regimes(study, panel, metric, divisor)
    style.title(panel, title)
    return figure, free


def peaks(study):
    """Figure 7: peak shear and peak currents against the swept key."""
    figure, panel = shear_panel(study, "peak_mean_shear", "peak mean shear γ", "Peak shear")
    current_panel(study, panel, (", resolved", ", sampled"), "peak_current_{}", "Peak current")
    return figure


def means(study):
    """Figure 8: mean shear and rms currents against the swept key."""
    figure, panel = shear_panel(study, "time_mean_shear", "time mean of γ", "Time mean of the mean shear")
    current_panel(study, panel, ("", ""), "rms_current_{}", "Rms current, resolved")
    return figure


def correlation(study):
    """Figure 16: peak current against peak shear."""
    if study.single:
        return NEEDS_SEVERAL
    if not numpy.isfinite(study.metric("peak_current_top")).any():
        return NO_CURRENT
    figure = style.canvas(height=2.75, left=0.085, right=0.87, top=0.90, bottom=0.16, wspace=0.42)
    axes = figure.subplots(1, 3)
    shear_peaks = numpy.array(study.metric("peak_mean_shear")) * 1e3
    values = [member.value for member in study.members]
    points = None
    for panel, (metric, words) in zip(axes, (("peak_current_top", "top, resolved"),
                                             ("peak_sampled_current_top", "top, sampled"),
                                             ("peak_sampled_current_difference", "difference, sampled"))):
        current = numpy.array(study.metric(metric))
        divisor = scaled(panel, "peak current", "A", peak_of(current))
        if not study.scattered:
            panel.plot(shear_peaks, current / divisor, color=style.PALE, lw=0.9, zorder=1)
        points = panel.scatter(shear_peaks, current / divisor, c=values, cmap=style.SEQUENCE, s=18, zorder=2,
                               edgecolor=style.INK, linewidth=0.3)
        panel.set_xlabel("peak mean shear γ [10⁻³]")
        panel.set_ylim(0, 1.25 * peak_of(current) / divisor)
        panel.set_xlim(left=0)
        with numpy.errstate(invalid="ignore"):
            r = numpy.corrcoef(shear_peaks, current)[0, 1]
        panel.text(0.04, 0.97, f"r = {r:.3f}", transform=panel.transAxes, va="top", fontsize=7.5)
        style.title(panel, words)
    place = figure.add_axes((0.895, 0.16, 0.015, 0.74))
    figure.colorbar(points, cax=place).set_label(study.axis_label())
    return figure
