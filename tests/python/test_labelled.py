# SPDX-License-Identifier: Apache-2.0
"""Results as labelled arrays: dimensions, coordinates and units, and what is said without xarray."""

import sys
import unittest
import unittest.mock

import numpy

import ionskin
from package import PackageTest

SWEEP = """\
point,folder,contact.friction [1],motion.preload [m],numerics.preset,status,reason,normal_force_slide [N],peak_current_top [A]
1,points/0001,0.1,1e-06,coarse,finished,,64.5,0.2
2,points/0002,0.2,1e-06,fine,failed,"no solution, none",,
"""


class Labelled(PackageTest):
    def table(self):
        """Three rows as read from a file: a text, an empty entry."""
        path = self.folder / "signals.csv"
        path.write_text("time [s],cycle,phase,normal_force [N],charge_top [C]\n"
                        "0,1,touchdown,0,0\n0.5,1,slide,65,1e-4\n1,1,slide,,2e-4\n")
        return ionskin.results.read_table(path)

    def test_columns_over_time(self):
        dataset = self.table().to_xarray()
        self.assertEqual(dict(dataset.sizes), {"time": 3})
        self.assertEqual(set(dataset.coords), {"time", "cycle", "phase"})
        self.assertEqual(set(dataset.data_vars), {"normal_force", "charge_top"})
        self.assertEqual({name: dataset[name].attrs["units"] for name in ("time", "normal_force", "charge_top")},
                         {"time": "s", "normal_force": "N", "charge_top": "C"})
        self.assertEqual(float(dataset["charge_top"].sel(time=0.5)), 1e-4)
        self.assertAlmostEqual(dataset["charge_top"].interp(time=[0.75]).item(), 1.5e-4, delta=1e-18)
        self.assertTrue(numpy.isnan(dataset["normal_force"].isel(time=2)))
        slide = dataset.where(dataset["phase"] == "slide", drop=True)
        numpy.testing.assert_array_equal(slide["time"], [0.5, 1.0])

    def test_metrics_over_the_points_of_a_sweep(self):
        (self.folder / "sweep.csv").write_text(SWEEP)
        dataset = ionskin.Sweep(self.folder).to_xarray()
        self.assertEqual(dict(dataset.sizes), {"point": 2})
        self.assertEqual(set(dataset.coords), {"contact.friction", "motion.preload", "numerics.preset"})
        numpy.testing.assert_array_equal(dataset["contact.friction"], [0.1, 0.2])
        self.assertEqual(dataset["motion.preload"].attrs["units"], "m")
        self.assertEqual(list(dataset["numerics.preset"].values), ["coarse", "fine"])
        self.assertEqual(dataset["normal_force_slide"].dims, ("point",))
        self.assertEqual(dataset["normal_force_slide"].attrs["units"], "N")
        numpy.testing.assert_array_equal(dataset["normal_force_slide"], [64.5, numpy.nan])

    def test_without_xarray_the_message_names_the_package(self):
        with unittest.mock.patch.dict(sys.modules, {"xarray": None}):
            with self.assertRaises(ImportError) as raised:
                self.table().to_xarray()
        self.assertIn("python3-xarray", str(raised.exception))


if __name__ == "__main__":
    unittest.main()
