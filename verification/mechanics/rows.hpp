// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verification_table.hpp"

#include <vector>

namespace ionskin::verification {

/// Row set M1: affine displacement through the three layers, which must be exact.
std::vector<Row> patch_rows();
/// Row set M2: Hertz (rigid and soft sphere, cylinder) and Cattaneo-Mindlin contact on deep blocks
/// of one material.
std::vector<Row> round_contact_rows(const Options& options);
/// Row set M2: a thin bonded layer under a wide cylinder.
std::vector<Row> thin_layer_rows();
/// Row sets M4 to M8: contact of the baseline case at the coarse preset.
std::vector<Row> contact_rows(const Options& options);
/// Row sets M9 to M11: off-centre, oblique and reversing tracks, force control.
std::vector<Row> motion_rows(const Options& options);
/// Row set M12: stepped paths against strokes, and random paths.
std::vector<Row> path_rows(const Options& options);
/// Row set M13: friction laws in sliding, and their loops of force over travel.
std::vector<Row> friction_rows(const Options& options);
/// Row set M14: a slider on a compliant drive, with stick-slip.
std::vector<Row> drive_rows(const Options& options);
/// Row set M15: pull-off force of an adhesive sphere.
std::vector<Row> adhesion_rows(const Options& options);
/// Row set M16: free sides and ends of the skin against triquadratic solid elements.
std::vector<Row> solid_rows(const Options& options);
/// Row set M17: tilted, turned and spinning sliders, and the wrench on the skin.
std::vector<Row> pose_rows(const Options& options);
/// Row set M18: several sliders on one skin.
std::vector<Row> several_sliders_rows(const Options& options);
/// Row set M19: a rolling cylinder, with creep and without.
std::vector<Row> rolling_rows(const Options& options);
/// Row set M6: observed orders of convergence of reported averages under numerics.mesh_refinement,
/// in plane strain.
std::vector<Row> convergence_rows(const Options& options);

} // namespace ionskin::verification
