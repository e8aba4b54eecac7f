// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"

#include <string>
#include <vector>

namespace ionskin::verification {

/// One verified figure: `value` against `reference`; passed when the program's own rule for it
/// holds.
struct Row {
  std::string id;       ///< such as "E3" or "M4", the numbering of the verification pages
  std::string quantity; ///< quantity that is compared, with its unit
  double value = 0;
  double reference = 0;
  double tolerance = 0; ///< on |value - reference|, in the unit of `quantity`
  bool passed = false;
};

struct Options {
  int threads = 1;
  base::ProgressCallback progress = base::no_progress;
};

/// A row that passes when |value - reference| <= tolerance.
Row compare(std::string id, std::string quantity, double value, double reference, double tolerance);
/// A row that passes when value <= bound (reference 0).
Row at_most(std::string id, std::string quantity, double value, double bound);
/// A row that passes when value >= bound; used for observed orders of convergence.
Row at_least(std::string id, std::string quantity, double value, double bound);

std::vector<Row> verify_mechanics(const Options& options);
std::vector<Row> verify_electrochemistry(const Options& options);
std::vector<Row> verify_poroelasticity(const Options& options);
/// Rows of the chain of both physics together.
std::vector<Row> verify_chain(const Options& options);

} // namespace ionskin::verification
