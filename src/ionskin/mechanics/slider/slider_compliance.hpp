// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/finite_layers/plane/inverse_waves.hpp"
#include "ionskin/finite_layers/plane/plane_compliance.hpp"

#include <Eigen/Core>

namespace ionskin::mechanics {

/// Compliance of the face of a soft slider, docs/model.md (36), (37), in the plane and over the
/// wave number.
struct SliderFace {
  finite_layers::PlaneCompliance compliance;
  finite_layers::WavesOfBody waves;
};
/// Makes the compliance of the face of a soft slider.
SliderFace slider_face(const Slider& slider);

/// Sign of the mixed terms of a slider's compliance, normal displacement by tangential force and
/// the reverse, relative to those of a skin [1]. The slider lies above: a load moves its face away
/// from the skin, so that mixed terms change their sign.
inline constexpr double mixed_of_slider = -1;

/// Compliance of a soft slider under forces between it and the contact cells, docs/model.md (36),
/// to be added to the compliance of the skin. The slider is a half-space, or a layer of its
/// material on a rigid body, docs/model.md (37). On a grid of half the cells mirrored forces act,
/// too.
/// @returns [3 cells, 3 cells], symmetric [m/N]; empty for a rigid slider
Eigen::MatrixXd slider_compliance(const Slider& slider, const finite_layers::ContactGrid& grid);

} // namespace ionskin::mechanics
