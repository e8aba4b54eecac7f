// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"
#include "ionskin/mesh/footprint.hpp"

#include <optional>

namespace ionskin::mechanics {

/// Within which a slider on a drive may swing: with its footprint on the skin.
MotionBox room_on_skin(const Case& input, const mesh::Footprint& footprint);

/// The rectangle that a slider on a drive turned out to need, grown by some part of what it was
/// left by; empty where it stayed near enough.
std::optional<MotionBox> widened_box(const Case& input, const MotionBox& box, const MotionBox& room,
                                     const ContactSolution& solution);

/// Cases with shared positions are solved at those alone.
/// @throws SolverError where they are
void require_unshared(const Case& input, const MotionBox& needed);

} // namespace ionskin::mechanics
