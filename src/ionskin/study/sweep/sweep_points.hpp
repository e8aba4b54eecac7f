// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"
#include "ionskin/study/sweep/sweep_design.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ionskin::study {

/// User's request for a sweep: a base case and the keys to vary.
struct SweepRequest {
  std::string case_path;
  std::optional<std::string> case_text; ///< text of the case; empty to read it from the file
  std::vector<std::string> set_edits;   ///< changes of the base case, "KEY=value" each
  std::vector<std::string> over;        ///< one `KEY=...` per axis, see `parse_axis`
  std::size_t samples = 0;              ///< number of sampled points; 0: the grid of all values
  Sampling sampling = Sampling::sobol;
  std::uint64_t seed = 1;
};

/// Value of a swept key at one point: as the user wrote it, and in SI units, such as "1e-06" and
/// "m". The unit is "1" for pure numbers and empty for texts.
struct SweptValue {
  std::string key, written, si, unit;
};

/// One point of a sweep, a complete case with the values of the swept keys.
struct SweepPoint {
  std::string name; ///< name of its run folder, such as "0003_friction=0.15"
  std::vector<SweptValue> values;
  /// Changes of the case, "KEY=value" each, applied after those of the request.
  std::vector<std::string> edits;
  /// `input_hash` and `mechanics_hash` of the case; the second is empty where the strain is given.
  std::string input_hash, mechanics_hash;
  Case input; ///< the case; default where a plan was read without it
};

/// All points of a sweep. Made by `plan_sweep`, or read from plan.json.
struct SweepPlan {
  SweepRequest request; ///< request, with the text of the case
  Case base; ///< base case of the sweep; its text names the axes and so identifies the sweep
  std::vector<SweepPoint> points;
};

/// Makes the points from the request only: name, edits, keys and values as written. Reads none of
/// their cases.
/// Throws UserError, also for more points, keys or edits than a sweep may have.
std::vector<SweepPoint> designed_points(const SweepRequest& request);

/// Makes the points of a sweep and reads and checks the case of each.
/// Throws UserError that names the point that is wrong.
SweepPlan plan_sweep(const SweepRequest& request);

/// Reads and checks the case of one point.
/// @param edits changes of the point, applied after those of the request
/// Throws UserError.
CaseDocument read_point_case(const SweepRequest& request, const std::vector<std::string>& edits);

/// Base case of a sweep: the first point's case, with the swept axes as comments at the end of its
/// text.
/// @param first case of the first point
Case base_case(const SweepRequest& request, Case first);

} // namespace ionskin::study
