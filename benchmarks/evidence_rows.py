# SPDX-License-Identifier: Apache-2.0
"""Measurements, and what ionskin says of them: the rows of the page "Model against measurement".

No constant is chosen by the signal. One without a source is varied over its range. A number that was not read in its source is
marked `from memory`. A row is `agrees` or `disagrees` by a rule that stands in the row; what cannot be computed, or has
no number that could be read, is `cannot be had`, with the reason.
"""

import dataclasses
import math

import numpy

from evidence_runs import amplitude

ZHU = "Zhu et al. 2016, doi 10.1063/1.4961732 (abstract)"
CHEN = "Chen et al. 2001, doi 10.1016/S0021-9290(00)00170-6; Reynaud and Quinn 2006, doi 10.1529/biophysj.106.082263 (abstracts)"
STACK = "bending sensor of stacked Nafion, Macromol. Res. 25, 1205 (2017) (abstract)"
YIN = "Yin et al. 2026, doi 10.3390/s26020394"
GEL = "Dobashi et al. 2022, doi 10.1126/science.aaw1974"
# Molecules of water for each cation: H+ by Ise et al. 1999; the others from memory of Xie and Okada 1995 and 1996.
DRAG = {"Li+": 15, "Na+": 9.5, "K+": 5, "H+": 2.6}
# No source was read.
DRAINED_RATIOS = (0.35, 0.4, 0.45)


@dataclasses.dataclass
class Row:
    """One comparison. Numbers in the unit; `low` and `high` bound what unsure constants make of `value`."""

    name: str
    source: str
    measured: str
    case: str
    computed: str
    verdict: str
    remark: str = ""
    unit: str = ""
    value: float = math.nan
    low: float = math.nan
    high: float = math.nan
    measured_low: float = math.nan
    measured_high: float = math.nan


def verdict_of(agrees):
    return "agrees" if agrees else "disagrees"


def microvolts(values, digits=3):
    return ", ".join(f"{1e6 * value:.{digits}g}" for value in values) + " uV"


def cations(runs):
    """Peak voltage of a bent strip in four cations."""
    peaks = {ion: runs("bent_strip", water__drag_number=drag).values["peak_voltage"] for ion, drag in DRAG.items()}
    agrees = peaks["Li+"] > peaks["Na+"] > peaks["K+"] > peaks["H+"]
    yield Row("Order of the cations", ZHU, "amplitudes Li+ > Na+ > K+ > H+", "bent_strip",
              ", ".join(f"{ion} {1e6 * peak:.3g} uV" for ion, peak in peaks.items()), verdict_of(agrees),
              "The order is that of the drag numbers, of which three are from memory; all other constants are those of H+.")


def held_bend(runs):
    """A bend that is held: peak, decay, and the sign of what stays."""
    shares, signs = [], []
    for ratio in DRAINED_RATIOS:
        _, voltage = runs("bent_strip", water__drained_poissons_ratio=ratio).voltage()
        shares.append(voltage[-1] / voltage.max())
        signs.append(voltage[-1] > 0)
    span = f"{100 * min(shares):.2g} to {100 * max(shares):.2g} % of the peak stay, for drained Poisson's ratios of 0.45 to 0.35"
    _, relaxed = runs("bent_strip", materials__nafion_wet__relaxation_times='["1 s"]',
                      materials__nafion_wet__relaxation_shares="[0.5]").voltage()
    yield Row("A held bend decays", ZHU, "a peak, then a slow decay to a steady value", "bent_strip", span,
              verdict_of(min(shares) < 0.9),
              "No source gives that ratio. Below about 0.35 nothing decays, so that the measurement bounds it. If half of the shear "
              f"modulus goes with a time of 1 s, {100 * relaxed[-1] / relaxed.max():.2g} % stay at a ratio of 0.4 instead of "
              f"{100 * shares[DRAINED_RATIOS.index(0.4)]:.2g}: the polymer must be measured apart.")
    yield Row("Its steady voltage in wet H+", ZHU, "negative near saturation", "bent_strip",
              "of the sign of the peak for every drained Poisson's ratio" if all(signs) else "negative",
              verdict_of(not any(signs)),
              "Streaming and dilution have one sign in bending, and a polymer that relaxes makes both smaller, not negative. Something "
              "that the law has not got drives the ions back.")


