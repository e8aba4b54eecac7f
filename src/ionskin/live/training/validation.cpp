// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/training/validation.hpp"

#include "ionskin/handover/contact_timeline.hpp"
#include "ionskin/live/skin.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace ionskin::live {
namespace {

constexpr double interval = 1e-3; // between steps [s]

double at_time(const std::vector<double>& times, const std::vector<double>& values, double time) {
  const auto next = std::ranges::upper_bound(times, time);
  if (next == times.begin() || next == times.end()) {
    return next == times.begin() ? values.front() : values.back();
  }
  const auto i = static_cast<std::size_t>(next - times.begin());
  const double weight = (time - times[i - 1]) / (times[i] - times[i - 1]);
  return (1 - weight) * values[i - 1] + weight * values[i];
}

bool presses_by_force(const Motion& motion) {
  return std::ranges::any_of(motion.waypoints,
                             [](const Waypoint& point) { return point.force.has_value(); });
}

class Comparison {
public:
  void add(const std::string& name, double value, double reference) {
    Sums& sums = sums_[name];
    const double error = value - reference;
    sums.square += error * error;
    sums.count += 1;
    sums.worst = std::max(sums.worst, std::abs(error));
    sums.largest = std::max(sums.largest, std::abs(reference));
  }
  std::vector<SignalError> errors() const {
    std::vector<SignalError> result;
    for (const auto& [name, sums] : sums_) {
      result.push_back({name, std::sqrt(sums.square / sums.count), sums.worst, sums.largest});
    }
    return result;
  }

private:
  struct Sums {
    double square = 0, count = 0, worst = 0, largest = 0;
  };
  std::map<std::string, Sums> sums_;
};

} // namespace

std::vector<SignalError> validate(const SkinData& data, const FullRun& run) {
  Skin skin(data);
  const std::vector<std::string>& names = skin.names();
  std::vector<double> signals(names.size());
  const auto column = [&](const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  };
  const handover::ContactTimeline timeline(run.input, run.contact);
  const bool by_force = presses_by_force(run.input.motion);
  const auto& ions = run.ions;
  const double end = ions.time.back(), sampling = run.input.readout.sample_interval;
  const auto per_sample = static_cast<std::size_t>(std::max(1.0, std::round(sampling / interval)));
  std::map<std::string, std::pair<double, double>> sampled; // charges at the last sample
  Comparison comparison;
  for (std::size_t step = 0; static_cast<double>(step) * interval <= end; ++step) {
    const double time = static_cast<double>(step) * interval;
    const handover::StateCombination at = timeline.at(time);
    const double force = at.normal_force();
    skin.step(time, at.centre, by_force, by_force ? force : at.height, signals);
    comparison.add("normal_force", signals[column("normal_force")], force);
    const auto tangential = at.tangential_force();
    comparison.add("tangential_force", signals[column("tangential_force")],
                   tangential[0] * data.direction[0] + tangential[1] * data.direction[1]);
    comparison.add("contact_area", signals[column("contact_area")], at.contact_area());
    if (!by_force || force > 0) {
      comparison.add("slider_z", force > 0 ? signals[column("slider_z")] : at.height, at.height);
    }
    const auto compare_charge = [&](const std::string& charge, const std::string& current,
                                    const std::vector<double>& full, const std::string& reported) {
      const double value = signals[column(charge)], reference = at_time(ions.time, full, time);
      comparison.add("charge_" + reported, value, reference);
      if (step % per_sample == 0) {
        const auto last = sampled.find(charge);
        if (last != sampled.end()) {
          const double length = static_cast<double>(per_sample) * interval;
          comparison.add("sampled_" + current, (value - last->second.first) / length,
                         (reference - last->second.second) / length);
        }
        sampled[charge] = {value, reference};
      }
    };
    compare_charge("charge_top", "current_top", ions.charge_top, "top");
    compare_charge("charge_bottom", "current_bottom", ions.charge_bottom, "bottom");
    for (const Taxel& taxel : run.input.readout.taxels) {
      const auto segment =
          std::ranges::find(ions.top_segments, taxel.name, &electrochemistry::SegmentCharge::name);
      compare_charge("charge_top_" + taxel.name, "current_top_taxels", segment->charge,
                     "top_taxels");
    }
  }
  return comparison.errors();
}

} // namespace ionskin::live
