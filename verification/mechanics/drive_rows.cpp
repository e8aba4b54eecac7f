// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/compliant_drive.hpp"
#include "ionskin/mechanics/solve_contact.hpp"
#include "mechanics/baseline_case.hpp"
#include "mechanics/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ionskin::verification {
namespace {

using mechanics::CompliantDrive;
using mechanics::DriveEnd;
using mechanics::LoadKind;
using mechanics::SlidingContact;

/// Textbook case of stick-slip: a block on a stiff table, drawn by a spring.
namespace block {

constexpr double normal_force = 1; // [N]
constexpr double speed = 5e-3;     // of the drive's end [m/s]
constexpr double duration = 2.5;   // [s]
constexpr double settled = 0.8;    // from here on one cycle is like the other [s]
constexpr double static_friction = 0.4, kinetic_friction = 0.2;
constexpr double stribeck_speed = 2e-3, lag_time = 2e-3; // [m/s], [s]
constexpr Drive drive{200, 0.2, 5e-3};

double coefficient_at(double lagged_speed) {
  return kinetic_friction + (static_friction - kinetic_friction) *
                                std::exp(-std::pow(lagged_speed / stribeck_speed, 2));
}

laws::Friction friction() {
  return laws::friction("stribeck", static_friction,
                        {{"kinetic_friction", kinetic_friction},
                         {"stribeck_speed", stribeck_speed},
                         {"lag_time", lag_time}});
}

} // namespace block

/// Stick-slip of a solution: mean time between the peaks of the drive's force, and mean height of
/// the peaks over the valleys.
struct StickSlip {
  double period = 0;    ///< mean time between peaks [s]
  double amplitude = 0; ///< mean height of the peaks over the valleys [N]
};

class PeakCounter {
public:
  void add(double time, double force) {
    if (time >= block::settled) {
      lowest_ = std::min(lowest_, force);
      // The damper's force has small peaks of its own where the block catches.
      constexpr double low =
          0.5 * (block::static_friction + block::kinetic_friction) * block::normal_force;
      if (count_ >= 2 && last_ > low && last_ > before_ && last_ >= force) {
        add_peak(time, force);
      }
      ++count_;
    }
    before_ = last_;
    time_before_ = last_time_;
    last_ = force;
    last_time_ = time;
  }
  StickSlip mean() const {
    const auto cycles = static_cast<double>(peaks_ - 1);
    return {(last_peak_ - first_peak_) / cycles, heights_ / cycles};
  }

private:
  /// Adds a peak of the force, that of the parabola through the last three instants, if there is
  /// one.
  void add_peak(double time, double force) {
    const double left = last_time_ - time_before_, right = time - last_time_;
    const double rise = (last_ - before_) / left, fall = (force - last_) / right;
    const double curvature = 2 * (fall - rise) / (left + right);
    const double slope = (rise * right + fall * left) / (left + right);
    const double peak = last_time_ - slope / curvature;
    if (peaks_++ == 0) {
      first_peak_ = peak;
    } else {
      heights_ += last_ - 0.5 * slope * slope / curvature - lowest_;
    }
    last_peak_ = peak;
    lowest_ = force;
  }

