# SPDX-License-Identifier: Apache-2.0
"""Share of a fit's own 95 % intervals that hold the truth.

    PYTHONPATH=build/python /usr/bin/python3 benchmarks/fit_recovery.py --seeds 100

Synthetic data: the sampled current_difference of cases/paper/coarse.toml (coarse preset) with white normal noise of 2 % of its
rms, or of its peak with --of peak. The fit starts from 1.5 times the coupling coefficient and 0.6 times the
diffusivity. One model serves all seeds: solutions at the same parameters (the start and its differences) are reused.
"""

import argparse
import pathlib
import time

import numpy

import ionskin

KEYS = ("coupling.coefficient", "electrochemistry.diffusivity")
OFF = (1.5, 0.6)
CASE = pathlib.Path(__file__).resolve().parent.parent / "cases" / "paper" / "coarse.toml"


def true_data():
    """The case with the truth, and time and current of its sampled signal."""
    case = ionskin.Case.from_file(CASE)
    case["output.fields"] = []
    sampled = ionskin.run(case).sampled
    return case, sampled["time"], sampled["current_difference"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seeds", type=int, default=100)
    parser.add_argument("--first", type=int, default=0, help="first seed")
    parser.add_argument("--noise", type=float, default=0.02)
    parser.add_argument("--of", choices=("rms", "peak"), default="rms")
    parser.add_argument("--threads", type=int, default=0)
    arguments = parser.parse_args()

    case, instants, current = true_data()
    truth = [case[key] for key in KEYS]
    size = numpy.abs(current).max() if arguments.of == "peak" else numpy.sqrt(numpy.mean(current**2))
    for key, value, factor in zip(KEYS, truth, OFF):
        case[key] = value * factor
    model = ionskin.FitModel(case, KEYS, threads=arguments.threads)

    start, inside, errors, solves = time.process_time(), [], [], 0
    for seed in range(arguments.first, arguments.first + arguments.seeds):
        noise = numpy.random.default_rng(seed).normal(0, arguments.noise * size, len(current))
        fit = model.fit(instants, current + noise)
        found = [fit.parameters[key] for key in KEYS]
        inside.append([one.lower_95 <= value <= one.upper_95 for one, value in zip(found, truth)])
        errors.append([numpy.log(one.value / value) for one, value in zip(found, truth)])
        solves = fit.summary["ion_transport_solves"]
        print(f"seed {seed}: " + "; ".join(f"{one.value / value:.4f} of the truth, {one.lower_95 / value:.4f} to "
                                           f"{one.upper_95 / value:.4f}" for one, value in zip(found, truth)), flush=True)
    inside = numpy.array(inside)
    for column, key in enumerate(KEYS):
        print(f"{key}: {inside[:, column].sum()} of {len(inside)} intervals hold the truth; "
              f"mean and rms error {numpy.mean(errors, axis=0)[column]:.2e}, "
              f"{numpy.sqrt(numpy.mean(numpy.square(errors), axis=0))[column]:.2e} (logarithmic)")
    print(f"both at once: {inside.all(axis=1).sum()} of {len(inside)}; {solves} ion transport solves, "
          f"{time.process_time() - start:.0f} s of processor time")


if __name__ == "__main__":
    main()
