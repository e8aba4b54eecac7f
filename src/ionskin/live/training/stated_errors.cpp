// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/training/stated_errors.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace ionskin::live {
namespace {

/// Largest number of touches in a run of the full model, as its memory grows with them.
constexpr std::size_t touches_together = 6;
/// Factor on the largest error over the touches, since all of some twenty reported errors are to
/// hold together [1].
constexpr double margin = 1.25;

/// Adds the errors of another run, which may lack an event or have a new one.
void join(std::vector<TouchErrors>&& more, std::vector<TouchErrors>& all) {
  for (TouchErrors& signal : more) {
    const auto known = std::ranges::find_if(all, [&](const TouchErrors& one) {
      return one.name == signal.name && one.event == signal.event;
    });
    if (known == all.end()) {
      all.push_back(std::move(signal));
      continue;
    }
    known->largest = std::max(known->largest, signal.largest);
    known->rms.insert(known->rms.end(), signal.rms.begin(), signal.rms.end());
    known->worst.insert(known->worst.end(), signal.worst.begin(), signal.worst.end());
  }
}

/// Random coefficient of friction of a run within the trained range, which depends only on the seed
/// [1].
double friction_of_run(const SkinData& data, std::uint64_t seed) {
  constexpr double range = 0x1p-53;
  const double share = static_cast<double>(std::mt19937_64(~seed)() >> 11u) * range;
  return std::lerp(data.lowest_friction, data.highest_friction, share);
}

/// Progress of a run of the full model as a part of the touches, from `first` to `first + share`.
base::ProgressCallback part_of_touches(const base::ProgressCallback& progress, double first,
                                       double share) {
  return [&progress, first, share, most = 0.0](std::string_view activity, double fraction) mutable {
    constexpr double mechanics = 0.4, history = 0.4; // rough shares of the time
    const double done = activity == "mechanics"        ? mechanics * fraction
                        : activity == "strain history" ? mechanics + history * fraction
                        : activity == "ion transport"
                            ? mechanics + history + (1 - mechanics - history) * fraction
                            : 0;
    most = std::max(most, done);
    progress("touches", first + share * most);
  };
}

} // namespace

std::vector<TouchErrors> errors_on_touches(const SkinData& data, const Case& input,
                                           const TouchRange& range, std::size_t count,
                                           std::uint64_t seed, const mesh::Footprint& footprint,
                                           const TrainingOptions& options,
                                           const std::function<void(const ComparedTouches&)>& done,
                                           ComparedTouches compared) {
  while (compared.count < count) {
    const std::size_t together = std::min(touches_together, count - compared.count);
    TrainingOptions own = options;
    const double first = static_cast<double>(compared.count) / static_cast<double>(count);
    own.progress = part_of_touches(options.progress, first,
                                   static_cast<double>(together) / static_cast<double>(count));
    options.progress("touches", first);
    const std::uint64_t own_seed = seed + compared.count / touches_together;
    Case own_input = input;
    if (data.lowest_friction < data.highest_friction) {
      own_input.contact.friction = friction_of_run(data, own_seed);
    }
    const FullRun run =
        full_run(own_input, with_rows_behind_corners(random_touches(range, 1 + together, own_seed)),
                 footprint, own);
    join(validate(data, run), compared.errors);
    compared.count += together;
    if (done) {
      done(compared);
    }
  }
  options.progress("touches", 1);
  return std::move(compared.errors);
}

std::vector<SignalError> stated_errors(const std::vector<TouchErrors>& errors) {
  std::vector<SignalError> stated;
  for (const TouchErrors& signal : errors) {
    stated.push_back({signal.name, signal.event, margin * *std::ranges::max_element(signal.rms),
                      margin * *std::ranges::max_element(signal.worst), signal.largest});
  }
  return stated;
}

} // namespace ionskin::live
