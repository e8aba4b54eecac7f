// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/checks/check_sizes.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/run_duration.hpp"

#include <fmt/format.h>

#include <optional>

namespace ionskin {

namespace {

/// Largest number of rows of sampled.csv. They take 0.2 GB on disk, and several columns of doubles
/// in memory.
constexpr double most_readings = 2e6;
constexpr std::size_t most_fields = 10'000;
/// Largest number of legs in all cycles. The strain history has about fifty samples in each leg.
constexpr double most_legs = 2e5;

std::string too_many_readings(const Readout& readout, double duration) {
  return fmt::format("readout.sample_interval = {:.6g} s makes {:.3g} readings over the run of "
                     "{:.6g} s, more than {:.0f}",
                     readout.sample_interval, duration / readout.sample_interval, duration,
                     most_readings);
}

std::string remedy_of_readings(double duration) {
  return fmt::format("it must be at least {:.3g} s; the resolved signals in signals.csv hold every "
                     "time step",
                     duration / most_readings);
}

double legs_of_cycle(const Motion& motion) {
  switch (motion.kind) {
  case MotionKind::touch_slide_lift:
    return 4;
  case MotionKind::reciprocating:
    return 3 + (motion.dwell > 0 ? 2.0 : 1.0) * motion.strokes;
  case MotionKind::waypoints:
    break;
  }
  return static_cast<double>(motion.waypoints.size());
}

} // namespace

void check_sizes(const CaseDocument& document, Problems& problems) {
  const Case& input = document.input;
  const std::size_t fields = input.output.fields.size();
  if (fields > most_fields)
    problems.add(fmt::format("output.fields has {} instants", fields),
                 document.point_at("output.fields"),
                 fmt::format("it may have at most {}", most_fields));
  const std::optional<double> duration = run_duration(input);
  if (!duration)
    return;
  const double legs = input.strain.kind == StrainSourceKind::contact
                          ? legs_of_cycle(input.motion) * input.motion.cycles
                          : 0.0;
  if (legs > most_legs)
    problems.add(
        fmt::format("the run has {:.0f} legs of motion in {} cycles, more than {:.0f}", legs,
                    input.motion.cycles, most_legs),
        document.point_at("motion.cycles"),
        legs_of_cycle(input.motion) > most_legs
            ? fmt::format("leave out waypoints that lie on the way between their neighbours: a "
                          "cycle may have at most {:.0f}",
                          most_legs)
            : fmt::format("motion.cycles may be at most {:.0f} here: the response repeats itself "
                          "after a few cycles",
                          most_legs / legs_of_cycle(input.motion)));
  if (!(*duration / input.readout.sample_interval <= most_readings))
    problems.add(too_many_readings(input.readout, *duration),
                 document.point_at("readout.sample_interval"), remedy_of_readings(*duration));
  if (input.readout.scan.dwell > 0 && *duration / input.readout.scan.dwell > most_scan_switches)
    problems.add(fmt::format("readout.scan.dwell = {:.6g} s makes {:.3g} switches over the run of "
                             "{:.6g} s, more than {:.0f}",
                             input.readout.scan.dwell, *duration / input.readout.scan.dwell,
                             *duration, most_scan_switches),
                 document.point_at("readout.scan.dwell"),
                 fmt::format("it must be at least {:.3g} s: the solver starts anew at each",
                             *duration / most_scan_switches));
}

void require_sampling(const Readout& readout, double duration) {
  if (!(duration / readout.sample_interval <= most_readings))
    throw UserError(fmt::format("{}\n  = {}", too_many_readings(readout, duration),
                                remedy_of_readings(duration)));
}

} // namespace ionskin
