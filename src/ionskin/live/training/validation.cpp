// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/training/validation.hpp"

#include "ionskin/handover/contact_timeline.hpp"
#include "ionskin/live/skin.hpp"
#include "ionskin/live/training/random_touches.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace ionskin::live {
namespace {

constexpr double rate = 1e3; // of the steps [1/s]

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
  void begin_touch() { ++touch_; }
  void add(const std::string& name, double value, double reference) {
    if (touch_ == 0) {
      return;
    }
    Sums& sums = sums_[name];
    const double error = value - reference;
    sums.touches.resize(touch_);
    Touch& touch = sums.touches.back();
    touch.square += error * error;
    touch.count += 1;
    touch.worst = std::max(touch.worst, std::abs(error));
    sums.largest = std::max(sums.largest, std::abs(reference));
  }
  std::vector<TouchErrors> errors() const {
    std::vector<TouchErrors> result;
    for (const auto& [name, sums] : sums_) {
      TouchErrors& errors = result.emplace_back(TouchErrors{name, sums.largest, {}, {}});
      for (const Touch& touch : sums.touches) {
        errors.rms.push_back(std::sqrt(touch.square / std::max(1.0, touch.count)));
        errors.worst.push_back(touch.worst);
      }
    }
    return result;
  }

private:
  struct Touch {
    double square = 0, count = 0, worst = 0;
  };
  struct Sums {
    std::vector<Touch> touches;
    double largest = 0;
  };
  std::size_t touch_ = 0;
  std::map<std::string, Sums> sums_;
};

} // namespace

std::vector<TouchErrors> validate(const SkinData& data, const FullRun& run) {
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
  const auto per_sample = static_cast<std::size_t>(std::max(1.0, std::round(sampling * rate)));
  std::map<std::string, std::pair<double, double>> sampled; // charges at the last sample
  const std::vector<double> begins = landings(run.input.motion);
  std::size_t touches = 0; // that have begun
  Comparison comparison;
  for (std::size_t step = 0; static_cast<double>(step) / rate <= end; ++step) {
    const double time = static_cast<double>(step) / rate;
    const handover::StateCombination at = timeline.at(time);
    const double force = at.normal_force();
    skin.step(time, at.centre, by_force, by_force ? force : at.height, signals);
    if (touches < begins.size() && time >= begins[touches]) {
      if (touches++ > 0) {
        comparison.begin_touch();
      }
    }
    comparison.add("normal_force", signals[column("normal_force")], force);
    const auto tangential = at.tangential_force();
    comparison.add("tangential_force", signals[column("tangential_force")],
                   tangential[0] * data.direction[0] + tangential[1] * data.direction[1]);
    comparison.add("contact_area", signals[column("contact_area")], at.contact_area());
    if (!by_force || force > 0) {
      comparison.add("slider_z", force > 0 ? signals[column("slider_z")] : at.height, at.height);
    }
    const bool samples = step % per_sample == 0;
    const auto compare_current = [&](const std::string& of, const std::string& reported,
                                     double value, double reference) {
      const auto last = sampled.find(of);
      if (last != sampled.end()) {
        const double length = static_cast<double>(per_sample) / rate;
        comparison.add("sampled_current_" + reported, (value - last->second.first) / length,
                       (reference - last->second.second) / length);
      }
      sampled[of] = {value, reference};
    };
    std::array<double, 2> difference{}; // half that of both electrodes, here and there
    const auto compare_charge = [&](const std::string& of, const std::vector<double>& full,
                                    const std::string& reported, double share) {
      const double value = signals[column("charge_" + of)],
                   reference = at_time(ions.time, full, time);
      comparison.add("charge_" + reported, value, reference);
      difference[0] += share * value;
      difference[1] += share * reference;
      if (samples) {
        compare_current(of, reported, value, reference);
      }
    };
    compare_charge("top", ions.charge_top, "top", 0.5);
    compare_charge("bottom", ions.charge_bottom, "bottom", -0.5);
    if (samples) {
      compare_current("difference", "difference", difference[0], difference[1]);
    }
    for (const Taxel& taxel : run.input.readout.taxels) {
      const auto segment =
          std::ranges::find(ions.top_segments, taxel.name, &electrochemistry::SegmentCharge::name);
      compare_charge("top_" + taxel.name, segment->charge, "top_taxels", 0);
    }
  }
  return comparison.errors();
}

} // namespace ionskin::live
