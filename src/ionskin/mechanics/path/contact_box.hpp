// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/case/slider_motion.hpp"

#include <optional>

namespace ionskin::mechanics {

/// The smallest rectangle that holds the slider's centre while it touches [m]; empty when it never
/// touches. That of a slider on a drive may turn out to be wider.
std::optional<MotionBox> contact_box(const Case& input);

} // namespace ionskin::mechanics
