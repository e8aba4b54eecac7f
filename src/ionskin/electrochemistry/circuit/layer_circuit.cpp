// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/circuit/layer_circuit.hpp"

#include <cmath>

namespace ionskin::electrochemistry {
namespace {

/// Computes (1 - exp(-a))/a, which is 1 at 0.
double mean_decay(double a) {
  return std::abs(a) < 1e-8 ? 1.0 - 0.5 * a : -std::expm1(-a) / a;
}

/// Solves dx/dt = drive(t) - rate x over `duration` for a drive that is linear in time.
double driven(double amount, double rate, double duration, double drive_begin, double drive_end) {
  const double a = rate * duration, mean = mean_decay(a);
  // Integral of exp(-a (1 - s)) s over s from 0 to 1.
  const double late = a < 1e-4 ? 0.5 - a / 6 : (1.0 - mean) / a;
  return std::exp(-a) * amount + duration * (mean * drive_begin + late * (drive_end - drive_begin));
}

} // namespace

double relaxed(double amount, double rate, double duration, double source_begin,
               double source_end) {
  return driven(amount, rate, duration, rate * source_begin, rate * source_end);
}

LayerCircuit::LayerCircuit(double capacitance, double resistance,
                           const std::optional<circuits::Admittance>& admittance)
    : capacitance_(capacitance), resistance_(resistance), shorted_(!admittance) {
  if (!admittance) {
    return;
  }
  conductance_ = 1.0 / admittance->resistance;
  parallel_ = admittance->capacitance;
  if (parallel_ == 0) {
    return;
  }
  // d(q, U)/dt = [-p, r; s, -t] (q, U) + S (r, -r/C_ext), whose eigenvalues are real, as r s > 0.
  const double r = 1 / resistance, p = r / capacitance, s = p / parallel_,
               t = (conductance_ + r) / parallel_;
  const double centre = 0.5 * (p + t), radius = std::hypot(0.5 * (t - p), std::sqrt(r * s));
  rate_ = {(p * t - r * s) / (centre + radius), centre + radius};
  for (std::size_t m = 0; m < 2; ++m) {
    from_modes_[m] = r;
    from_modes_[2 + m] = p - rate_[m];
  }
  const double determinant = from_modes_[0] * from_modes_[3] - from_modes_[1] * from_modes_[2];
  to_modes_ = {from_modes_[3] / determinant, -from_modes_[1] / determinant,
               -from_modes_[2] / determinant, from_modes_[0] / determinant};
  for (std::size_t m = 0; m < 2; ++m) {
    drive_[m] = to_modes_[2 * m] * r - to_modes_[2 * m + 1] * r / parallel_;
  }
}

LayerCircuit::State LayerCircuit::start(double force) const {
  return complete(0.0, 0.0, force);
}

LayerCircuit::State LayerCircuit::step(const State& begin, double duration, double force_begin,
                                       double force_end) const {
  if (!shorted_ && parallel_ > 0) {
    double charge = 0, voltage = 0;
    for (std::size_t m = 0; m < 2; ++m) {
      const double mode =
          driven(to_modes_[2 * m] * begin.charge + to_modes_[2 * m + 1] * begin.voltage, rate_[m],
                 duration, drive_[m] * force_begin, drive_[m] * force_end);
      charge += from_modes_[m] * mode;
      voltage += from_modes_[2 + m] * mode;
    }
    return complete(charge, voltage, force_end);
  }
  if (!shorted_ && conductance_ == 0) {
    return complete(0.0, 0.0, force_end);
  }
  const double resistance = resistance_ + (shorted_ ? 0.0 : 1 / conductance_);
  return complete(relaxed(begin.charge, 1 / (resistance * capacitance_), duration,
                          capacitance_ * force_begin, capacitance_ * force_end),
                  0.0, force_end);
}

LayerCircuit::State LayerCircuit::complete(double charge, double voltage, double force) const {
  const double pull = force - charge / capacitance_;
  if (shorted_ || parallel_ > 0) {
    return {charge, voltage, (voltage + pull) / resistance_};
  }
  if (conductance_ == 0) {
    return {0.0, -force, 0.0};
  }
  const double current = pull / (resistance_ + 1 / conductance_);
  return {charge, -current / conductance_, current};
}

} // namespace ionskin::electrochemistry