def swinging_bend(runs):
    """Amplitude of a swinging bend over frequency, in water and in drier air."""
    frequencies = (0.1, 1.0, 10.0)

    def sweep(case="bent_strip", **edits):
        result = []
        for frequency in frequencies:
            run = runs(case, strain__waveform="sine", strain__frequency=f"{frequency} Hz",
                       strain__duration=f"{5 / frequency} s", readout__sample_interval=f"{0.02 / frequency} s", **edits)
            name, column = ("signals", "current_difference") if "readout__circuit" in edits else ("circuit", "voltage")
            table = run.table(name)
            result.append(amplitude(table["time"], table[column], frequency))
        return result

    wet = sweep()
    yield Row("Voltage over frequency, 90 % humidity", ZHU, "rises from 0.1 to 10 Hz", "bent_strip",
              f"{microvolts(wet)} at 0.1, 1, 10 Hz", verdict_of(wet[0] < wet[1] < wet[2]))
    dry = sweep("bent_strip_air", skin__humidity=0.5)
    flat = f"{microvolts(dry)} at 0.1, 1, 10 Hz with the constants at 50 % humidity"
    yield Row("The same, 50 % humidity", ZHU, "rises, then falls", "bent_strip_air", flat,
              verdict_of(dry[0] < 0.97 * dry[1] and dry[2] < 0.97 * dry[1]),
              f"Drier Nafion is stiffer and drags less: {dry[1] / wet[1]:.2g} times the voltage of soaked H+ at 1 Hz. Dilution exceeds "
              "streaming there, and falls with frequency as the water lags; it does not rise first.")
    yield Row("The same, 20 % humidity", ZHU, "falls from 0.1 to 10 Hz", "", "", "cannot be had",
              f"No modulus below 50 % humidity has a source. At 50 % the law falls, by {100 * (1 - dry[2] / dry[0]):.2g} % from 0.1 to 10 Hz. A large "
              "resistance of the cell before the instrument would make it fall, too; a polymer that relaxes makes it rise.")
    current = sweep(readout__circuit="short")
    double = sweep(readout__circuit="short", strain__curvature="20 1/m")
    linear = max(abs(two / one / 2 - 1) for one, two in zip(current, double))
    yield Row("Short-circuit current", ZHU, "grows with frequency, linear in the load", "bent_strip",
              f"{', '.join(f'{1e6 * one:.3g}' for one in current)} uA at 0.1, 1, 10 Hz; twice the bend gives twice the current to {100 * linear:.2g} %",
              verdict_of(current[0] < current[1] < current[2] and linear < 0.05))


def sealed_stack(runs):
    """A sealed strip bent by several curvatures, of several sizes."""
    bends = (2, 5, 10, 20)
    peaks = [runs("bent_strip", strain__curvature=f"{bend} 1/m").values["peak_voltage"] for bend in bends]
    slopes = [peak / bend for peak, bend in zip(peaks, bends)]
    spread = max(slopes) / min(slopes) - 1
    yield Row("Voltage over curvature", STACK, "proportional", "bent_strip",
              f"volts per curvature differ by {100 * spread:.2g} % from 2 to 20 1/m", verdict_of(spread < 0.05))
    sizes = [runs("bent_strip", skin__length=length, skin__width=width).values["peak_voltage"]
             for length, width in (("20 mm", "5 mm"), ("60 mm", "5 mm"), ("30 mm", "10 mm"))]
    spread = max(sizes) / min(sizes) - 1
    yield Row("Voltage over length and width", STACK, "none", "bent_strip", f"differs by {100 * spread:.2g} %", verdict_of(spread < 0.01))
    thick = [runs("bent_strip", **{"skin__layers[1]__thickness": f"{microns} um"}).values["peak_voltage"] for microns in (100, 200, 400)]
    yield Row("Voltage over thickness", STACK, "none", "bent_strip", f"{microvolts(thick)} at 100, 200, 400 um",
              verdict_of(max(thick) / min(thick) < 1.2),
              "The law says proportional. The range that was measured is not known, and films that are stacked may be cells side by side.")


def permeation(runs):
    """Streaming potential of Nafion 117, which Saxen's relation ties to the measured drag number."""
    for ion, drag in DRAG.items():
        potential = runs("permeation_cell", water__drag_number=drag).table("water")["streaming_voltage"][-1]
        source = ("drag number 2.6 by Ise et al. 1999, Solid State Ionics 125, 213 (abstract)" if ion == "H+" else
                  f"drag number {drag} from memory of Xie and Okada 1995, J. Electrochem. Soc. 142, 3057")
        measured = ("stands inside Catalano and Bentien 2014, J. Power Sources 262, 192; not read" if ion in ("H+", "Li+") else
                    "stands inside Okada et al. 1998, doi 10.1016/S0013-4686(98)00132-7; not read")
        yield Row(f"Streaming potential of Nafion 117, {ion}", source, measured, "permeation_cell",
                  f"{1e3 * potential:.3g} mV/bar", "cannot be had",
                  "A prediction from another experiment, by Saxen's relation. The next step is the paper's number: 15 to 20 % would be the demand.",
                  "mV/bar", 1e3 * potential, 1e3 * potential * 0.85, 1e3 * potential * 1.15)


