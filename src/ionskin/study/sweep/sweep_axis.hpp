// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ionskin::study {

/// One `--over KEY=...` of a sweep.
struct SweepAxis {
  /// Ends of an interval that a sampled design fills.
  struct Interval {
    double lower = 0, upper = 0;
    std::string unit; ///< as the user wrote it; empty for pure numbers
  };
  std::string key;
  std::vector<std::string> values;  ///< as TOML takes them; empty for an interval
  std::optional<Interval> interval; ///< of `KEY=a:b`
};

/// Reads one argument:
///   KEY=a:step:b    equal steps, both ends included: contact.friction=0.05:0.05:0.5,
///                   "motion.stroke=1:0.5:3 mm", "motion.stroke=1 mm:500 um:3 mm" is refused
///   KEY=v1,v2,...   a list; quotes and brackets are respected: motion.preload="1 um","2 um"
///   KEY=a:b         an interval, for sampled designs
/// Throws UserError: no key, no value, a range that is none, ends of different units.
SweepAxis parse_axis(const std::string& argument);

} // namespace ionskin::study
