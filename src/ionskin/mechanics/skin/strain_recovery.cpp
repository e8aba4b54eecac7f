// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/skin/strain_recovery.hpp"

#include "ionskin/base/largest.hpp"
#include "ionskin/case/coupling.hpp"
#include "ionskin/laws/shear/shear_measure.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace ionskin::mechanics {
namespace {

/// Points of the two-point Gauss rule in each interval between lines, ascending.
std::vector<double> gauss_points(const std::vector<double>& lines) {
  std::vector<double> points;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    const double middle = 0.5 * (lines[i] + lines[i + 1]),
                 offset = 0.5 * (lines[i + 1] - lines[i]) / std::sqrt(3.0);
    points.insert(points.end(), {middle - offset, middle + offset});
  }
  return points;
}

/// Both halves of each column between lines, ascending. Strains are averaged over them, not sampled
/// at points, because means keep the integral over the plane although strains are singular below
/// sharp edges: charges under laws that move water follow from differences of a hundredth of the
/// strain.
std::vector<finite_layers::Interval> halves(const std::vector<double>& lines) {
  std::vector<finite_layers::Interval> result;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    const double middle = 0.5 * (lines[i] + lines[i + 1]);
    result.insert(result.end(), {{lines[i], middle}, {middle, lines[i + 1]}});
  }
  return result;
}

/// Heights of the strain points above the bottom of the core, ascending [m].
std::vector<double> heights(const mesh::SkinMesh& mesh) {
  const std::vector<double> z = mesh.lines_z();
  const auto [bottom, top] = mesh.core_z();
  std::vector<double> core;
  for (std::size_t row = bottom; row <= top; ++row) {
    core.push_back(z[row] - z[bottom]);
  }
  return gauss_points(core);
}

/// Mean size of the columns in the footprint, along x or y, whichever is smaller [m].
double mean_column(const mesh::SkinMesh& mesh) {
  const std::vector<double>&x = mesh.footprint_lines_x(), &y = mesh.footprint_lines_y();
  return std::min((x.back() - x.front()) / static_cast<double>(x.size() - 1),
                  (y.back() - y.front()) / static_cast<double>(y.size() - 1));
}

/// Columns across the skin, where they are the same in all states; empty where they are not, or
/// would take too much memory.
std::optional<finite_layers::PlacesAcross> places_across(const SkinModel& model) {
  // Stored sums over rows of cells would fill the memory: they grow with rows times points.
  if (!model.stays_across || model.form == finite_layers::ComplianceForm::products) {
    return std::nullopt;
  }
  const std::array<double, 2>& low = model.places.low;
  const std::vector<double> lines = model.mesh.lines_across(low[1]);
  const double middle = lines.back(); // of the skin's width, where a half model ends
  return finite_layers::PlacesAcross{model.mesh.half_model() ? middle : low[1], halves(lines),
                                     lines};
}

/// Von Mises stress of a strain [Pa].
/// @param strain tensor components in the order of `CoreStrain` [1]
double von_mises_stress(const finite_layers::ElasticLayer& layer,
                        const std::array<double, 6>& strain) {
  const double mean = (strain[0] + strain[1] + strain[2]) / 3;
  double squares = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    squares += (strain[c] - mean) * (strain[c] - mean) + 2 * strain[3 + c] * strain[3 + c];
  }
  return 2 * layer.shear_modulus * std::sqrt(1.5 * squares);
}

/// Largest von Mises stress of each electrode layer over all columns, bottom to top [Pa].
std::vector<double> largest_stresses(const SkinModel& model,
                                     const finite_layers::StrainField& electrodes) {
  std::vector<double> result;
  const std::size_t columns = electrodes.points[0] * electrodes.points[1];
  const auto core = model.mesh.core_z();
  const std::vector<finite_layers::ElasticLayer>& layers = model.layers.layers();
  for (std::size_t layer = 0; layer < layers.size(); ++layer) {
    if (layer == model.mesh.layer_of_row()[core[0]]) {
      continue;
    }
    double largest = 0;
    for (std::size_t column = 0; column < columns; ++column) {
      std::array<double, 6> strain{};
      for (std::size_t c = 0; c < strain.size(); ++c) {
        strain[c] = electrodes.component[c][column + columns * result.size()];
      }
      largest = base::nan_max(largest, von_mises_stress(layers[layer], strain));
    }
    result.push_back(largest);
  }
  return result;
}

