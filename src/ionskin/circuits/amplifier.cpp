// SPDX-License-Identifier: Apache-2.0
#include "ionskin/circuits/amplifier.hpp"

#include "ionskin/circuits/filtered_noise.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

namespace ionskin::circuits {
namespace {

/// Output of the amplifier over one step. It moves from `begin` to `end` as the low pass moves
/// under a constant input: exactly so without noise, which is known at the rows alone.
class OutputStep {
public:
  /// @param begin, end output at the ends of the step [A]
  /// @param duration of the step [s]
  /// @param time_constant of the low pass [s]
  OutputStep(double begin, double end, double duration, double time_constant)
      : begin_(begin), end_(end), duration_(duration), time_constant_(time_constant) {}

  /// Time outside +-limit [s].
  double time_beyond(double limit) const {
    return time_above(limit) + mirrored().time_above(limit);
  }
  /// Charge that clipping at +-limit takes from this step beyond what it takes from a constant
  /// output of the same mean, less what it takes from the other sign [C].
  double charge_of_parts_beyond(double limit) const {
    return charge_of_part_above(limit) - mirrored().charge_of_part_above(limit);
  }

private:
  OutputStep mirrored() const { return {-begin_, -end_, duration_, time_constant_}; }
  double settled(double time) const { return -std::expm1(-time / time_constant_); }
  double change() const { return (end_ - begin_) / settled(duration_); }
  /// True if the output passes the limit within the step.
  bool crosses(double limit) const { return (begin_ > limit) != (end_ > limit); }
  /// Time from the beginning of the step to the crossing of the limit [s].
  double crossing(double limit) const {
    return std::min(duration_, -time_constant_ * std::log1p((begin_ - limit) / change()));
  }
  double time_above(double limit) const {
    if (!crosses(limit)) {
      return begin_ > limit ? duration_ : 0.0;
    }
    return end_ > limit ? duration_ - crossing(limit) : crossing(limit);
  }
  /// Integral of the output less a limit, from the beginning of the step on [C].
  double integral_above(double limit, double time) const {
    return (begin_ - limit) * time + change() * (time - time_constant_ * settled(time));
  }
  double charge_of_part_above(double limit) const {
    if (!crosses(limit)) {
      return 0;
    }
    const double whole = integral_above(limit, duration_),
                 before = integral_above(limit, crossing(limit));
    return (end_ > limit ? whole - before : before) - std::max(0.0, whole);
  }

  double begin_ = 0, end_ = 0, duration_ = 0, time_constant_ = 0;
};

} // namespace

std::string Amplifier::words() const {
  return fmt::format("amplifier of {:.4g} Hz", bandwidth);
}

InstrumentReading Amplifier::read(const std::vector<double>& time,
                                  const std::vector<double>& charge_difference) const {
  const double time_constant = 0.5 / (std::numbers::pi * bandwidth);
  const double limit = range > 0 ? range : std::numeric_limits<double>::infinity();
  FilteredNoise filtered_noise(noise_density, bandwidth, static_cast<std::uint64_t>(noise_seed));
  InstrumentReading reading;
  double charge = 0, filtered = charge_difference.front() / time_constant;
  double output = filtered + filtered_noise.value();
  double largest = 0, shown = 0, clipped_time = 0;
  const auto show = [&](double duration) {
    const double before = std::exchange(output, filtered + filtered_noise.value());
    largest = std::max(largest, std::abs(output));
    clipped_time += OutputStep(before, output, duration, time_constant).time_beyond(limit);
    reading.current.push_back(std::clamp(output, -limit, limit));
    shown = std::fmax(shown, std::abs(reading.current.back()));
    reading.charge.push_back(charge);
  };
  show(0.0);
  for (std::size_t row = 1; row < time.size(); ++row) {
    const double duration = time[row] - time[row - 1];
    const double input = (charge_difference[row] - charge_difference[row - 1]) / duration;
    const double settled = -std::expm1(-duration / time_constant);
    const double integral = input * duration + (filtered - input) * time_constant * settled +
                            filtered_noise.advance(duration);
    const double before = std::exchange(filtered, filtered + (input - filtered) * settled);
    charge += std::clamp(integral, -limit * duration, limit * duration) -
              OutputStep(before, filtered, duration, time_constant).charge_of_parts_beyond(limit);
    show(duration);
  }
  reading.figures = {{"peak_amplifier_current", shown, "A"},
                     {"amplifier_clipped_time", clipped_time, "s"}};
  if (largest > limit) {
    reading.warnings.push_back(fmt::format(
        "The amplifier clips: the current reaches {:.3g} A, its range {:.3g} A, for {:.3g} s in "
        "all. Raise readout.amplifier_range.",
        largest, range, clipped_time));
  }
  return reading;
}

} // namespace ionskin::circuits
