// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/finite_layers/plane/inverse_waves.hpp"
#include "ionskin/finite_layers/plane/plane_compliance.hpp"

#include <Eigen/Core>

namespace ionskin::mechanics {

/// The face of a soft slider, docs/model.md (36), (37).
struct SliderFace {
  finite_layers::PlaneCompliance compliance;
  finite_layers::WavesOfBody waves;
};
SliderFace slider_face(const Slider& slider);

/// The slider is above: what moves its face towards the load moves it away from the skin, so that
/// normal and tangential parts are mixed with the opposite sign of those of a skin below.
inline constexpr double mixed_of_slider = -1;

/// Compliance of a soft slider under forces between it and the cells, docs/model.md (36): the part
/// that is added to the compliance of the skin. The slider is a half-space, or a layer of its
/// material on a rigid body, docs/model.md (37). Empty for a rigid slider. On a half grid the
/// mirrored forces act, too.
/// @return [3 cells, 3 cells], symmetric [m/N]
Eigen::MatrixXd slider_compliance(const Slider& slider, const finite_layers::ContactGrid& grid);

} // namespace ionskin::mechanics
