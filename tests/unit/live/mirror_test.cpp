// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/skin.hpp"
#include "ionskin/live/touches/random_numbers.hpp"
#include "small_skin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace ionskin::live {
namespace {

constexpr double mirror_step = 1e-3; // [s]
constexpr double left_by_sweeps = 1e-5;

struct MirrorStep {
  std::array<double, 2> place{}; ///< [m]
  double force = 0;              ///< [N]
};

/// Landings, strokes in all directions, rests, and changes of load.
std::vector<MirrorStep> random_path(const SkinData& data, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<MirrorStep> path{{{2.2e-3, 0.8e-3}, 0}};
  std::array<double, 2> way{};
  double change = 0;
  while (path.size() < count) {
    if (path.size() % 40 == 1) {
      const double speed = random.between(0, 1) < 0.3 ? 0 : random.between(1e-7, 3e-6),
                   angle = random.between(0, 6.28);
      way = {speed * std::cos(angle), speed * std::sin(angle)};
      change = random.between(0, 1) < 0.5 ? 0 : random.between(-0.04, 0.06);
    }
    MirrorStep next = path.back();
    for (std::size_t d = 0; d < 2; ++d) {
      next.place[d] = std::clamp(next.place[d] + way[d], data.lowest_place[d] + 1e-4,
                                 data.highest_place[d] - 1e-4);
    }
    next.force = std::clamp(next.force + change, 0.0, 2.0);
    path.push_back(next);
  }
  return path;
}

/// Signals of a path, or of its image in the middle planes of the skin.
std::vector<std::vector<double>> signals_of(const SkinData& data,
                                            const std::vector<MirrorStep>& path,
                                            const std::array<bool, 2>& mirrored) {
  Skin skin(data);
  const std::array<double, 2> extent{data.length, data.width};
  std::vector<std::vector<double>> all;
  for (std::size_t i = 0; i < path.size(); ++i) {
    std::array<double, 2> place = path[i].place;
    for (std::size_t d = 0; d < 2; ++d) {
      place[d] = mirrored[d] ? extent[d] - place[d] : place[d];
    }
    std::vector<double>& signals = all.emplace_back(skin.names().size());
    EXPECT_EQ(skin.step(mirror_step * static_cast<double>(i), place, true, path[i].force, signals),
              0u)
        << i;
  }
  return all;
}

SkinData symmetric_skin() {
  SkinData data = sphere_on_many_cells(9);
  data.lowest_place = {1e-3, 4e-4};
  data.highest_place = {5e-3, 1.6e-3};
  return data;
}

TEST(MirroredPaths, HaveMirroredSignalsUnderEveryFriction) {
  for (const char* law : {"coulomb", "regularised", "stribeck"}) {
    SCOPED_TRACE(law);
    SkinData data = symmetric_skin();
    data.friction_law = law;
    if (data.friction_law == "regularised") {
      data.friction_parameters = {"slip_length"};
      data.friction_values = {1e-7};
    } else if (data.friction_law == "stribeck") {
      data.friction_parameters = {"kinetic_friction", "stribeck_speed", "lag_time"};
      data.friction_values = {0.2, 1e-3, 5e-3};
    }
    const auto path = random_path(data, 2000, 3);
    const auto one = signals_of(data, path, {false, false});
    const std::vector<std::string> names = Skin(data).names();
    for (const std::array<bool, 2>& mirrored :
         {std::array{true, false}, {false, true}, {true, true}}) {
      const auto other = signals_of(data, path, mirrored);
      for (const auto& [name, sign] : {std::pair{"normal_force", 1.0},
                                       {"contact_area", 1.0},
                                       {"moment_x", mirrored[1] ? -1.0 : 1.0},
                                       {"moment_y", mirrored[0] ? -1.0 : 1.0},
                                       {"tangential_force_x", mirrored[0] ? -1.0 : 1.0},
                                       {"tangential_force_y", mirrored[1] ? -1.0 : 1.0}}) {
        const auto at =
            static_cast<std::size_t>(std::ranges::find(names, std::string(name)) - names.begin());
        double largest = 0, difference = 0;
        for (std::size_t i = 0; i < path.size(); ++i) {
          largest = std::max(largest, std::abs(one[i][at]));
          difference = std::max(difference, std::abs(one[i][at] - sign * other[i][at]));
        }
        EXPECT_LE(difference, left_by_sweeps * largest)
            << name << ", " << mirrored[0] << mirrored[1];
        EXPECT_GT(largest, 0) << name;
      }
    }
  }
}

} // namespace
} // namespace ionskin::live
