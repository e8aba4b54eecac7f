// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace ionskin::electrochemistry {

/// Prescribed potentials of the electrodes [V] as functions of time [s]. Both are 0 by default,
/// which is a short circuit.
struct ElectrodePotentials {
  std::function<double(double time)> top = [](double) { return 0.0; };
  std::function<double(double time)> bottom = [](double) { return 0.0; };
};

} // namespace ionskin::electrochemistry
