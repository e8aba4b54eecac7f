// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"
#include "ionskin/case/case.hpp"
#include "ionskin/live/skin_data.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace ionskin::live {

/// Number of touches of which with a confidence of 99 % at least 95 % of all touches have no larger
/// error than the largest of theirs, whatever the distribution: 0.95^90 < 0.01 (Wilks 1941,
/// doi 10.1214/aoms/1177731788).
inline constexpr std::size_t validation_touches = 90;

/// Options of the training of a live skin.
struct TrainingOptions {
  std::size_t trajectories = 12;               ///< random touches that it is trained on
  std::size_t validation = validation_touches; ///< other random touches that tell its errors
  std::uint64_t seed = 1;                      ///< of the touches
  /// Lowest and highest coefficient of friction, in place of the case's alone.
  std::optional<std::array<double, 2>> friction;
  double tilt = 0; ///< steepest that is trained, roll and pitch together [rad]
  double turn = 0; ///< fastest about z that is trained [rad/s]
  int threads = 1;
  base::ProgressCallback progress = base::no_progress;
  std::string command; ///< for the record
};

/// Checks that the reduced skin can stand for a case. Throws UserError where not: the strain must
/// come from contact, the electrodes be shorted, the slider touch, the range of friction hold the
/// case's.
void check_trainable(const Case& input, const TrainingOptions& options);

/// Trains on random touches within the range of the case's motion, by the full model, and measures
/// the errors on others. Throws UserError, SolverError, Interrupted.
SkinData train_skin(const Case& input, const TrainingOptions& options);

} // namespace ionskin::live
