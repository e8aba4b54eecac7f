// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/skin/layered_skin.hpp"
#include "mechanics/baseline_case.hpp"
#include "mechanics/rows.hpp"
#include "mechanics/solid_elements.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace ionskin::verification {
namespace {

using Interval = std::array<double, 2>;

constexpr double block_length = 1e-3, block_width = 0.6e-3;
constexpr std::array<Interval, 2> loaded_columns{{{0.3e-3, 0.4e-3}, {0.4e-3, 0.5e-3}}};
constexpr Interval loaded_row{0.15e-3, 0.3e-3};
/// Forces on each cell of the half that is meshed: downwards, along x, along y [N].
constexpr std::array<std::array<double, 3>, 2> forces{{{1.0, 0.2, 0.1}, {0.7, 0.4, -0.1}}};
/// Points in the core, on mesh lines of neither method [m].
constexpr std::array<std::array<double, 3>, 4> places{{{0.06e-3, 0.21e-3, 0.11e-3},
                                                       {0.34e-3, 0.23e-3, 0.09e-3},
                                                       {0.56e-3, 0.06e-3, 0.11e-3},
                                                       {0.71e-3, 0.21e-3, 0.06e-3}}};

/// Values that both methods compute.
struct Answer {
  std::vector<double> surface; ///< mean displacement of each cell: downwards, x, y [m]
  std::vector<double> core;    ///< strain at the places
  std::vector<double> films;   ///< mean strain of the electrodes over the first cell: xx, yy, xy
};

Skin small_skin() {
  Skin skin = baseline_case().skin;
  skin.length = block_length;
  skin.width = block_width;
  return skin;
}

Answer by_layers() {
  const Skin skin = small_skin();
  const double x = loaded_columns[0][1], y = block_width / 2;
  const finite_layers::ContactGrid grid{
      {loaded_columns[0][0] - x, 0, loaded_columns[1][1] - x}, {loaded_row[0] - y, 0}, true};
  const finite_layers::LayeredSkin layers(
      skin, grid, finite_layers::skin_resolution(skin, {loaded_columns[0][0], loaded_row[0]}));
  std::vector<double> given;
  for (const auto& force : forces) {
    given.insert(given.end(), force.begin(), force.end());
  }
  const Eigen::VectorXd moved =
      layers.across(y).compliance(x) * Eigen::Map<const Eigen::VectorXd>(given.data(), 6);
  Answer answer;
  answer.surface.assign(moved.begin(), moved.end());
  for (const auto& place : places) {
    const finite_layers::FieldGrid asked{{{place[0], place[0]}},
                                         {{place[1], place[1]}},
                                         {loaded_columns[0][0], loaded_columns[0][1]},
                                         {loaded_row[0], loaded_row[1]}};
    const auto field =
        layers.fields({place[2] - skin.core_bottom()}, 0.1e-3).at({{asked, {x, y}, given}}).front();
    for (const auto& component : field.core.component) {
      answer.core.push_back(component.front());
    }
    if (answer.films.empty()) {
      for (std::size_t film = 0; film < 2; ++film) {
        for (const std::size_t component : {0, 1, 5}) {
          answer.films.push_back(field.electrodes.component[component][film]);
        }
      }
    }
  }
  return answer;
}

/// Divides each interval between lines into equal parts.
std::vector<double> divided(const std::vector<double>& lines, int parts) {
  std::vector<double> result{lines.front()};
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    for (int part = 1; part <= parts; ++part) {
      result.push_back(lines[i] + (lines[i + 1] - lines[i]) * part / parts);
    }
  }
  return result;
}

Answer by_elements(int parts) {
  const Skin skin = small_skin();
  std::vector<SolidElements::Lame> laws;
  for (const std::size_t layer : {0, 1, 1, 2}) {
    const auto own = finite_layers::elastic_layers(skin)[layer];
    laws.insert(laws.end(), static_cast<std::size_t>(parts), {own.lame_lambda, own.shear_modulus});
  }
  std::vector<SolidElements::Patch> patches;
  for (std::size_t cell = 0; cell < 2; ++cell) {
    patches.push_back(
        {loaded_columns[cell], loaded_row, {forces[cell][1], forces[cell][2], -forces[cell][0]}});
  }
  const SolidElements solid({{divided({0, 0.1e-3, 0.23e-3, 0.3e-3, 0.35e-3, 0.4e-3, 0.45e-3, 0.5e-3,
                                       0.57e-3, 0.7e-3, 1e-3},
                                      parts),
                              divided({0, 0.1e-3, 0.15e-3, 0.2e-3, 0.3e-3}, parts),
                              divided({0, 10e-6, 100e-6, 190e-6, 200e-6}, parts)}},
                            laws, patches);
  Answer answer;
  for (const Interval& column : loaded_columns) {
    const auto mean = solid.mean_of_top(column, loaded_row);
    answer.surface.insert(answer.surface.end(), {-mean[2], mean[0], mean[1]});
  }
  for (const auto& place : places) {
    const auto strain = solid.strain(place);
    answer.core.insert(answer.core.end(), strain.begin(), strain.end());
  }
  for (const Interval& film : {Interval{0, 10e-6}, Interval{190e-6, 200e-6}}) {
    const auto strain = solid.mean_strain({loaded_columns[0], loaded_row, film});
    answer.films.insert(answer.films.end(), {strain[0], strain[1], strain[5]});
  }
  return answer;
}

/// Largest difference of two lists, over the largest magnitude of the second.
double difference(const std::vector<double>& one, const std::vector<double>& other) {
  double largest = 0, scale = 0;
  for (std::size_t i = 0; i < other.size(); ++i) {
    largest = std::max(largest, std::abs(one[i] - other[i]));
    scale = std::max(scale, std::abs(other[i]));
  }
  return largest / scale;
}

} // namespace

std::vector<Row> solid_rows(const Options& options) {
  options.progress("mechanics: solid elements", 0);
  const Answer layers = by_layers(), coarse = by_elements(1), fine = by_elements(2);
  std::vector<Row> rows;
  const auto add = [&](const std::string& what, std::vector<double> Answer::*part, double bound) {
    const double first = difference(coarse.*part, layers.*part),
                 second = difference(fine.*part, layers.*part);
    rows.push_back(
        at_most("M16", "free sides and ends, elements against layers: " + what, second, bound));
    rows.push_back(at_least("M16", "free sides and ends: order at which they meet in " + what,
                            std::log2(first / second), 2));
  };
  add("displacement of the face", &Answer::surface, 0.01);
  add("strain of the core", &Answer::core, 0.01);
  add("mean strain of the electrodes", &Answer::films, 0.01);
  options.progress("mechanics: solid elements", 1);
  return rows;
}

} // namespace ionskin::verification
