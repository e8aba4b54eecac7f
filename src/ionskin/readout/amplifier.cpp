// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/amplifier.hpp"

#include "ionskin/readout/filtered_noise.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace ionskin::readout {

AmplifierReading amplify(const Amplifier& amplifier, const std::vector<double>& time,
                         const std::vector<double>& charge_difference) {
  const double time_constant = 0.5 / (std::numbers::pi * amplifier.bandwidth);
  const double range =
      amplifier.range > 0 ? amplifier.range : std::numeric_limits<double>::infinity();
  FilteredNoise noise(amplifier.noise_density, amplifier.bandwidth,
                      static_cast<std::uint64_t>(amplifier.noise_seed));
  AmplifierReading reading;
  double charge = 0, filtered = charge_difference.front() / time_constant;
  const auto show = [&](double duration) {
    const double output = filtered + noise.value();
    reading.largest = std::max(reading.largest, std::abs(output));
    reading.clipped_time += std::abs(output) > range ? duration : 0.0;
    reading.current.push_back(std::clamp(output, -range, range));
    reading.charge.push_back(charge);
  };
  show(0.0);
  for (std::size_t row = 1; row < time.size(); ++row) {
    const double duration = time[row] - time[row - 1];
    const double input = (charge_difference[row] - charge_difference[row - 1]) / duration;
    const double settled = -std::expm1(-duration / time_constant);
    const double integral =
        input * duration + (filtered - input) * time_constant * settled + noise.advance(duration);
    filtered += (input - filtered) * settled;
    charge += std::clamp(integral, -range * duration, range * duration);
    show(duration);
  }
  return reading;
}

} // namespace ionskin::readout
