# SPDX-License-Identifier: Apache-2.0
"""What the figures draw of a slider's underside."""

import tempfile
import unittest

import numpy

from ionskin.drawing.underside import Underside


class UndersideTest(unittest.TestCase):
    def test_round_sliders_rise_as_circles(self):
        """Height r^2 / (2 R) near the lowest point, and the drawn part ends where the circle reaches its height."""
        for slider in ({"shape": "sphere", "radius": "8 mm"},
                       {"shape": "cylinder", "radius": "8 mm", "size": ["10 mm", "2 mm"]}):
            with self.subTest(slider["shape"]):
                drawn = Underside(slider)
                self.assertFalse(drawn.sharp)
                self.assertAlmostEqual(drawn.height(1e-5, 0.0), 1e-10 / 16e-3, delta=1e-13)
                x, heights = (values[0] for values in drawn.lines(0.0))
                self.assertAlmostEqual(heights[0], drawn.depth, delta=1e-9)
                self.assertAlmostEqual(heights[-1], drawn.depth, delta=1e-9)
                self.assertAlmostEqual(x[-1], numpy.sqrt(2 * 8e-3 * drawn.depth - drawn.depth**2), delta=1e-9)
        self.assertEqual(drawn.height(0.0, 0.9e-3), 0.0, "the axis of a cylinder lies along y")

    def test_rounded_edges_leave_the_middle_flat(self):
        drawn = Underside({"size": ["3 mm", "1.5 mm"], "edge_radius": "0.2 mm"})
        numpy.testing.assert_allclose(drawn.height(numpy.array([0.0, 1.29e-3, 1.5e-3]), numpy.zeros(3)), [0, 0, 0.2e-3],
                                      atol=1e-12)
        self.assertTrue(Underside({"size": ["3 mm", "1.5 mm"]}).sharp)

    def test_a_shape_that_figures_do_not_know_is_a_box(self):
        drawn = Underside({"shape": "paraboloid", "radius_x": "8 mm", "size": ["3 mm", "1.5 mm"]})
        self.assertTrue(drawn.sharp)
        numpy.testing.assert_allclose(drawn.half_size, [1.5e-3, 0.75e-3])

    def test_height_map(self):
        with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
            file.write("um,-1000,0,1000\n-500,30,10,20\n500,30,10,20\n")
            file.flush()
            drawn = Underside({"shape": "profile", "size": ["2 mm", "1 mm"], "profile": file.name})
            self.assertAlmostEqual(float(drawn.height(0.5e-3, 0.0)), 5e-6, delta=1e-12)
        self.assertTrue(Underside({"shape": "profile", "size": ["2 mm", "1 mm"], "profile": "/nowhere.csv"}).sharp)


if __name__ == "__main__":
    unittest.main()
