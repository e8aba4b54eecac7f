// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/fields/wave_bands.hpp"

#include <algorithm>
#include <utility>

namespace ionskin::finite_layers {
namespace {

/// Ratio of the reaches of two successive bands.
constexpr double step = 4;
/// Largest area of a box, over that of the band before, with which a further band saves time.
constexpr double least_gain = 0.25;

} // namespace

PlaneBox WaveBand::box(const std::array<double, 2>& centre) const {
  return {std::clamp(centre[0] - length / 2, 0.0, skin_length - length),
          std::clamp(centre[1] - width / 2, 0.0, skin_width - width), length, width};
}

std::vector<WaveBand> wave_bands(const FieldSkin& skin, const ContactGrid& cells,
                                 const WaveSplit& split, double last) {
  const double columns = cells.x.back() - cells.x.front(),
               rows = cells.half ? -2 * cells.y.front() : cells.y.back() - cells.y.front();
  const auto size = [&](double reach) {
    return std::pair{std::min(columns + 2 * reach, skin.length),
                     std::min(rows + 2 * reach, skin.width)};
  };
  std::vector<WaveBand> bands;
  const auto add = [&](const std::pair<double, double>& box, const auto& share, double end) {
    bands.push_back({skin.length, skin.width, box.first, box.second,
                     PlaneWaves(box.first, box.second, cells.half, share, end)});
  };
  add(
      {skin.length, skin.width}, [&](double k) { return split.long_share(k); }, split.last_long());
  WaveSplit from = split;
  while (true) {
    const WaveSplit next = from.shorter(step);
    const auto box = size(from.reach()), smaller = size(next.reach());
    const bool ends = next.last_long() >= last ||
                      smaller.first * smaller.second > least_gain * box.first * box.second;
    if (ends) {
      add(
          box, [&](double k) { return from.short_share(k); }, last);
      return bands;
    }
    add(
        box, [&](double k) { return next.long_share(k) - from.long_share(k); }, next.last_long());
    from = next;
  }
}

} // namespace ionskin::finite_layers
