// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/friction/elastic_slip.hpp"

#include <cmath>

namespace ionskin::laws {

ElasticStep elastic_step(const Friction& friction, const ElasticSlip& before,
                         const FrictionArguments& at) {
  FrictionArguments full = at;
  full.slip_increment = friction.elastic_slip;
  ElasticStep step{.limit = friction.limit(full)};
  if (before.limit >= step.limit) {
    return step;
  }
  step.kept = before.limit / step.limit;
  step.taken = 0.5 * (1 + step.kept);
  step.kept_by_normal = -step.kept * friction.limit_slope(full) / step.limit;
  return step;
}

TangentialVector slip_of_limit(const Friction& friction, const ElasticSlip& before,
                               const FrictionArguments& at, const TangentialVector& slip) {
  if (friction.elastic_slip == 0) {
    return slip;
  }
  const ElasticStep step = elastic_step(friction, before, at);
  return {step.kept * before.slip[0] + step.taken * slip[0],
          step.kept * before.slip[1] + step.taken * slip[1]};
}

SlipDivision divided_slip(const Friction& friction, const ElasticSlip& before,
                          const FrictionArguments& at, const TangentialVector& slip) {
  if (friction.elastic_slip == 0 || at.normal_traction <= 0) {
    return {{}, std::hypot(slip[0], slip[1])};
  }
  const ElasticStep step = elastic_step(friction, before, at);
  const TangentialVector all = slip_of_limit(friction, before, at, slip);
  const double length = std::hypot(all[0], all[1]), most = friction.elastic_slip;
  if (length <= most) {
    return {{all, step.limit}, 0};
  }
  return {{{most / length * all[0], most / length * all[1]}, step.limit},
          (length - most) / step.taken};
}

double stored_energy(const Friction& friction, const ElasticSlip& elastic) {
  const double square = elastic.slip[0] * elastic.slip[0] + elastic.slip[1] * elastic.slip[1];
  return square > 0 ? 0.5 * elastic.limit / friction.elastic_slip * square : 0.0;
}

} // namespace ionskin::laws
