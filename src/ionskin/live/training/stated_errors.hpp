// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/touches/random_touches.hpp"
#include "ionskin/live/training/validation.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace ionskin::live {

/// Validation touches that were compared with the full model so far.
struct ComparedTouches {
  std::size_t count = 0;
  std::vector<TouchErrors> errors; ///< on all of them
};

/// Measures the errors of the reduced-order model on random touches. A run of the full model covers
/// several touches at once.
/// @param data the trained model
/// @param count number of touches
/// @param footprint rectangle in which the slider may touch, from the training
/// @param done called after each run with the touches that are compared; may be empty
/// @param compared from a call that was interrupted, with the same arguments
std::vector<TouchErrors> errors_on_touches(
    const SkinData& data, const Case& input, const TouchRange& range, std::size_t count,
    std::uint64_t seed, const mesh::Footprint& footprint, const TrainingOptions& options,
    const std::function<void(const ComparedTouches&)>& done = {}, ComparedTouches compared = {});

/// Computes the errors that the file reports, over whole touches and over their events: 1.25 times
/// the largest rms error of a touch, and 1.25 times the largest error over all touches.
std::vector<SignalError> stated_errors(const std::vector<TouchErrors>& errors);

} // namespace ionskin::live
