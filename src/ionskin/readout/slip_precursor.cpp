// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/slip_precursor.hpp"

#include "ionskin/base/value_at.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ionskin::readout {
namespace {

/// Instants of the rows between two instants, with these two at the ends [s].
std::vector<double> instants_between(const std::vector<double>& time, double from, double to) {
  std::vector<double> instants{from};
  for (const double instant : time) {
    if (instant > from && instant < to) {
      instants.push_back(instant);
    }
  }
  instants.push_back(to);
  return instants;
}

/// Pearson correlation of pairs of values, each weighted with its duration.
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

/// Charge and sticking share, linear between the rows.
struct Rows {
  const std::vector<double>&time, &charge, &share;

  double charge_at(double instant) const { return base::value_at(time, charge, instant); }
  double share_at(double instant) const { return base::value_at(time, share, instant); }
};

void correlate(const Rows& rows, const SlipOnset& onset, SlipPrecursor& result) {
  const auto instants = instants_between(rows.time, onset.micro_slip, *onset.full_slip);
  const double before = rows.charge_at(onset.micro_slip);
  Correlation correlation;
  for (std::size_t i = 1; i < instants.size(); ++i) {
    const double from = instants[i - 1], to = instants[i], gained = rows.charge_at(to);
    if (to > from) {
      correlation.add((gained - rows.charge_at(from)) / (to - from),
                      0.5 * (rows.share_at(from) + rows.share_at(to)), to - from);
      result.charge = std::max(result.charge, std::abs(gained - before));
    }
  }
  result.correlation = correlation.coefficient();
}

void read(const Rows& rows, const SlipOnset& onset, double interval, double noise,
          SlipPrecursor& result) {
  const double first = std::max(onset.micro_slip, onset.begin + interval), full = *onset.full_slip;
  if (first >= full) {
    return;
  }
  const auto reading = [&](double instant) {
    return (rows.charge_at(instant) - rows.charge_at(instant - interval)) / interval;
  };
  const double base = reading(first), seen = seen_above_noise * noise;
  const auto instants = instants_between(rows.time, first, full);
  result.departure = 0;
  double before = 0;
  for (std::size_t i = 1; i < instants.size(); ++i) {
    const double from = instants[i - 1], to = instants[i];
    const double departure = std::abs(reading(to) - base);
    if (!result.lead_time && departure > seen) {
      result.lead_time = full - (from + (to - from) * (seen - before) / (departure - before));
    }
    result.departure = std::max(*result.departure, departure);
    before = departure;
  }
}

} // namespace

SlipPrecursor slip_precursor(const std::vector<double>& time, const std::vector<double>& charge,
                             const std::vector<double>& stick_share, const SlipOnset& onset,
                             double interval, double noise) {
  const Rows rows{time, charge, stick_share};
  SlipPrecursor result;
  correlate(rows, onset, result);
  read(rows, onset, interval, noise, result);
  return result;
}

} // namespace ionskin::readout