def cartilage(runs):
    """Streaming potential of cartilage in confined compression, over the spread of its constants."""
    potentials = []
    for modulus, mobility in (("0.47 MPa", "7.3e-15 m2/(Pa s)"), ("0.27 MPa", "4.6e-15 m2/(Pa s)"), ("0.71 MPa", "0.5e-15 m2/(Pa s)"),
                              ("0.64 MPa", "3.62e-16 m2/(Pa s)")):
        table = runs("cartilage", water__drained_modulus=modulus, water__mobility=mobility).table("water")
        potentials.append(1e3 * amplitude(table["time"], table["streaming_voltage"], 1.0))
    low, high = min(potentials), max(potentials)
    yield Row("Cartilage in confined compression, 1 Hz", CHEN, "of the order of 1 mV for 1 % of strain (from memory)", "cartilage",
              f"{potentials[0]:.2g} mV, {low:.2g} to {high:.2g} over the constants of four discs", verdict_of(low < 3 and high > 1 / 3),
              "Moduli, permeabilities and coupling are measured apart from the signal. A curve over frequency of one disc would be the test.",
              "mV", potentials[0], low, high, measured_low=1 / 3, measured_high=3)


def pressed_pad(runs):
    """Voltage per newton of a pressed pad whose cation and area are not known."""
    per_newton = {}
    for ion in ("H+", "Li+"):
        for side in (10, 3.2):  # 100 and 10 mm2
            run = runs("pressed_pad", water__drag_number=DRAG[ion], skin__length=f"{side} mm", skin__width=f"{side} mm",
                       strain__pressure=f"{1e3 / side ** 2} kPa")
            per_newton[ion, side] = 1e3 * run.values["peak_voltage"]
    low, high = min(per_newton.values()), max(per_newton.values())
    yield Row("Pressed sensor of solution-cast Nafion", YIN, "1.06 mV/N", "pressed_pad",
              f"{low:.2g} to {high:.2g} mV/N for 1 N on 100 to 10 mm2, H+ to Li+, one wall open", verdict_of(low <= 1.06 <= high),
              "Cation and pad area decide and stand in the paper. A sensor that also bends on its support would give more.",
              "mV/N", math.sqrt(low * high), low, high, measured_low=1.06, measured_high=1.06)


def gel(runs):
    """Response time of pressed gels over thickness."""
    times = {}
    for thickness in (0.2, 1.0, 2.0):
        table = runs("pressed_gel", strain__duration=f"{100 * thickness ** 2} s", readout__sample_interval=f"{0.05 * thickness ** 2} s",
                     **{"skin__layers[1]__thickness": f"{thickness} mm"}).table("water")
        signal = abs(table["streaming_voltage"])
        top = signal.argmax()
        times[thickness] = table["time"][top + numpy.argmax(signal[top:] < signal[top] / math.e)] - table["time"][top]
    scale = 5 / times[1.0]  # the measured time at 1 mm sets the one constant that is free
    thin, thick = scale * times[0.2], scale * times[2.0]
    yield Row("Pressed gel, twice as thick", GEL, "more than 10 s at 2 mm where 1 mm has about 5 s", "pressed_gel",
              f"{thick:.3g} s", verdict_of(thick > 10), "The water's time goes with the square of the thickness.",
              "s", thick, measured_low=10)
    yield Row("Pressed gel, five times thinner", GEL, "30 ms at 0.2 mm where 1 mm has about 5 s", "pressed_gel",
              f"{1e3 * thin:.3g} ms", verdict_of(thin < 0.06),
              "Steeper than the square. The authors point to pressure that spreads below the indenter, which an even load has not got.",
              "s", thin, measured_low=0.03, measured_high=0.03)


def not_comparable(_runs):
    """Measurements that cannot be compared, each with the reason."""
    for name, source, measured, remark in (
            ("Shock pulses in compression and shear on a sealed film", "Gudarzi et al. 2019, doi 10.1177/1045389X19844000 (abstract)",
             "signals in compression, bending and shear; numbers inside the paper",
             "The law gives nothing for an even pressure or shear of a sealed uniform core: a measured shear signal would refute it."),
            ("Short-circuit current under compression", "Volpini et al. 2017, Smart Mater. Struct. 26 (abstract)",
             "a closed form that reproduces data of others", "Form and constants stand inside the paper."),
            ("Capacitance of plated electrodes", "Aureli et al. 2009, doi 10.1063/1.3129503; Goncalves et al. 2024, doi 10.1039/d3ma00593c (abstracts)",
             "tens of mF/cm2 for plated platinum (from memory); follows the rough area",
             "An input of the model, not an answer. It must be taken from an impedance, never from the signal."),
            ("PVDF-HFP gel under slow pressure", "Dobashi et al. 2016, MRS Advances (abstract)", "25 uV/Pa at 10 mHz",
             "Four to five decades above the streaming of wet Nafion: another mechanism, which is out of reach.")):
        yield Row(name, source, measured, "", "", "cannot be had", remark)


