// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace ionskin::electrochemistry {

/// Potentials of the electrodes against time [V]; both 0 is the short circuit.
struct ElectrodePotentials {
  std::function<double(double time)> top = [](double) { return 0.0; };
  std::function<double(double time)> bottom = [](double) { return 0.0; };
};

} // namespace ionskin::electrochemistry
