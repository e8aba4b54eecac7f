// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/reduction/unit_strains.hpp"

#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/live/reduction/place_map.hpp"
#include "ionskin/live/reduction/place_symmetry.hpp"
#include "ionskin/mechanics/output/core_strain.hpp"
#include "ionskin/parallel/task_pool.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace ionskin::live {

void add_unit_strains(const mechanics::SkinModel& model, const SkinData& data,
                      const mechanics::StrainRecovery& recovery, const PlaceNodes& places,
                      const Reflections& reflections, int threads,
                      const std::vector<WantedStrain>& wanted, std::vector<ChannelMap>& maps) {
  const std::size_t size = 3 * model.cells.count(), columns = places.x.size();
  const std::array<std::size_t, 3> cells{model.cells.columns(), model.cells.rows(), 1},
      nodes{columns, places.y.size(), 1};
  // [node][channel]: values [load][point][row]
  std::vector<std::vector<std::vector<float>>> at_nodes(nodes[0] * nodes[1]);
  const bool mirror_places = are_mirrored(places, data);
  for (std::size_t node = 0; node < at_nodes.size(); ++node) {
    if (!at_nodes[node].empty()) {
      continue;
    }
    std::vector<std::size_t> images; // mirror images of the node, which comes first itself
    for (std::size_t g = 0; g < reflections.count(); ++g) {
      images.push_back(reflections.image(g, node, nodes));
    }
    // True if the node's image by element g is to be stored, and no earlier element gives it.
    const auto is_new = [&](std::size_t g) {
      return g == 0 || (mirror_places &&
                        std::find(images.begin(), images.begin() + static_cast<std::ptrdiff_t>(g),
                                  images[g]) == images.begin() + static_cast<std::ptrdiff_t>(g));
    };
    std::size_t per_load = 0;
    for (std::size_t g = 0; g < images.size(); ++g) {
      if (is_new(g)) {
        at_nodes[images[g]].resize(wanted.size());
        for (std::size_t c = 0; c < wanted.size(); ++c) {
          per_load = wanted[c].points.size() * wanted[c].rows.size();
          at_nodes[images[g]][c].resize(size * per_load);
        }
      }
    }
    const std::array<double, 2> place{places.x[node % columns], places.y[node / columns]};
    parallel::run_tasks((size + loads_at_once - 1) / loads_at_once, threads, [&](std::size_t i) {
      base::check_interrupt();
      const std::size_t first = i * loads_at_once, count = std::min(loads_at_once, size - first);
      std::vector<mechanics::CellVector> loads(count, mechanics::CellVector(size, 0.0));
      for (std::size_t own = 0; own < count; ++own) {
        loads[own][first + own] = 1;
      }
      const std::vector<std::array<double, 2>> centres(count, place);
      const auto strains = recovery.at(centres, loads);
      for (std::size_t own = 0; own < count; ++own) {
        const std::size_t load = first + own, component = load % 3;
        for (std::size_t g = 0; g < images.size(); ++g) {
          if (!is_new(g)) {
            continue;
          }
          const auto& [x, y] = reflections.element(g);
          const mechanics::CoreStrain strain = mechanics::mirrored(strains[own].core, {x, y});
          const double sign = (component == 1 && x) || (component == 2 && y) ? -1 : 1;
          const std::size_t image = 3 * reflections.image(g, load / 3, cells) + component;
          for (std::size_t c = 0; c < wanted.size(); ++c) {
            const std::size_t rows = wanted[c].rows.size();
            float* into = at_nodes[images[g]][c].data() + image * wanted[c].points.size() * rows;
            for (const std::size_t point : wanted[c].points) {
              const auto at = strain_at(strain, point);
              for (const auto& row : wanted[c].rows) {
                *into++ = static_cast<float>(sign * value_of({row}, at));
              }
            }
          }
        }
      }
    });
  }
  for (std::size_t c = 0; c < wanted.size(); ++c) {
    std::vector<std::vector<float>> of_channel;
    for (auto& node : at_nodes) {
      of_channel.push_back(std::move(node[c]));
    }
    maps[c].rows_per_point = wanted[c].rows.size();
    maps[c].strain = place_map(places, of_channel, negligible_place_mode);
  }
}

} // namespace ionskin::live
