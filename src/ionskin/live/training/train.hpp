// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"
#include "ionskin/case/case.hpp"
#include "ionskin/live/data/skin_data.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace ionskin::live {

/// Number of validation touches. With a confidence of 99 %, at least 95 % of all touches have no
/// larger error than the largest one of these, whatever the distribution of errors: 0.95^90 < 0.01
/// (Wilks 1941, doi 10.1214/aoms/1177731788).
inline constexpr std::size_t validation_touches = 90;

/// Options for training a reduced-order skin.
struct TrainingOptions {
  std::size_t trajectories = 12;               ///< random touches for training
  std::size_t validation = validation_touches; ///< other random touches, which measure the errors
  std::uint64_t seed = 1;                      ///< for the random touches
  /// Lowest and highest coefficient of friction to train; empty: only that of the case.
  std::optional<std::array<double, 2>> friction;
  double tilt = 0; ///< largest tilt to train, roll and pitch together [rad]
  double turn = 0; ///< fastest rotation about z to train [rad/s]
  int threads = 1;
  base::ProgressCallback progress = base::no_progress;
  std::string command; ///< command line, for the file
  /// File that keeps what is done while the validation runs, and which the caller removes; empty to
  /// keep nothing.
  std::filesystem::path record;
  std::string identity; ///< of everything that decides the result, for this file
  bool resume = false;  ///< goes on from `record`, if this file exists
};

/// Checks that the reduced-order model can represent a case. Throws UserError where it cannot: the
/// strain must come from contact of one slider that neither sticks to the skin nor hangs on a
/// drive, the electrodes be shorted at one potential each, and the slider touch the skin; a range
/// of friction must include the coefficient of the case.
void check_trainable(const Case& input, const TrainingOptions& options);

/// Trains the reduced-order model of a case with runs of the full model along random touches within
/// the range of the case's motion, and measures its errors on other touches. Throws UserError,
/// SolverError, Interrupted, base::UnwritableFile.
SkinData train_skin(const Case& input, const TrainingOptions& options);

} // namespace ionskin::live
