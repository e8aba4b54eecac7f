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

/// Grid of the positions at which strains are wanted, from the skin's corner [m].
struct FieldGrid {
  /// Intervals in the core, ascending, over which strain is averaged. An interval of size 0 is a
  /// point.
  std::vector<Interval> x, y;
  /// Grid lines of the columns over which the strain of the electrodes is averaged, ascending.
  std::vector<double> column_x, column_y;
};

/// Small strain on a tensor grid, as tensor components xx, yy, zz, yz, xz, xy, each [z][y][x] with
/// x fastest [1]. x and y lie along the skin, z points upwards. Components that were not chosen are
/// empty.
struct StrainField {
  std::array<std::size_t, 3> points{}; ///< number of points along x, y, z
  std::array<std::vector<double>, 6> component;
};

/// Strain of one state in all layers, calculated by `SkinFields`.
struct CoreAndElectrodes {
  StrainField core;
  /// Strain of each electrode layer, bottom to top in place of z, averaged through the thickness of
  /// the layer and over each column.
  StrainField electrodes;
  /// Force over the whole plane that the part above each level of the core exerts on the part
  /// below: normal (downwards), x, y [N]. In equilibrium it equals the sum of the forces on the
  /// cells of the full skin, except along y where rollers hold the sides.
  std::vector<std::array<double, 3>> force_through_level;
};

/// Load and grid of one state whose strains are wanted.
struct FieldState {
  FieldGrid grid;
  std::array<double, 2> centre{}; ///< position of the slider's centre from the skin's corner [m]
  /// Forces on the cells, each normal (downwards), x, y, with cells numbered x fastest [N].
  /// Traction is uniform over a cell.
  std::vector<double> forces;
};

/// Positions across the skin that all states share when the slider keeps its position across the
/// skin [m].
struct PlacesAcross {
  double centre_y = 0;          ///< position of the slider's centre
  std::vector<Interval> y;      ///< as `FieldGrid::y`
  std::vector<double> column_y; ///< as `FieldGrid::column_y`
};

/// Calculates the strain in the core and the electrodes of a skin under forces on contact cells,
/// docs/model.md (58) to (60). All that does not depend on the state is prepared once. `at` changes
/// nothing, so that several threads may call it at a time.
class SkinFields {
public:
  /// Prepares the operators from forces to strains.
  /// @param cells under the slider. A half grid requires that the slider stays in the middle of the
  /// width; places along y then end there.
  /// @param heights of the points above the bottom of the core, ascending [m]
  /// @param column approximate size of the columns of the electrodes [m]
  /// @param split with which sides and ends were made. Strains near a free face lack the effect of
  /// short waves that reach the face.
  /// @param components of the strain of the core that are needed
  /// @param across positions that all states share, which reduces the cost per state; empty if they
  /// do not
  /// @param threads number of threads to use
  /// @param tolerance relative size, compared with the top face, at which a wave is neglected at a
  /// level [1]
  /// Throws InternalError when a height lies outside the core or on the top face.
  SkinFields(const FieldSkin& skin, const ContactGrid& cells, const std::vector<double>& heights,
             double column, const WaveSplit& split,
             const ComponentChoice& components = all_components,
             const std::optional<PlacesAcross>& across = std::nullopt, int threads = 1,
             double tolerance = 1e-4);
  ~SkinFields();

  /// Calculates the strains of states. Several states in one call cost less than single ones; the
  /// result of a state is bit for bit independent of the other states.
  /// Throws InternalError when a state does not have three forces per cell, or when its slider has
  /// left the position given by `across`.
  std::vector<CoreAndElectrodes> at(const std::vector<FieldState>& states) const;

private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

} // namespace ionskin::finite_layers
