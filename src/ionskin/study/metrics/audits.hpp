// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/metrics.hpp"

#include <string>
#include <vector>

namespace ionskin::study {

/// A quantity of every run that tells whether its results may be believed, and from where on they
/// may not. The table stands in docs/limits.md.
struct AuditRule {
  const char* metric;
  double warn, fail; ///< above
  const char* what;  ///< in words
  const char* remedy;
};

/// All rules, in the order in which they are reported.
const std::vector<AuditRule>& audit_rules();

/// Verdict of one audit.
enum class Verdict { passed, warned, failed };

struct Audit {
  const AuditRule* rule = nullptr;
  double value = 0;
  Verdict verdict = Verdict::passed;
};

/// Judges the metrics that have a rule. What is not a number has failed.
std::vector<Audit> audit(const std::vector<readout::Metric>& metrics);

/// A sentence for each audit that has not passed.
std::vector<std::string> audit_warnings(const std::vector<Audit>& audits);

/// Throws SolverError with the failed audits, if any. The results are kept.
void require_sound(const std::vector<Audit>& audits, const std::string& folder);

/// "passed", "warned", "failed".
std::string to_string(Verdict verdict);

} // namespace ionskin::study
