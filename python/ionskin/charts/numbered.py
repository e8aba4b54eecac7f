# SPDX-License-Identifier: Apache-2.0
"""The numbered figures of a run or a sweep: the page of a sweep draws them, and files are made of them."""

from typing import Callable, NamedTuple

from .. import figures
from . import contact, design, family, fields, ions, sketches, skin, trends, typical
from .chart import telling_coincidence



class Entry(NamedTuple):
    """One numbered figure; `build` takes a Study and returns a Chart, or the reason for none."""

    name: str
    heading: str
    caption: str
    build: Callable

    @property
    def number(self):
        """Number by which papers cite the figure: 7 of "fig07_peaks"."""
        return int(self.name[3:5])

    def chart(self, study):
        """The Chart, or the reason for none."""
        chart = self.build(study)
        return chart if isinstance(chart, str) else telling_coincidence(chart)


def of_run(build, lacks, named=True):
    """A figure of the typical run from its Chart. lacks: words for its absence, of the Results; named: says which run it is"""
    def drawn(study):
        results = study.typical.results
        chart = build(results)
        if chart is None or isinstance(chart, str):
            return chart or lacks(results)
        member = "" if study.single or not named else f"{study.label(study.typical)}."
        return chart._replace(note=f"{member} {chart.note}".strip())

    return drawn


def no_slider(_):
    """Reason why a run has no figure of its slider."""
    return sketches.NO_CONTACT


def no_fields(results):
    """Reason why a run has no figure of the contents of results.h5."""
    return fields.NO_CONTACT if (results.folder / "results.h5").exists() else fields.NO_FIELDS


ENTRIES = [
    Entry("fig01_model", "The model", "Skin and slider before touchdown.", of_run(skin.model, no_slider, named=False)),
    Entry("fig02_layers", "The layers", "Section through the skin, not to scale, with what holds on its faces.",
          sketches.layers),
    Entry("fig03_stages", "The stages of a cycle", "Dotted: where a stage begins; heights are not to scale.",
          sketches.stages),
    Entry("fig04_motion", "Input motion", "Prescribed position and height of the slider. Bands: pale where slider and "
          "skin touch, darker while it slides.", of_run(figures.motion, no_slider)),
    Entry("fig05_shear", "Shear over time", "Volume mean of γ over the core; right: where the first contact begins and ends.",
          family.shear),
    Entry("fig06_shear_map", "Shear over time and the swept key", "Volume mean of γ over the core.",
          family.shear_map),
    Entry("fig07_peaks", "Peaks", "Peak of the mean shear, with power laws where a sweep along one key shows them, and peaks of the currents: "
          "resolved peaks are set by how short the contact events are, sampled ones are what an integrating instrument sees.",
          trends.peaks),
    Entry("fig08_means", "Means", "Time mean of the mean shear, with power laws where a sweep along one key shows them, and rms of the "
          "resolved currents over the run.", trends.means),
    Entry("fig09_current", "Currents over time", "Sampled currents of both electrodes and their difference, the whole run and "
          "enlarged at the first contact. The peaks are the largest of the whole run.", family.currents),
    Entry("fig10_current_map", "Currents over time and the swept key", "Sampled; the colour scale is linear within a "
          "thousandth of the peak and logarithmic beyond.", family.current_map),
    Entry("fig11_rate", "Current and the rate of the shear", "Sampled current (solid) and the rate of the mean shear over the "
          "same intervals (dashed), each divided by its largest magnitude, with their correlation r.", typical.rate),
    Entry("fig12_current_motion", "Current with the motion", "Sampled currents below the prescribed motion.",
          typical.current_motion),
    Entry("fig13_cycle", "One cycle", "Motion, mean shear and currents of the first cycle.", typical.cycle),
    Entry("fig14_phases", "Phases on the current", "Boundaries of the phases of the first cycle on the sampled current.",
          typical.phases),
    Entry("fig15_normalised", "Normalised", "Travel, mean shear and sampled current, each divided by its largest magnitude.",
          typical.normalised),
    Entry("fig16_correlation", "Peak current against peak shear", "One mark per run; r is Pearson's coefficient.",
          trends.correlation),
    Entry("fig17_stick_slip", "Stick and slip", "Stuck part of the contact area during the onset of sliding.",
          trends.stick_slip),
    Entry("fig18_contact_maps", "Contact and shear maps", "In the slider's frame, seen from above. Under sharp edges the peaks "
          "depend on the mesh: there the colour scales end where 95 % of the area (tractions) and 99 % of the section (shear, "
          "at mid-width) lie below.", of_run(contact.contact_maps, no_fields)),
    Entry("fig19_ions", "Ions through the thickness", "Concentration and potential in one column at the instants of "
          "output.fields; the outer panels enlarge the double layers.", of_run(ions.ions, no_fields)),
    Entry("fig20_charge", "Charge per phase", "Charge gained by each electrode in each phase; dotted: what the shear "
          "predicts for the sum.", typical.charge),
    Entry("fig21_scatter", "Metrics against the sampled keys", "One mark per point of the sweep; all keys vary at once.",
          design.scatter),
    Entry("fig22_sensitivity", "Sensitivity", "Left: rank correlation (Spearman) of a metric with a key, from -1 to 1. Right: "
          "the share of the metric's variance that a parabola in this key alone explains, an estimate of the first-order "
          "index; what the shares of a row lack to 1 is due to interplay of keys, or to a course that no parabola follows.",
          design.sensitivity),
    Entry("fig23_friction_window", "The window in which a slip is recognised before it happens", "Left: from the first micro-slip, and "
          "from where a current departs by three times the noise floor, to full slip. Right: how far a reading of each current "
          "departs in that time. Shaded: a reading falls between for certain, and stands above noise floor and stated error.",
          trends.friction_window),
]


def charts(study, only=()):
    """Yields (Entry, Chart or reason) for every figure, or for those named."""
    for entry in ENTRIES:
        if not only or entry.name in only:
            yield entry, entry.chart(study)


def known_names():
    """Names of all figures, for messages."""
    return [entry.name for entry in ENTRIES]
