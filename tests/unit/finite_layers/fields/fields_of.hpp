// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/fields/field_faces.hpp"
#include "ionskin/finite_layers/fields/skin_fields.hpp"
#include "paper_skin.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ionskin::finite_layers {

/// Points and columns, as of FieldGrid, with the heights of the points above the core's bottom.
struct TestGrid {
  std::vector<double> x, y, z, column_x, column_y;
};

/// A small skin with everything that its fields need.
struct FieldCase {
  std::vector<ElasticLayer> layers = paper_skin();
  std::size_t core = 1;
  double length = 3e-3, width = 1.2e-3;
  WaveSplit split{0.3e-3, 1e-4};
  int degree = 4;
  std::vector<ElementSizes> elements{{1}, {1, 2, 2, 1}, {1}};
  bool sides_free = false, ends_free = false;
  FaceResolution sides{60, 60}, ends{16, 120};
  double tolerance = 1e-4;
};

inline std::vector<Interval> points(const std::vector<double>& at) {
  std::vector<Interval> result;
  for (const double place : at) {
    result.push_back({place, place});
  }
  return result;
}

/// Sum of the forces on cells along a component, [3 cell + component].
inline double sum(const std::vector<double>& forces, std::size_t component) {
  double result = 0;
  for (std::size_t i = component; i < forces.size(); i += 3) {
    result += forces[i];
  }
  return result;
}

class FieldsOf {
public:
  FieldsOf(const FieldCase& given, const ContactGrid& cells, const TestGrid& grid,
           const std::optional<PlacesAcross>& across = std::nullopt,
           const ComponentChoice& components = all_components)
      : grid_{points(grid.x), points(grid.y), grid.column_x, grid.column_y},
        column_(given.layers, given.elements, given.degree) {
    if (given.sides_free) {
      sides_.emplace(column_, given.length, given.width, given.split, given.sides);
    }
    if (given.ends_free) {
      ends_.emplace(column_, given.length, given.width, given.split, given.ends,
                    sides_ ? &*sides_ : nullptr);
    }
    FieldSkin skin{given.layers,
                   given.core,
                   given.length,
                   given.width,
                   &column_,
                   sides_ ? &*sides_ : nullptr,
                   ends_ ? &*ends_ : nullptr};
    skin.faces = std::make_shared<const FieldFaces>(skin, cells.half, 1);
    fields_.emplace(skin, cells, grid.z, grid_.column_x[1] - grid_.column_x[0], given.split,
                    components, across, 1, given.tolerance);
  }

  CoreAndElectrodes at(const std::array<double, 2>& centre,
                       const std::vector<double>& forces) const {
    return fields_->at({{grid_, centre, forces}}).front();
  }

private:
  FieldGrid grid_;
  ThicknessColumn column_;
  std::optional<FreeSides> sides_;
  std::optional<FreeEnds> ends_;
  std::optional<SkinFields> fields_;
};

inline double largest(const StrainField& field) {
  double result = 0;
  for (const auto& component : field.component) {
    for (const double value : component) {
      result = std::max(result, std::abs(value));
    }
  }
  return result;
}

/// Largest difference of two fields over the largest value of the second.
inline double difference(const StrainField& one, const StrainField& other) {
  double result = 0;
  for (std::size_t c = 0; c < 6; ++c) {
    for (std::size_t i = 0; i < other.component[c].size(); ++i) {
      result = std::max(result, std::abs(one.component[c][i] - other.component[c][i]));
    }
  }
  return result / largest(other);
}

} // namespace ionskin::finite_layers
