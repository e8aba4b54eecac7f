// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/output/core_strain.hpp"
#include "ionskin/mechanics/solve_contact.hpp"
#include "mechanics/baseline_case.hpp"
#include "mechanics/rows.hpp"

#include <array>
#include <cmath>
#include <string>

namespace ionskin::verification {
namespace {

struct Averages {
  double edge_size = 0;    ///< size of the elements under the slider's edges [m]
  double normal_force = 0; ///< [N]
  double mean_shear = 0;   ///< [1]
};

/// Averages of steady sliding in plane strain, of a slider over the whole width between symmetric
/// sides: one element across, so that strong refinement is cheap, with the same singular edges as
/// in three dimensions.
Averages plane_strain_averages(double refinement) {
  Case input = baseline_case();
  input.skin.sides = SideCondition::symmetry;
  input.slider.size[1] = 3e-3;
  input.numerics.mesh_refinement = refinement;
  base::Timers timers;
  const auto state = mechanics::solve_steady_sliding(input, {0.0}, {}, timers).front();
  const mesh::SkinMesh mesh(input);
  const double integral = mechanics::off_diagonal_shear_integral(
      state.strain, mesh.lines(input.slider.start), mesh.core_z());
  const std::vector<double>& footprint = mesh.footprint_lines_x();
  return {footprint[1] - footprint[0], state.normal_force, 2 * integral / input.skin.core_volume()};
}

/// Observed order p, by bisection: three values fit a limit plus a multiple of size^p.
double observed_order(const std::array<Averages, 3>& at, double Averages::*value) {
  const double ratio = (at[1].*value - at[0].*value) / (at[2].*value - at[1].*value);
  double low = 0.01, high = 8;
  for (int i = 0; i < 60; ++i) {
    const double order = (low + high) / 2;
    const auto size = [&](std::size_t k) { return std::pow(at[k].edge_size, order); };
    ((size(0) - size(1)) / (size(1) - size(2)) < ratio ? low : high) = order;
  }
  return (low + high) / 2;
}

/// Limit of the last two of four averages, with errors in proportion to the mesh size.
double limit(const std::array<Averages, 4>& at, double Averages::*value) {
  return at[3].*value +
         (at[3].*value - at[2].*value) * at[3].edge_size / (at[2].edge_size - at[3].edge_size);
}

/// Effectivity of an error estimate: the estimated over the true error of the second of four
/// averages. The estimates are the difference to the first average, on twice the mesh sizes, as
/// runs report it; and Richardson's extrapolation with the order at which the last follows on half
/// the sizes.
struct Effectivity {
  double stated = 0, extrapolated = 0;

  Effectivity(const std::array<Averages, 4>& at, double Averages::*value) {
    const double before = at[1].*value - at[0].*value, behind = at[3].*value - at[1].*value;
    const double error = limit(at, value) - at[1].*value;
    stated = std::abs(before / error);
    extrapolated = before / (before / behind - 1) / error;
  }
};

void add_estimate_rows(const std::array<Averages, 4>& at, std::vector<Row>& rows) {
  const auto add = [&](const std::string& name, const Effectivity& index) {
    rows.push_back(compare("M6", "plane strain: extrapolated over true error of " + name,
                           index.extrapolated, 1, 0.5));
    const std::string stated = "plane strain: stated over true error of " + name;
    rows.push_back(at_least("M6", stated, index.stated, 1));
    rows.push_back(at_most("M6", stated, index.stated, 5));
  };
  add("the normal force", {at, &Averages::normal_force});
  add("mean shear", {at, &Averages::mean_shear});
}

} // namespace

std::vector<Row> convergence_rows(const Options& options) {
  constexpr std::array<double, 4> refinement{2, 4, 5.65, 8};
  std::array<Averages, 4> at;
  for (std::size_t i = 0; i < at.size(); ++i) {
    at[i] = plane_strain_averages(refinement[i]);
    options.progress("mechanics: mesh convergence", static_cast<double>(i + 1) / at.size());
  }
  // Pressure is singular at sharp edges: first order is what even tractions reach there in the end.
  const std::array<Averages, 3> finest{at[1], at[2], at[3]};
  std::vector<Row> rows{at_least("M6", "plane strain: observed order of the normal force",
                                 observed_order(finest, &Averages::normal_force), 0.9),
                        at_least("M6", "plane strain: observed order of mean shear",
                                 observed_order(finest, &Averages::mean_shear), 0.9)};
  // 2.1e-3 off; with even tractions in the cells 3.5e-3.
  rows.push_back(compare("M6",
                         "plane strain: normal force on half the coarse mesh sizes over its limit",
                         at[0].normal_force / limit(at, &Averages::normal_force), 1, 2.5e-3));
  add_estimate_rows(at, rows);
  return rows;
}

} // namespace ionskin::verification
