# SPDX-License-Identifier: Apache-2.0
"""The article's figures, 1 to 16, with their captions, of any run or sweep."""

from .. import figures
from ..charts import family, sketches, skin, trends, typical
from ..charts.entry import Entry, no_slider, of_run

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
]