/// Largest difference between the sums of the forces through any level and of the forces on the
/// cells, relative to the latter [1].
/// @param half true if each cell also stands for its mirror image
/// @param held_across true if the sides of the skin carry forces along y, which then differ from
///   level to level and are not compared
/// @param through_levels force through each level: normal (downwards), x, y [N]
double equilibrium_residual(const CellVector& forces, bool half, bool held_across,
                            const std::vector<std::array<double, 3>>& through_levels) {
  std::array<double, 3> sum{};
  for (std::size_t i = 0; i < forces.size(); ++i) {
    sum[i % 3] += half ? (i % 3 == 2 ? 0 : 2 * forces[i]) : forces[i];
  }
  double largest = 0, difference = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    largest = std::max(largest, std::abs(sum[c]));
    if (held_across && c == 2) {
      continue;
    }
    for (const auto& level : through_levels) {
      difference = base::nan_max(difference, std::abs(level[c] - sum[c]));
    }
  }
  return difference > 0 ? difference / largest : 0;
}

finite_layers::FieldState field_state(const SkinModel& model, const std::array<double, 2>& centre,
                                      const CellVector& forces) {
  const mesh::MeshLines lines = model.mesh.lines(centre);
  return {{halves(lines.x), halves(lines.y), lines.x, lines.y}, centre, forces};
}

CoreStrain core_strain(finite_layers::StrainField field) {
  return {field.points, std::move(field.component)};
}

} // namespace

finite_layers::ComponentChoice strain_components(const Case& input) {
  finite_layers::ComponentChoice result = laws::shear_measure(input.coupling.measure).reads;
  if (moves_water(input)) { // the dilation is needed too
    result[0] = result[1] = result[2] = true;
  }
  return result;
}

StrainRecovery::StrainRecovery(std::shared_ptr<const SkinModel> model,
                               const finite_layers::ComponentChoice& components, int threads)
    : model_(std::move(model)),
      fields_(model_->layers.fields(heights(model_->mesh), mean_column(model_->mesh), components,
                                    places_across(*model_), threads)) {}

std::vector<RecoveredStrain> StrainRecovery::at(std::span<const std::array<double, 2>> centres,
                                                std::span<const CellVector> forces) const {
  std::vector<finite_layers::FieldState> states;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    states.push_back(field_state(*model_, centres[i], forces[i]));
  }
  std::vector<finite_layers::CoreAndElectrodes> found = fields_.at(states);
  std::vector<RecoveredStrain> result;
  for (std::size_t i = 0; i < found.size(); ++i) {
    result.push_back(
        {core_strain(std::move(found[i].core)), largest_stresses(*model_, found[i].electrodes),
         equilibrium_residual(forces[i], model_->mesh.half_model(),
                              model_->layers.sides_on_rollers(), found[i].force_through_level)});
  }
  return result;
}

StrainRecovery::LayersOfState StrainRecovery::all_layers() const {
  const std::shared_ptr<const finite_layers::SkinFields> all(new finite_layers::SkinFields(
      model_->layers.fields(heights(model_->mesh), mean_column(model_->mesh))));
  return [model = model_, all](const std::array<double, 2>& centre, const CellVector& forces) {
    finite_layers::CoreAndElectrodes found =
        std::move(all->at({field_state(*model, centre, forces)}).front());
    return LayerStrain{core_strain(std::move(found.core)),
                       core_strain(std::move(found.electrodes))};
  };
}

} // namespace ionskin::mechanics
