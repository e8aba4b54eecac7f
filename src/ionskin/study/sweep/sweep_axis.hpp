// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ionskin::study {

/// One axis of a sweep, a key with its values or interval, from an argument `--over KEY=...`. Made
/// by `parse_axis`.
struct SweepAxis {
  /// Interval of values, which a sampled design fills.
  struct Interval {
    double lower = 0, upper = 0;
    std::string unit; ///< unit as the user wrote it; empty for pure numbers
  };
  std::string key;                  ///< key of the case
  std::vector<std::string> values;  ///< values in the syntax of TOML; empty for an interval
  std::optional<Interval> interval; ///< interval of `KEY=a:b`; empty for a list or range of values
};

/// Parses the argument of one `--over`:
///   KEY=a:step:b    equal steps, both ends included: contact.friction=0.05:0.05:0.5,
///                   "motion.stroke=1:0.5:3 mm", "motion.stroke=1 mm:500 um:3 mm" is refused
///   KEY=v1,v2,...   a list; quotes and brackets are respected: motion.preload="1 um","2 um"
///   KEY=a:b         an interval, for sampled designs
/// Throws UserError for a missing key or value, an invalid range, or ends in different units.
SweepAxis parse_axis(const std::string& argument);

} // namespace ionskin::study
