// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/friction/return_mapping.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ionskin::laws {
namespace {

constexpr int most_iterations = 60;
constexpr double tolerance = 4 * std::numeric_limits<double>::epsilon();

FrictionArguments arguments(const FrictionTrial& trial, double slip) {
  return {trial.normal_traction, slip, trial.time_step, trial.lagged_speed};
}

/// Solves r = limit(compliance * (length - r)) for the length r of the traction, docs/model.md (6),
/// by Newton's method safeguarded by bisection [Pa].
/// @param length of the trial traction [Pa]
double returned_length(const Friction& friction, const FrictionTrial& trial, double length) {
  double low = 0, high = length;
  double r = std::min(length, friction.limit(arguments(trial, trial.compliance * length)));
  for (int i = 0; i < most_iterations && high - low > tolerance * length; ++i) {
    const FrictionArguments at = arguments(trial, trial.compliance * (length - r));
    const double excess = r - friction.limit(at);
    (excess > 0 ? high : low) = r;
    const double next = r - excess / (1 + trial.compliance * friction.limit_slip_slope(at));
    if (std::abs(next - r) <= tolerance * length) {
      break;
    }
    r = next > low && next < high ? next : 0.5 * (low + high);
  }
  return r;
}

/// Return mapping for a limit that is the same in all directions: the trial traction is scaled to
/// the length `shortened`. Derivatives: docs/model.md (7).
/// @param length of the trial traction [Pa]
/// @param shortened length of the resulting traction [Pa]
FrictionResponse returned_radially(const Friction& friction, const FrictionTrial& trial,
                                   double length, double shortened) {
  const TangentialVector e =
      length > 0 ? TangentialVector{trial.traction[0] / length, trial.traction[1] / length}
                 : TangentialVector{};
  const FrictionArguments at =
      arguments(trial, trial.compliance * std::max(0.0, length - shortened));
  const double stiffening = trial.compliance * friction.limit_slip_slope(at);
  const double along = stiffening / (1 + stiffening);
  const double turning = length > 0 ? std::min(1.0, shortened / length) : along;
  const double slope = friction.limit_slope(at) / (1 + stiffening);
  FrictionResponse response;
  for (std::size_t r = 0; r < 2; ++r) {
    response.traction[r] = shortened * e[r];
    response.by_normal[r] = slope * e[r];
    for (std::size_t s = 0; s < 2; ++s) {
      response.by_trial[r][s] = turning * (r == s ? 1.0 : 0.0) + (along - turning) * e[r] * e[s];
    }
  }
  return response;
}

/// Multiplier m of the projection of a point z outside an ellipse to the nearest point t of the
/// ellipse: t_i = z_i a_i^2 / (a_i^2 + m).
/// @param axes semi-axes a_i of the ellipse
double ellipse_multiplier(const TangentialVector& z, const TangentialVector& axes) {
  double m = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    m = std::max(m, axes[i] * (std::abs(z[i]) - axes[i]));
  }
  for (int i = 0; i < most_iterations; ++i) {
    double square = 0, slope = 0;
    for (std::size_t c = 0; c < 2; ++c) {
      const double below = axes[c] * axes[c] + m, part = z[c] * axes[c] / below;
      square += part * part;
      slope += part * part / below;
    }
    // Newton's method for 1 / sqrt(square) = 1, whose left side is nearly linear in m and concave.
    const double step = (std::sqrt(square) - 1) * square / slope;
    m += step;
    if (!(std::abs(step) > tolerance * m)) {
      break;
    }
  }
  return m;
}

