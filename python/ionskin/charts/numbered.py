# SPDX-License-Identifier: Apache-2.0
"""Numbered figures of a run or a sweep, for the page of a sweep and for files."""

from ..article import figures as article
from . import contact, design, ions, trends, typical
from .entry import Entry, no_fields, of_run

ENTRIES = [
    *article.ENTRIES,
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
