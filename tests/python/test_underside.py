# SPDX-License-Identifier: Apache-2.0
"""Drawings of a slider's underside in the figures."""

import unittest

import numpy

from ionskin.charts.skin import slider_words
from ionskin.charts.underside import Underside, interpolated


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

    def test_a_shape_without_stated_heights_is_a_box_that_says_so(self):
        drawn = Underside({"shape": "paraboloid", "radius_x": "8 mm", "size": ["3 mm", "1.5 mm"]})
        self.assertTrue(drawn.sharp)
        self.assertIn("heights not at hand", slider_words(drawn))
        numpy.testing.assert_allclose(drawn.half_size, [1.5e-3, 0.75e-3])

    def test_any_other_shape_is_drawn_by_what_its_run_states(self):
        places = numpy.linspace(-1e-3, 1e-3, 41)
        heights = interpolated(places, 0.5 * places, places**2 / 16e-3 + (0.5 * places[:, None])**2 / 4e-3)
        drawn = Underside({"shape": "paraboloid", "size": ["2 mm", "1 mm"]}, heights)
        self.assertFalse(drawn.sharp)
        self.assertEqual(slider_words(drawn), "slider (paraboloid): 2 mm × 1 mm")
        # Between the places a parabola lies below its chord by at most the square of half the spacing.
        self.assertAlmostEqual(float(drawn.height(3.1e-4, 1.7e-4)), 3.1e-4**2 / 16e-3 + 1.7e-4**2 / 4e-3, delta=1e-7)
        self.assertAlmostEqual(float(drawn.height(-1e-3, 0.5e-3)), 1e-6 / 16e-3 + 0.25e-6 / 4e-3, delta=1e-12)
        self.assertAlmostEqual(float(drawn.height(-2e-3, 0.0)), 1e-6 / 16e-3, delta=1e-9)  # beyond: that of the border


if __name__ == "__main__":
    unittest.main()
