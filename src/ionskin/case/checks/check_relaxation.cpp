// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/checks/check_relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace ionskin {

namespace {

/// Largest number of relaxation times. Each adds a decay to every mode of the water potential.
constexpr std::size_t most_times = 20;

/// The keys of a material's Prony series, and their records if they are given.
struct Series {
  Series(const CaseDocument& of_case, const std::string& name)
      : document(of_case), material(name),
        times_key(fmt::format("materials.{}.relaxation_times", name)),
        shares_key(fmt::format("materials.{}.relaxation_shares", name)),
        times(of_case.find(times_key)), shares(of_case.find(shares_key)) {}

  std::vector<Pointer> places() const {
    std::vector<Pointer> all = document.point_at(times_key);
    const std::vector<Pointer> more = document.point_at(shares_key);
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  const CaseDocument& document;
  std::string material, times_key, shares_key;
  const ValueRecord *times, *shares;
};

void check_numbers(const Series& series, Problems& problems) {
  if (series.times == nullptr || series.shares == nullptr) {
    const bool has_times = series.times != nullptr;
    problems.add(fmt::format("{} without {}", has_times ? series.times_key : series.shares_key,
                             has_times ? series.shares_key : series.times_key),
                 series.places(), "a Prony series has a share for each time: give both");
    return;
  }
  const std::vector<double>& times = series.times->value.numbers;
  const std::vector<double>& shares = series.shares->value.numbers;
  const double lost = std::accumulate(shares.begin(), shares.end(), 0.0);
  if (times.size() != shares.size() || times.empty() || times.size() > most_times)
    problems.add(fmt::format("{} has {} entries, and {} has {}", series.times_key, times.size(),
                             series.shares_key, shares.size()),
                 series.places(), fmt::format("give as many, from 1 to {}", most_times));
  if (std::ranges::adjacent_find(times, std::greater_equal<>()) != times.end())
    problems.add(fmt::format("{} does not ascend", series.times_key),
                 series.document.point_at(series.times_key),
                 "write ascending times, such as [\"1 s\", \"100 s\"]");
  if (lost >= 1)
    problems.add(fmt::format("{} add up to {:.6g}", series.shares_key, lost),
                 series.document.point_at(series.shares_key),
                 "together they must be below 1: what is left is the modulus after all times");
}

/// Refuses relaxation where the model is elastic.
void check_place(const Series& series, LayerRole role, Problems& problems) {
  const Case& input = series.document.input;
  const auto refuse = [&](const std::string& why, const std::string& remedy) {
    problems.add(fmt::format("the material \"{}\" relaxes, {}", series.material, why),
                 series.places(), remedy);
  };
  const std::string remove = fmt::format("remove {} and {}", series.times_key, series.shares_key);
  if (role != LayerRole::core)
    refuse("but it is that of an electrode: only the core's stress may relax", remove);
  else if (input.strain.kind != StrainSourceKind::prescribed)
    refuse("but the strain is not prescribed: a contact is solved with elastic layers",
           "set strain.source = \"prescribed\", or " + remove);
  else if (input.strain.compression != 0)
    refuse("but its compression is held: that is solved for an elastic core only",
           "press with strain.pressure, bend with strain.curvature, or " + remove);
  else if (input.water.bottom_pressure != 0 || input.water.top_pressure != 0)
    refuse("but water outside is under pressure: that is solved for an elastic core only",
           "leave water.bottom_pressure and water.top_pressure at 0, or " + remove);
}

} // namespace

void check_relaxation(const CaseDocument& document, Problems& problems) {
  std::set<std::string> done;
  for (const Layer& layer : document.input.skin.layers) {
    const Series series(document, layer.material.name);
    if (series.times == nullptr && series.shares == nullptr)
      continue;
    if (done.insert(layer.material.name).second)
      check_numbers(series, problems);
    check_place(series, layer.role, problems);
  }
}

} // namespace ionskin
