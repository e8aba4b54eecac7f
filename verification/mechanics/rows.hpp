// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verification_table.hpp"

#include <vector>

namespace ionskin::verification {

/// M1: exact affine displacement through the three layers.
std::vector<Row> patch_rows();
/// M2: Hertz (rigid and soft sphere, cylinder) and Cattaneo-Mindlin on deep blocks of one material.
std::vector<Row> round_contact_rows(const Options& options);
/// M2: a thin bonded layer under a wide cylinder.
std::vector<Row> thin_layer_rows();
/// M4 to M8 on the baseline at the coarse preset.
std::vector<Row> contact_rows(const Options& options);
/// M9 to M11: off-centre, oblique and reversing tracks, force control.
std::vector<Row> motion_rows(const Options& options);
/// M12: stepped paths against strokes, and random ones.
std::vector<Row> path_rows(const Options& options);
/// M13: friction laws in sliding, and their loops.
std::vector<Row> friction_rows(const Options& options);
/// M14: a slider on a compliant drive, stick-slip.
std::vector<Row> drive_rows(const Options& options);
/// M15: pull-off of an adhesive sphere.
std::vector<Row> adhesion_rows(const Options& options);
/// M16: free sides and ends against triquadratic elements.
std::vector<Row> solid_rows(const Options& options);
/// M17: tilted, turned and spinning sliders, and the wrench on the skin.
std::vector<Row> pose_rows(const Options& options);
/// M18: several sliders on one skin.
std::vector<Row> several_sliders_rows(const Options& options);
/// M19: a cylinder that rolls, with creep and without.
std::vector<Row> rolling_rows(const Options& options);
/// Observed orders of reported averages under numerics.mesh_refinement, in plane strain.
std::vector<Row> convergence_rows(const Options& options);

} // namespace ionskin::verification