def two_laws(runs):
    """Peak voltage of a bent strip over cation and thickness [V], by streaming and by ions that bending alone thins: Cha and
    Porfiri 2013 have V = (R T/F) h kappa in that limit, whatever the cation (coefficient from memory)."""
    thermal_voltage, curvature = 8.314462618 * 298.15 / 96485.33212, 10.0
    return [{"ion": ion, "thickness": microns * 1e-6, "diluted": thermal_voltage * curvature * microns * 1e-6,
             "streamed": runs("bent_strip", water__drag_number=drag,
                              **{"skin__layers[1]__thickness": f"{microns} um"}).values["peak_voltage"]}
            for microns in (100, 200) for ion, drag in DRAG.items()]


def two_decays(runs):
    """Voltage of a bent strip over its peak as it decays, in two thicknesses, with and without a polymer that relaxes: half of
    the shear modulus with a time of 10 s, which is no measured one."""
    decays = []
    for microns in (100, 200):
        for polymer in ({}, {"materials__nafion_wet__relaxation_times": '["10 s"]', "materials__nafion_wet__relaxation_shares": "[0.5]"}):
            time, voltage = runs("bent_strip", strain__duration="100 s", readout__sample_interval="20 ms",
                                 **{"skin__layers[1]__thickness": f"{microns} um"}, **polymer).voltage()
            instants = numpy.geomspace(0.02, 100, 60)
            decays.append({"thickness": microns * 1e-6, "relaxes": bool(polymer), "time": instants.tolist(),
                           "share": (numpy.interp(instants, time, voltage) / voltage.max()).tolist()})
    return decays


EXPERIMENTS = (cations, held_bend, swinging_bend, sealed_stack, permeation, cartilage, pressed_pad, gel, not_comparable)
# What each row said when the prose of its page was written, docs/generate/evidence.py, and its number where it has one.
STANDS = {
    "Order of the cations": ("agrees", None),
    "A held bend decays": ("agrees", None),
    "Its steady voltage in wet H+": ("disagrees", None),
    "Voltage over frequency, 90 % humidity": ("agrees", None),
    "The same, 50 % humidity": ("disagrees", None),
    "The same, 20 % humidity": ("cannot be had", None),
    "Short-circuit current": ("agrees", None),
    "Voltage over curvature": ("agrees", None),
    "Voltage over length and width": ("agrees", None),
    "Voltage over thickness": ("disagrees", None),
    "Streaming potential of Nafion 117, Li+": ("cannot be had", 0.2809),
    "Streaming potential of Nafion 117, Na+": ("cannot be had", 0.1779),
    "Streaming potential of Nafion 117, K+": ("cannot be had", 0.09364),
    "Streaming potential of Nafion 117, H+": ("cannot be had", 0.04869),
    "Cartilage in confined compression, 1 Hz": ("agrees", 1.376),
    "Pressed sensor of solution-cast Nafion": ("disagrees", 0.02032),
    "Pressed gel, twice as thick": ("agrees", 19.64),
    "Pressed gel, five times thinner": ("disagrees", 0.1946),
    "Shock pulses in compression and shear on a sealed film": ("cannot be had", None),
    "Short-circuit current under compression": ("cannot be had", None),
    "Capacitance of plated electrodes": ("cannot be had", None),
    "PVDF-HFP gel under slow pressure": ("cannot be had", None),
}
SAME = 0.02  # relative, of numbers at `coarse`


def departures(rows):
    """Rows that say something else than they did when the prose of their page was written, in words."""
    by_name = {row.name: row for row in rows}
    for name, (verdict, value) in STANDS.items():
        if name not in by_name:
            yield f"{name} is missing"
        elif by_name[name].verdict != verdict:
            yield f"{name}: {by_name[name].verdict}, and the page was written for {verdict}"
        elif value is not None and not abs(by_name[name].value / value - 1) <= SAME:
            yield f"{name}: {by_name[name].value:.4g} {by_name[name].unit}, and the page was written for {value:g}"
    for name in by_name:
        if name not in STANDS:
            yield f"{name} is new: the page's prose and STANDS do not know it"
