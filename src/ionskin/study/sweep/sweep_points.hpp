// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"
#include "ionskin/study/sweep/sweep_design.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ionskin::study {

/// Request of the user for a sweep: a base case and the keys to vary.
struct SweepRequest {
  std::string case_path;
  std::optional<std::string> case_text; ///< instead of the file's
  std::vector<std::string> set_edits;   ///< of the base case
  std::vector<std::string> over;        ///< one `KEY=...` per axis, see `parse_axis`
  std::size_t samples = 0;              ///< 0: the grid of all values
  Sampling sampling = Sampling::sobol;
  std::uint64_t seed = 1;
};

/// A key's value at one point: as written, and in SI units ("1e-06", "m"; unit "1" for pure
/// numbers, empty for texts).
struct SweptValue {
  std::string key, written, si, unit;
};

/// One point of a sweep: a whole case.
struct SweepPoint {
  std::string name; ///< of its folder: "0003_friction=0.15"
  std::vector<SweptValue> values;
  std::vector<std::string> edits;         ///< "KEY=value" each, behind those of the base case
  std::string input_hash, mechanics_hash; ///< of the case; the second is empty without contact
  Case input;                             ///< default where a plan was read without it
};

/// All points of a sweep.
struct SweepPlan {
  SweepRequest request; ///< with the text of the case
  Case base;            ///< base case, whose text names the axes and so identifies the sweep
  std::vector<SweepPoint> points;
};

/// Every point as the request alone makes it: name, edits, keys and values as written. Nothing of
/// its case is read. Throws UserError, as for more points, keys or edits than a sweep may have.
std::vector<SweepPoint> designed_points(const SweepRequest& request);

/// Reads and checks the case of every point. Throws UserError with the point that is wrong.
SweepPlan plan_sweep(const SweepRequest& request);

/// The case of one point, checked. Throws UserError.
CaseDocument read_point_case(const SweepRequest& request, const std::vector<std::string>& edits);

/// The case that stands for the whole sweep.
/// @param first that of the first point
Case base_case(const SweepRequest& request, Case first);

} // namespace ionskin::study
