// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/metrics/audits.hpp"

#include "ionskin/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ionskin::study {
namespace {

std::string sentence(const Audit& audit) {
  return fmt::format("{} is {:.2g}", audit.rule->what, audit.value);
}

} // namespace

const std::vector<AuditRule>& audit_rules() {
  static const std::vector<AuditRule> rules{
      {"equilibrium_residual", 5e-3, 5e-2,
       "the difference of the forces through the core from those of the contact "
       "(equilibrium_residual)",
       "bring the moduli and thicknesses of the layers closer to each other, or keep the slider "
       "further from the skin's edges"},
      {"complementarity_residual", 1e-6, 1e-2,
       "the violation of the contact's and friction's conditions (complementarity_residual)",
       "lower contact.friction, or change numerics.mesh_refinement"},
      {"energy_balance_error", 0.02, 0.2,
       "the energy that the steps of contact gain or lose (energy_balance_error)",
       "choose a finer numerics.preset, or raise numerics.time_refinement"},
      {"energy_creation_error", 1e-6, 1e-3,
       "the energy that friction creates, where it may only take (energy_creation_error)",
       "choose another contact.law: this one gives back more than it took"},
      {"largest_p99_shear", 0.1, 1.0,
       "the largest 99th percentile of the core's shear (largest_p99_shear), for which strains are "
       "taken as small,",
       "lower motion.preload or contact.friction, or choose stiffer layers: the model holds for "
       "small "
       "strains"},
      {"slider_strain_slide", 0.15, 1.0,
       "the strain of the soft slider, mean pressure over its plane modulus (slider_strain_slide),",
       "lower motion.preload, or raise slider.youngs_modulus: the slider is a half-space under "
       "small strains"},
      {"charge_identity_error", 1e-6, 1e-2,
       "the electrodes' charge beyond that of the shear (charge_identity_error)",
       "raise numerics.mesh_refinement, or lower numerics.time_tolerance"}};
  return rules;
}

std::vector<Audit> audit(const std::vector<readout::Metric>& metrics) {
  std::vector<Audit> audits;
  for (const AuditRule& rule : audit_rules()) {
    const auto metric = std::ranges::find(metrics, rule.metric, &readout::Metric::name);
    if (metric == metrics.end()) {
      continue;
    }
    // Comparisons with NaN are false, so that NaN fails.
    const Verdict verdict = metric->value <= rule.warn   ? Verdict::passed
                            : metric->value <= rule.fail ? Verdict::warned
                                                         : Verdict::failed;
    audits.push_back({&rule, metric->value, verdict});
  }
  return audits;
}

std::vector<std::string> audit_warnings(const std::vector<Audit>& audits) {
  std::vector<std::string> warnings;
  for (const Audit& one : audits) {
    if (one.verdict == Verdict::warned) {
      warnings.push_back(fmt::format("Audit: {}, above {:.2g}. To mend it, {}.", sentence(one),
                                     one.rule->warn, one.rule->remedy));
    } else if (one.verdict == Verdict::failed) {
      warnings.push_back(fmt::format("FAILED AUDIT: {}, above {:.2g}: these results are not to be "
                                     "used. To mend it, {}.",
                                     sentence(one), one.rule->fail, one.rule->remedy));
    }
  }
  return warnings;
}

void require_sound(const std::vector<Audit>& audits, const std::string& folder) {
  std::string problems, remedy;
  for (const Audit& one : audits) {
    if (one.verdict == Verdict::failed) {
      problems += fmt::format("{}{}, above {:.2g}", problems.empty() ? "" : "; ", sentence(one),
                              one.rule->fail);
      remedy += (remedy.empty() ? "" : "; ") + std::string(one.rule->remedy);
    }
  }
  if (!problems.empty()) {
    throw SolverError(fmt::format("the results do not pass their audits: {}; they are kept in {}, "
                                  "marked as failed",
                                  problems, folder),
                      remedy);
  }
}

std::string to_string(Verdict verdict) {
  return verdict == Verdict::passed ? "passed" : verdict == Verdict::warned ? "warned" : "failed";
}

} // namespace ionskin::study
