// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/metrics.hpp"

#include <string>
#include <vector>

namespace ionskin::study {

/// Rule that tells from one metric whether the results of a run can be trusted. The table of rules
/// is in docs/limits.md.
struct AuditRule {
  const char* metric; ///< name of the metric
  double warn, fail;  ///< limits of the metric, above which the audit warns or fails
  const char* what;   ///< description of the metric, in words for messages
  const char* remedy; ///< advice to the user
};

/// All audit rules, in the order in which they are reported.
const std::vector<AuditRule>& audit_rules();

/// Verdict of one audit: the metric is within both limits, above the first, or above the second or
/// NaN.
enum class Verdict { passed, warned, failed };

/// Result of one audit rule for one run.
struct Audit {
  const AuditRule* rule = nullptr;
  double value = 0;
  Verdict verdict = Verdict::passed;
};

/// Applies the rules to the metrics of a run; a rule whose metric is missing is left out. A NaN
/// fails.
std::vector<Audit> audit(const std::vector<readout::Metric>& metrics);

/// Warnings for the user, one sentence for each audit that has not passed.
std::vector<std::string> audit_warnings(const std::vector<Audit>& audits);

/// Checks that no audit has failed; the results stay in their folder.
/// @param folder of the results, for the message
/// Throws SolverError with the failed audits and their remedies.
void require_sound(const std::vector<Audit>& audits, const std::string& folder);

/// Name of a verdict: "passed", "warned" or "failed".
std::string to_string(Verdict verdict);

} // namespace ionskin::study
