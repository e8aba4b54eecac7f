# SPDX-License-Identifier: Apache-2.0
"""Writes a strain file: shear odd through the thickness, there from t = 0 and held for 4 s."""
import sys

import h5py
import numpy

z = numpy.array([0.0, 180e-6])
gamma = 0.015 * (2 * z / z[-1] - 1)  # k gamma = 0.0015 at the walls with k = 0.1: linear response
with h5py.File(sys.argv[1] if len(sys.argv) > 1 else "strain.h5", "w") as file:
    file.attrs.update(format="ionskin-strain", version=1, measure="off-diagonal", frame="skin")
    file["grid/x"], file["grid/y"], file["grid/z"] = [0.0, 15e-3], [0.0, 2e-3], z
    file["time"] = [0.0, 4.0]
    file["gamma"] = numpy.broadcast_to(gamma[:, None, None], (2, 2, 1, 1))  # [time, z, y, x]
    file["gamma"].attrs["unit"] = "1"
