// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/training/validation.hpp"

#include "ionskin/base/value_at.hpp"
#include "ionskin/handover/contact_timeline.hpp"
#include "ionskin/live/skin.hpp"
#include "ionskin/live/touches/random_touches.hpp"
#include "ionskin/live/training/touch_events.hpp"
#include "ionskin/readout/charge_relaxation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace ionskin::live {
namespace {

constexpr double rate = 1e3; ///< steps of the reduced-order model in a second [1/s]
constexpr std::array<const char*, 3> moment_names{"moment_x", "moment_y", "moment_z"};

bool presses_by_force(const Motion& motion) {
  return std::ranges::any_of(motion.waypoints,
                             [](const Waypoint& point) { return point.force.has_value(); });
}

/// Collects the errors of the signals against the full model, by touch and event.
class Comparison {
public:
  /// Begins the next touch; nothing is collected before the first call.
  void begin_touch() { ++touch_; }
  /// Sets the events of the values that are added from now on.
  /// @param events bits, as `events_of` returns them
  void set_events(unsigned events) { events_ = events; }
  /// Adds a value of a signal and its reference from the full model.
  /// @param weight in the mean of squares: duration that the value stands for [s]
  void add(const std::string& name, double value, double reference, double weight = 1 / rate) {
    if (touch_ == 0) {
      return;
    }
    add_to(sums_[{0, name}], value, reference, weight);
    for (std::size_t event = 0; event < event::names.size(); ++event) {
      if ((events_ >> event & 1u) != 0) {
        add_to(sums_[{1 + event, name}], value, reference, weight);
      }
    }
  }
  std::vector<TouchErrors> errors() const {
    std::vector<TouchErrors> result;
    for (const auto& [key, sums] : sums_) {
      const auto& [event, name] = key;
      TouchErrors& errors = result.emplace_back(TouchErrors{
          name, event == 0 ? std::string() : event::names.at(event - 1), sums.largest, {}, {}});
      for (const auto& [number, touch] : sums.touches) {
        errors.rms.push_back(touch.weight > 0 ? std::sqrt(touch.square / touch.weight) : 0.0);
        errors.worst.push_back(touch.worst);
      }
    }
    return result;
  }

private:
  struct Touch {
    double square = 0, weight = 0, worst = 0;
  };
  struct Sums {
    std::map<std::size_t, Touch> touches; ///< by the number of the touch
    double largest = 0;                   ///< largest magnitude of the reference
  };
  void add_to(Sums& sums, double value, double reference, double weight) const {
    const double error = value - reference;
    Touch& touch = sums.touches[touch_];
    touch.square += weight * error * error;
    touch.weight += weight;
    touch.worst = std::max(touch.worst, std::abs(error));
    sums.largest = std::max(sums.largest, std::abs(reference));
  }

  std::size_t touch_ = 0;
  unsigned events_ = 0;
  std::map<std::pair<std::size_t, std::string>, Sums>
      sums_; ///< by event (0: whole touch, 1 + event) and signal
};

/// True if the full model has a row within the step that ends at a time. Elsewhere there is nothing
/// to compare: its own steps take up to some hundredths of a second, and a taxel's charge does not
/// vary linearly in between, such as when the slider passes the taxel's edge.
/// @param rows times of the full model, ascending [s]
bool has_row(const std::vector<double>& rows, double time) {
  const auto after = std::ranges::upper_bound(rows, time + 1e-9 / rate);
  return after != rows.begin() && *(after - 1) > time - (1 - 1e-9) / rate;
}

/// Roll, pitch and yaw of a motion at any time.
class PathAngles {
public:
  explicit PathAngles(const Case& input) : legs_(motion_legs(input.motion, input.slider)) {}