/// Return mapping for limits that form an ellipse: the nearest point of the ellipse, so that slip
/// is normal to it. A trial traction inside is scaled to the ellipse.
/// @param limit semi-axis of the ellipse along x [Pa]
FrictionResponse returned_to_ellipse(const Friction& friction, const FrictionTrial& trial,
                                     double limit) {
  const FrictionArguments at = arguments(trial, 0);
  const double slope = friction.limit_slope(at);
  const TangentialVector& z = trial.traction;
  const double norm = limit_norm(friction, z);
  FrictionResponse response;
  if (limit <= 0 || norm <= limit) {
    const double scale = norm > 0 ? 1 / norm : 0;
    const double length = std::hypot(z[0], z[1]);
    for (std::size_t r = 0; r < 2; ++r) {
      response.traction[r] = limit * scale * z[r];
      response.by_normal[r] = slope * scale * z[r];
      for (std::size_t s = 0; s < 2 && limit > 0; ++s) {
        response.by_trial[r][s] =
            (r == s ? 1.0 : 0.0) - (length > 0 ? z[r] / length * z[s] / length : 0.0);
      }
    }
    return response;
  }
  const TangentialVector axes{limit, limit * friction.across};
  const double m = ellipse_multiplier(z, axes);
  TangentialVector by_trial_of_m{};
  double divisor = 0;
  for (std::size_t c = 0; c < 2; ++c) {
    const double square = axes[c] * axes[c], below = square + m;
    response.traction[c] = z[c] * square / below;
    by_trial_of_m[c] = z[c] * square / (below * below);
    divisor += z[c] * by_trial_of_m[c] / below;
  }
  for (std::size_t r = 0; r < 2; ++r) {
    const double below = axes[r] * axes[r] + m;
    double moved = 0;
    for (std::size_t s = 0; s < 2; ++s) {
      response.by_trial[r][s] = (r == s ? axes[r] * axes[r] / below : 0.0) -
                                response.traction[r] / below * by_trial_of_m[s] / divisor;
      moved += response.by_trial[r][s] * z[s];
    }
    // Scaling trial and limit by one factor scales the traction by the same factor.
    response.by_normal[r] = slope * (response.traction[r] - moved) / limit;
  }
  return response;
}

FrictionResponse returned(const Friction& friction, const FrictionTrial& trial, bool slips) {
  const double held = friction.limit(arguments(trial, 0));
  const double norm = limit_norm(friction, trial.traction);
  if (!slips && held > 0 && norm <= held) {
    FrictionResponse response;
    response.sticks = true;
    response.traction = trial.traction;
    response.by_trial = {{{1, 0}, {0, 1}}};
    return response;
  }
  if (friction.across != 1) {
    return returned_to_ellipse(friction, trial, held);
  }
  const bool sought = friction.slip_dependent && norm > held;
  return returned_radially(friction, trial, norm,
                           sought ? returned_length(friction, trial, norm) : held);
}

} // namespace

double limit_norm(const Friction& friction, const TangentialVector& traction) {
  return std::hypot(traction[0], traction[1] / friction.across);
}

TangentialVector sliding_traction(const Friction& friction, double limit,
                                  const TangentialVector& direction) {
  const double across = friction.across * friction.across * direction[1];
  const double length = std::hypot(direction[0], friction.across * direction[1]);
  return length > 0 ? TangentialVector{limit * direction[0] / length, limit * across / length}
                    : TangentialVector{};
}

FrictionResponse return_mapping(const Friction& friction, const FrictionTrial& trial, bool slips) {
  if (friction.elastic_slip == 0) {
    return returned(friction, trial, slips);
  }
  // The updated elastic slip, docs/model.md (45), equals the slip of a cell whose compliance is
  // `taken` times as large and whose trial traction is larger by the kept elastic slip over that
  // compliance. Both changes depend on the normal traction.
  const ElasticStep step = elastic_step(friction, trial.elastic, arguments(trial, 0));
  FrictionTrial whole = trial;
  whole.compliance *= step.taken;
  for (std::size_t c = 0; c < 2; ++c) {
    whole.traction[c] += step.kept * trial.elastic.slip[c] / whole.compliance;
  }
  FrictionResponse response = returned(friction, whole, slips);
  for (std::size_t s = 0; s < 2; ++s) {
    const double moved =
        0.5 * step.kept_by_normal / step.taken *
        (trial.elastic.slip[s] / whole.compliance + whole.traction[s] - response.traction[s]);
    for (std::size_t r = 0; r < 2; ++r) {
      response.by_normal[r] += response.by_trial[r][s] * moved;
    }
  }
  return response;
}

} // namespace ionskin::laws
