// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/finite_layers/plane/plane_compliance.hpp"

#include <Eigen/Core>

namespace ionskin::mechanics {

/// Compliance of a soft slider under forces between it and the cells, docs/model.md (36): what is
/// to be added to the compliance of the skin. The slider is a half-space, or a layer of its
/// material on a rigid body, docs/model.md (37). Empty for a rigid slider. On a half grid the
/// mirrored forces act, too.
/// @return [3 cells, 3 cells], symmetric [m/N]
Eigen::MatrixXd slider_compliance(const Slider& slider, const finite_layers::ContactGrid& grid);

} // namespace ionskin::mechanics