  Skin::Angles at(double time) const {
    const auto after = std::ranges::upper_bound(legs_, time, {}, &MotionLeg::begin);
    const MotionLeg& leg = after == legs_.begin() ? legs_.front() : *(after - 1);
    const shapes::Pose pose = leg.pose(time - leg.begin);
    return {pose.roll, pose.pitch, pose.yaw};
  }

private:
  std::vector<MotionLeg> legs_;
};

/// Events of the full run at each step of the reduced-order model, as `events_of` returns them.
std::vector<std::uint8_t> events_each_step(const handover::ContactTimeline& timeline,
                                           const PathAngles& angles, bool by_force, double end) {
  std::vector<TouchInstant> instants;
  for (std::size_t step = 0; static_cast<double>(step) / rate <= end; ++step) {
    const double time = static_cast<double>(step) / rate;
    const handover::StateCombination at = timeline.at(time);
    const double force = at.normal_force();
    instants.push_back(
        {at.centre, by_force ? force : at.height, force > 0, at.stick_area() > 0, angles.at(time)});
  }
  return events_of(instants);
}

} // namespace

std::vector<TouchErrors> validate(const SkinData& data, const FullRun& run) {
  Skin skin(data);
  skin.set_friction(run.input.contact.friction);
  const std::vector<std::string>& names = skin.names();
  std::vector<double> signals(names.size());
  const auto column = [&](const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  };
  const handover::ContactTimeline timeline(run.input, run.contact);
  const bool by_force = presses_by_force(run.input.motion);
  const auto& ions = run.ions;
  const readout::ChargeRelaxation relaxation{ions.relaxation_charge, ions.relaxation_current};
  const double end = ions.time.back(), sampling = run.input.readout.sample_interval;
  const auto per_sample = static_cast<std::size_t>(std::max(1.0, std::round(sampling * rate)));
  // Charges at the last sample, by name: value and reference [C].
  std::map<std::string, std::pair<double, double>> sampled;
  const std::vector<double> begins = landings(run.input.motion);
  std::size_t touches = 0; // number of touches that have begun
  double compared = 0;     // time at which charges were last compared [s]
  Comparison comparison;
  const PathAngles angles(run.input);
  const std::vector<std::uint8_t> events = events_each_step(timeline, angles, by_force, end);
  for (std::size_t step = 0; static_cast<double>(step) / rate <= end; ++step) {
    const double time = static_cast<double>(step) / rate;
    const handover::StateCombination at = timeline.at(time);
    const double force = at.normal_force();
    skin.step(time, at.centre, angles.at(time), by_force, by_force ? force : at.height, signals);
    if (touches < begins.size() && time >= begins[touches]) {
      if (touches++ > 0) {
        comparison.begin_touch();
      }
    }
    comparison.set_events(events[step]);
    comparison.add("normal_force", signals[column("normal_force")], force);
    const auto tangential = at.tangential_force();
    comparison.add("tangential_force", signals[column("tangential_force")],
                   tangential[0] * data.direction[0] + tangential[1] * data.direction[1]);
    const auto moment = at.moment();
    for (std::size_t c = 0; c < moment.size(); ++c) {
      const std::string name = moment_names.at(c);
      comparison.add(name, signals[column(name)], moment[c]);
    }
    comparison.add("contact_area", signals[column("contact_area")], at.contact_area());
    if (!by_force || force > 0) {
      comparison.add("slider_z", force > 0 ? signals[column("slider_z")] : at.height, at.height);
    }
    const bool samples = step % per_sample == 0;
    const bool tells_charge = has_row(ions.time, time);
    const double since = time - std::exchange(compared, tells_charge ? time : compared);
    const auto compare_current = [&](const std::string& of, const std::string& reported,
                                     double value, double reference) {
      const auto last = sampled.find(of);
      if (last != sampled.end()) {
        const double length = static_cast<double>(per_sample) / rate;
        comparison.add("sampled_current_" + reported, (value - last->second.first) / length,
                       (reference - last->second.second) / length, length);
      }
      sampled[of] = {value, reference};
    };
    // Half the difference of the charges of both electrodes: value and reference [C].
    std::array<double, 2> difference{};
    const auto compare_charge = [&](const std::string& of, const std::vector<double>& full,
                                    const std::string& reported, double share) {
      const double value = signals[column("charge_" + of)];
      if (tells_charge) {
        comparison.add("charge_" + reported, value, base::value_at(ions.time, full, time), since);
      }
      if (samples) {
        const double reference =
            base::value_at(ions.time, full, time) +
            2 * share * readout::departure_from_line(ions.time, relaxation, time);
        difference[0] += share * value;
        difference[1] += share * reference;
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
