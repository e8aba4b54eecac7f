// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/case/slider_motion.hpp"

#include <optional>

namespace ionskin::mechanics {

/// Smallest rectangle that holds the slider's centre while the slider touches the skin [m]; empty
/// if it never touches. For a slider on a drive it is an estimate, and may turn out to be wider.
std::optional<MotionBox> contact_box(const Case& input);

} // namespace ionskin::mechanics
