// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"

#include <string>
#include <vector>

namespace ionskin::verification {

/// Verified figure, a row of the verification's table: a computed `value` beside its `reference`.
struct Row {
  std::string id;       ///< number of the set of rows in docs/verification.md, such as "E3" or "M4"
  std::string quantity; ///< name of the quantity, with its unit
  double value = 0;     ///< computed value, in the unit of `quantity`
  double reference = 0; ///< reference value, or the bound of `at_least`, in the unit of `quantity`
  /// Allowed |value - reference|, or the bound of `at_most`, in the unit of `quantity`.
  double tolerance = 0;
  bool passed = false; ///< true if the value meets its tolerance or bound
};

/// Options of the verification.
struct Options {
  int threads = 1; ///< number of threads of the solvers
  base::ProgressCallback progress = base::no_progress;
};

/// Makes a row that passes when |value - reference| <= tolerance.
Row compare(std::string id, std::string quantity, double value, double reference, double tolerance);
/// Makes a row that passes when value <= bound; the reference is 0.
Row at_most(std::string id, std::string quantity, double value, double bound);
/// Makes a row that passes when value >= bound, such as an observed order of convergence.
Row at_least(std::string id, std::string quantity, double value, double bound);

/// Rows M1 to M19: contact mechanics (Study 1).
std::vector<Row> verify_mechanics(const Options& options);
/// Rows of ion transport (Study 2).
std::vector<Row> verify_electrochemistry(const Options& options);
/// Rows P1 to P14: pore pressure, and the streaming that it drives.
std::vector<Row> verify_poroelasticity(const Options& options);
/// Rows C3 and C4: both studies one after the other, with the transfer of strain between them.
std::vector<Row> verify_chain(const Options& options);

} // namespace ionskin::verification
