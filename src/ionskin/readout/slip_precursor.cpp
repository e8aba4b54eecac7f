// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/slip_precursor.hpp"

#include "ionskin/readout/sampling.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ionskin::readout {
namespace {

/// The rows between first micro-slip and full slip, with both.
std::vector<double> instants_of(const std::vector<double>& time, const SlipOnset& onset) {
  std::vector<double> instants{onset.micro_slip};
  for (const double instant : time) {
    if (instant > onset.micro_slip && instant < *onset.full_slip) {
      instants.push_back(instant);
    }
  }
  instants.push_back(*onset.full_slip);
  return instants;
}

/// Sums of pairs that last for a while.
class Correlation {
public:
  void add(double x, double y, double duration) {
    weight_ += duration;
    const double from_x = x - mean_x_, from_y = y - mean_y_, share = duration / weight_;
    mean_x_ += share * from_x;
    mean_y_ += share * from_y;
    xx_ += duration * from_x * (x - mean_x_);
    yy_ += duration * from_y * (y - mean_y_);
    xy_ += duration * from_x * (y - mean_y_);
  }
  std::optional<double> coefficient() const {
    return xx_ > 0 && yy_ > 0 ? std::optional(xy_ / std::sqrt(xx_ * yy_)) : std::nullopt;
  }

private:
  double weight_ = 0, mean_x_ = 0, mean_y_ = 0, xx_ = 0, yy_ = 0, xy_ = 0;
};

} // namespace

SlipPrecursor slip_precursor(const std::vector<double>& time, const std::vector<double>& charge,
                             const std::vector<double>& stick_share, const SlipOnset& onset,
                             double interval, double noise) {
  const std::vector<double> instants = instants_of(time, onset);
  const auto charge_at = [&](double instant) { return value_at(time, charge, instant); };
  const auto share_at = [&](double instant) { return value_at(time, stick_share, instant); };
  const auto reading = [&](double instant) {
    return (charge_at(instant) - charge_at(instant - interval)) / interval;
  };
  const double base = reading(onset.micro_slip), seen = seen_above_noise * noise;
  SlipPrecursor result;
  Correlation correlation;
  double before = 0;
  for (std::size_t i = 1; i < instants.size(); ++i) {
    const double from = instants[i - 1], to = instants[i], duration = to - from;
    if (!(duration > 0)) {
      continue;
    }
    const double departure = std::abs(reading(to) - base);
    if (!result.lead_time && departure > seen) {
      const double share = departure > before ? (seen - before) / (departure - before) : 1.0;
      result.lead_time = *onset.full_slip - (from + std::max(0.0, share) * duration);
    }
    result.departure = std::max(result.departure, departure);
    correlation.add((charge_at(to) - charge_at(from)) / duration,
                    0.5 * (share_at(from) + share_at(to)), duration);
    before = departure;
  }
  result.correlation = correlation.coefficient();
  return result;
}

} // namespace ionskin::readout
