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

namespace ionskin::circuits {

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
  double largest = 0, shown = 0, clipped_time = 0;
  const auto show = [&](double duration) {
    const double output = filtered + filtered_noise.value();
    largest = std::max(largest, std::abs(output));
    clipped_time += std::abs(output) > limit ? duration : 0.0;
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
    filtered += (input - filtered) * settled;
    charge += std::clamp(integral, -limit * duration, limit * duration);
    show(duration);
  }
  reading.figures = {{"peak_amplifier_current", shown, "A"},
                     {"amplifier_clipped_time", clipped_time, "s"}};
  if (clipped_time > 0) {
    reading.warnings.push_back(fmt::format(
        "The amplifier clips: the current reaches {:.3g} A, its range {:.3g} A, for {:.3g} s in "
        "all. Raise readout.amplifier_range.",
        largest, range, clipped_time));
  }
  return reading;
}

} // namespace ionskin::circuits
