// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/fields/field_components.hpp"
#include "ionskin/finite_layers/fields/field_skin.hpp"
#include "ionskin/finite_layers/plane/plane_compliance.hpp"
#include "ionskin/finite_layers/plane/wave_split.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace ionskin::finite_layers {

/// Grid of the places at which strains are asked for [m].
struct FieldGrid {
  /// Places in the core from the skin's corner, ascending: strain is averaged over each, and that
  /// of a place without size is of a point.
  std::vector<Interval> x, y;
  /// Lines between the columns over which the strain of the electrodes is averaged.
  std::vector<double> column_x, column_y;
};

/// Small strain on a tensor grid: six tensor components xx, yy, zz, yz, xz, xy, each [z][y][x] with
/// x fastest; x and y along the skin, z upwards; empty of components that were not asked for [1].
struct StrainField {
  std::array<std::size_t, 3> points{}; ///< along x, y, z
  std::array<std::vector<double>, 6> component;
};

struct CoreAndElectrodes {
  StrainField core;
  /// Averaged through the thickness of each electrode layer, bottom to top in the place of z, and
  /// over each column.
  StrainField electrodes;
  /// Force that the part above each level of the core lays on the part below, over the whole plane:
  /// normal (downwards), x, y. They equal the sums of the forces on the cells of the full skin [N].
  std::vector<std::array<double, 3>> force_through_level;
};

/// A state of which strains are asked for.
struct FieldState {
  FieldGrid grid;
  std::array<double, 2> centre{}; ///< of the slider from the skin's corner [m]
  /// On the cells, x fastest, each normal (downwards), x, y; even over a cell [N].
  std::vector<double> forces;
};

/// Places that all states have alike where the slider keeps its place across the skin [m].
struct PlacesAcross {
  double centre_y = 0; ///< of the slider
  std::vector<Interval> y;
  std::vector<double> column_y; ///< as of FieldGrid
};

/// Strain in the core and the electrodes of a skin under forces on contact cells, docs/model.md
/// (58) to (60). All that does not depend on the place of the slider is made once; `at` changes
/// nothing, so that states may be asked for on several threads at a time.
class SkinFields {
public:
  /// @param cells under the slider; where they are half of them, the slider stays in the middle of
  ///        the width, and y ends there
  /// @param split the one that sides and ends were made with: strains near a free face lack what
  ///        short waves do that reach it
  /// @throws InternalError where a level is not in the core, or on the top face
  /// @param tolerance share of a wave, of what it is on the top face, that is left out
  /// @param heights of the points above the bottom of the core, ascending [m]
  /// @param column size of the columns of the electrodes, about [m]
  /// @param components of the core
  /// @param across where all states have it alike: they cost less then
  SkinFields(const FieldSkin& skin, const ContactGrid& cells, const std::vector<double>& heights,
             double column, const WaveSplit& split,
             const ComponentChoice& components = all_components,
             const std::optional<PlacesAcross>& across = std::nullopt, int threads = 1,
             double tolerance = 1e-4);
  ~SkinFields();

  /// Strains of states; some at once cost less than one by one, and each is the same bits in any
  /// company.
  std::vector<CoreAndElectrodes> at(const std::vector<FieldState>& states) const;

private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

} // namespace ionskin::finite_layers
