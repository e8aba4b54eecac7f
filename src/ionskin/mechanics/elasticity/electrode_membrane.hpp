// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/elasticity/elastic_law.hpp"
#include "ionskin/mechanics/elasticity/elastic_space.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::mechanics {

/// The electrodes as membranes: strain averaged through the thickness of each electrode layer and
/// over each column of elements. Averages converge under the slider's edges, where points do not.
class ElectrodeMembrane {
public:
  /// @param law_of_row, layer_of_row elastic law and layer of each element row along z
  ElectrodeMembrane(const ElasticSpace& space, const mesh::MeshLines& lines,
                    const std::vector<ElasticLaw>& law_of_row,
                    const std::vector<std::size_t>& layer_of_row,
                    const std::array<std::size_t, 2>& core_z);

  /// Averages of all layers: six tensor components xx, yy, zz, yz, xz, xy per column of elements.
  int rows() const { return static_cast<int>(6 * columns_ * layers_.size()); }
  /// @param displacement [unknowns] [m]
  /// @param average [rows()] [1]
  void average_strain(const double* displacement, double* average) const;

  /// Largest von Mises stress of the averaged strain in each electrode layer, bottom to top [Pa].
  std::vector<double> largest_stress(const double* average) const;

private:
  struct Layer {
    std::size_t first_row = 0, last_row = 0; ///< element rows, last included
    ElasticLaw law;
  };
  const ElasticSpace& space_;
  const mesh::MeshLines& lines_;
  std::size_t columns_ = 0; ///< of elements
  std::vector<Layer> layers_;
};

/// Von Mises stress of a strain with components as above [Pa].
double von_mises_stress(const ElasticLaw& law, const double* strain);

} // namespace ionskin::mechanics
