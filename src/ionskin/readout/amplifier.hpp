// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/readout/signals.hpp"

#include <vector>

namespace ionskin::readout {

/// What a transimpedance amplifier shows of the short-circuit difference current.
struct AmplifierReading {
  std::vector<double> current; ///< output over the amplification, at the rows [A]
  std::vector<double> charge;  ///< its integral since the start [C]
  double largest = 0;          ///< magnitude before clipping, at the rows [A]
  double clipped_time = 0;     ///< length of the steps that end clipped [s]
};

/// First-order low pass y' = (I - y)/tau, tau = 1/(2 pi bandwidth), solved exactly for a current
/// that is constant over each step, plus its noise; then clipped at +-range. A charge that stands
/// in row 0 is an impulse: y starts at charge/tau. The charge of a step counts the step's mean,
/// clipped.
/// @param time [s]
/// @param charge_difference (Q_top - Q_bottom)/2 under short circuit [C]
AmplifierReading amplify(const Amplifier& amplifier, const std::vector<double>& time,
                         const std::vector<double>& charge_difference);

} // namespace ionskin::readout