  double before_ = 0, last_ = 0, time_before_ = 0, last_time_ = 0, lowest_ = 1e300;
  double first_peak_ = 0, last_peak_ = 0, heights_ = 0;
  int count_ = 0, peaks_ = 0;
};

/// Reference solution: the block's ordinary differential equation in steps of a microsecond, by the
/// classical Runge-Kutta method while it slips; while it sticks, it stands still until the pull
/// exceeds static friction.
StickSlip reference() {
  constexpr double step = 1e-6;
  using State = std::array<double, 3>; // place, speed, lagged speed
  State now{0, 0, 0};
  const auto pull = [](double time, const State& at) {
    return block::drive.stiffness * (block::speed * time - at[0]) +
           block::drive.damping * (block::speed - at[1]);
  };
  const auto rate = [&](double time, const State& at) {
    return State{at[1],
                 (pull(time, at) - block::coefficient_at(at[2]) * block::normal_force) /
                     block::drive.mass,
                 (std::max(0.0, at[1]) - at[2]) / block::lag_time};
  };
  const auto moved = [](const State& from, double by, const State& along) {
    return State{from[0] + by * along[0], from[1] + by * along[1], from[2] + by * along[2]};
  };
  PeakCounter peaks;
  bool sticks = true;
  const auto steps = static_cast<int>(std::lround(block::duration / step));
  for (int i = 0; i < steps; ++i) {
    const double time = i * step;
    peaks.add(time, pull(time, now));
    sticks = sticks && pull(time, now) <= block::coefficient_at(now[2]) * block::normal_force;
    if (sticks) {
      now[2] *= std::exp(-step / block::lag_time);
      continue;
    }
    const State a = rate(time, now);
    const State b = rate(time + step / 2, moved(now, step / 2, a));
    const State c = rate(time + step / 2, moved(now, step / 2, b));
    const State d = rate(time + step, moved(now, step, c));
    for (std::size_t j = 0; j < now.size(); ++j) {
      now[j] += step / 6 * (a[j] + 2 * b[j] + 2 * c[j] + d[j]);
    }
    if (now[1] <= 0) {
      sticks = true;
      now[1] = 0;
    }
  }
  return peaks.mean();
}

/// Stick-slip by the contact engine, with equal steps, on a skin of one stiff cell.
StickSlip in_steps(double step) {
  const Eigen::MatrixXd stiff = 1e-10 * Eigen::MatrixXd::Identity(3, 3);
  SlidingContact contact([&](const auto&, auto& problem) { problem.compliance = stiff; }, {1e-6},
                         {0.0}, block::friction());
  CompliantDrive slider(block::drive, 1, {true, false});
  contact.step(1, {0, 0}, {LoadKind::force, block::normal_force});
  slider.hold({});
  PeakCounter peaks;
  const auto steps = static_cast<int>(std::lround(block::duration / step));
  for (int i = 1; i <= steps; ++i) {
    const DriveEnd end{{block::speed * i * step, 0}, {block::speed, 0}};
    contact.step_yielding(step, slider.guide(step, end), {LoadKind::force, block::normal_force});
    slider.accept(step, contact.place(), end);
    peaks.add(i * step, slider.force(end)[0]);
  }
  return peaks.mean();
}

/// Stick-slip of the block as a case: a flat slider on a skin that is stiff throughout, with steps
/// that are chosen automatically.
StickSlip as_case(double time_refinement, const Options& options) {
  Case input = baseline_case();
  for (Layer& layer : input.skin.layers) {
    layer.material = {"stiff", 1e11, 0.3};
  }
  input.skin.length = 20e-3;
  input.slider.size = {1e-3, 0.8e-3};
  input.slider.start = {2e-3, 1e-3};
  input.motion.preload = 0;
  input.motion.preload_force = block::normal_force;
  input.motion.stroke = block::speed * block::duration;
  input.motion.slide = block::duration;
  input.motion.drive = block::drive;
  input.contact.law = "stribeck";
  input.contact.friction = block::static_friction;
  input.contact.parameters = {{"kinetic_friction", block::kinetic_friction},
                              {"stribeck_speed", block::stribeck_speed},
                              {"lag_time", block::lag_time}};
  input.numerics.mesh_refinement = 0.5;
  input.numerics.time_refinement = time_refinement;
  mechanics::ContactOptions contact;
  contact.threads = options.threads;
  base::Timers timers;
  const auto solution = mechanics::solve_contact(input, contact, timers);
  PeakCounter peaks;
  for (const mechanics::SteppedInstant& instant : solution.stepped) {
    const double time = instant.time - input.motion.touchdown;
    if (instant.state && time < block::duration) {
      peaks.add(time, instant.drive_force[0]);
    }
  }
  return peaks.mean();
}

double observed_order(double coarse, double middle, double fine) {
  return std::log2(std::abs((middle - coarse) / (fine - middle)));
}

} // namespace

std::vector<Row> drive_rows(const Options& options) {
  options.progress("mechanics: slider on a drive", 0);
  const StickSlip exact = reference();
  options.progress("mechanics: slider on a drive", 0.3);
  std::vector<Row> rows;
  std::array<StickSlip, 3> stepped;
  double step = 0.4e-3;
  for (StickSlip& at : stepped) {
    at = in_steps(step);
    const double bound = 2e-3 * std::pow(step / 0.4e-3, 2);
    rows.push_back(at_most("M14",
                           fmt::format("stick-slip of a block, steps of {:.1f} ms: period against "
                                       "a differential equation, relative",
                                       step * 1e3),
                           std::abs(at.period / exact.period - 1), bound));
    rows.push_back(at_most("M14",
                           fmt::format("stick-slip of a block, steps of {:.1f} ms: amplitude of "
                                       "the drive's force, relative",
                                       step * 1e3),
                           std::abs(at.amplitude / exact.amplitude - 1), bound));
    step /= 2;
  }
  rows.push_back(at_least("M14", "stick-slip of a block: observed order of the period",
                          observed_order(stepped[0].period, stepped[1].period, stepped[2].period),
                          1.8));
  rows.push_back(at_least(
      "M14", "stick-slip of a block: observed order of the amplitude",
      observed_order(stepped[0].amplitude, stepped[1].amplitude, stepped[2].amplitude), 1.8));
  options.progress("mechanics: slider on a drive", 0.4);
  for (const double refinement : {1.0, 2.0}) {
    const StickSlip at = as_case(refinement, options);
    rows.push_back(compare(
        "M14", fmt::format("stick-slip of a case, time_refinement {:.0f}: period [s]", refinement),
        at.period, exact.period, 0.01 * exact.period / refinement));
    rows.push_back(compare(
        "M14",
        fmt::format("stick-slip of a case, time_refinement {:.0f}: amplitude [N]", refinement),
        at.amplitude, exact.amplitude, 0.01 * exact.amplitude / refinement));
  }
  options.progress("mechanics: slider on a drive", 1);
  return rows;
}

} // namespace ionskin::verification
