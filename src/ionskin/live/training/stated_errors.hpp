// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/training/random_touches.hpp"
#include "ionskin/live/training/validation.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace ionskin::live {

/// Errors on random touches, some of which a run of the full model takes together.
/// @param footprint of the training
/// @param done called with the number of touches that are done; may be empty
std::vector<TouchErrors> errors_on_touches(const SkinData& data, const Case& input,
                                           const TouchRange& range, std::size_t count,
                                           std::uint64_t seed, const mesh::Footprint& footprint,
                                           const TrainingOptions& options,
                                           const std::function<void(std::size_t)>& done = {});

/// Errors that a file states, of whole touches and of their events: a quarter more than the largest
/// rms of a touch and than its largest error over all touches.
std::vector<SignalError> stated_errors(const std::vector<TouchErrors>& errors);

} // namespace ionskin::live
