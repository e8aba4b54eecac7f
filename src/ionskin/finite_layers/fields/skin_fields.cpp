// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/fields/skin_fields.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/finite_layers/fields/field_target.hpp"
#include "ionskin/finite_layers/fields/mode_means.hpp"
#include "ionskin/finite_layers/fields/wave_bands.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace ionskin::finite_layers {
namespace {

/// Largest difference, over the width of the skin, between two positions that count as identical.
constexpr double same_place = 1e-9;
/// Largest wave number times the size of a column: waves with more than some 16 periods in a column
/// average out.
constexpr double column_waves = 100;

/// Intervals between successive lines [m].
std::vector<Interval> intervals(const std::vector<double>& lines) {
  std::vector<Interval> result;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    result.push_back({lines[i], lines[i + 1]});
  }
  return result;
}

/// Returns the places and, as a last one, the whole extent of the skin.
std::vector<Interval> with_whole(std::vector<Interval> places, double extent) {
  places.push_back({0, extent});
  return places;
}

/// Thickness of the layer `from` and all layers above it [m].
double thickness(const std::vector<ElasticLayer>& layers, std::size_t from) {
  return std::accumulate(
      layers.begin() + static_cast<std::ptrdiff_t>(from), layers.end(), 0.0,
      [](double sum, const ElasticLayer& layer) { return sum + layer.thickness; });
}

/// Levels in the core at given heights above its bottom [m]. Waves beyond the cutoff of a level
/// have decayed to less than the tolerance on their way from the top face.
FieldLevels core_levels(const FieldSkin& skin, const std::vector<double>& heights,
                        double tolerance) {
  FieldLevels result;
  for (const double z : heights) {
    if (z < 0 || z > skin.layers[skin.core].thickness || z >= thickness(skin.layers, skin.core)) {
      throw InternalError("strain was asked for outside the core, or on the top face, where "
                          "waves of any length are felt");
    }
    result.levels.push_back({skin.core, z});
    result.cutoffs.push_back(-std::log(tolerance) / (thickness(skin.layers, skin.core) - z));
  }
  return result;
}

/// Levels of the electrodes, one for the mean through each layer.
/// @param column size of the columns over which their strain is averaged [m]
FieldLevels electrode_levels(const FieldSkin& skin, double column, double tolerance) {
  FieldLevels result;
  for (std::size_t i = 0; i < skin.layers.size(); ++i) {
    if (i != skin.core) {
      const double depth = std::max(skin.layers[i].thickness, thickness(skin.layers, i + 1));
      result.levels.push_back({i, {}});
      result.cutoffs.push_back(std::min(-std::log(tolerance) / depth, column_waves / column));
    }
  }
  return result;
}

/// Adds the shear components yz and xz, whose means over the plane give the shear force of a level.
ComponentChoice with_shear_forces(ComponentChoice components) {
  components[3] = components[4] = true; // yz, xz
  return components;
}

double largest(const std::vector<double>& values) {
  return *std::ranges::max_element(values);
}

/// Sorts forces by component, [column, row] [N].
/// @param forces [3 cells] [N]
CellForces by_cells(const ContactGrid& cells, const std::vector<double>& forces) {
  CellForces result;
  for (std::size_t c = 0; c < 3; ++c) {
    const Eigen::Map<const Eigen::MatrixXd, 0, Eigen::InnerStride<3>> own(
        forces.data() + c, cells.columns(), cells.rows());
    result[c] = (cells.half ? 2 : 1) * own; // in even modes, the mirror image doubles the force
  }
  return result;
}

/// Shifts the intervals between lines, which count from the slider's centre, by the position of the
/// centre.
std::vector<Interval> from_corner(const std::vector<double>& lines, double centre) {
  std::vector<Interval> result = intervals(lines);
  for (Interval& cell : result) {
    cell.from += centre;
    cell.to += centre;
  }
  return result;
}

/// Converts sums of modes into a field. If `whole` is true, it leaves out the last place along x
/// and y, which is the whole plane.
StrainField strain_field(const FieldTarget& target, const ByKind& sums, const FieldPlaces& places,
                         bool whole) {
  const std::size_t nx = places.x.size() - (whole ? 1 : 0), ny = places.y.size() - (whole ? 1 : 0),
                    levels = target.levels().levels.size();
  StrainField field{{nx, ny, levels}, {}};
  for (std::size_t c = 0; c < 6; ++c) {
    for (std::size_t level = 0; level < levels; ++level) {
      const Eigen::MatrixXd own = target.component(sums, places, c, level);
      if (own.size() > 0) {
        field.component[c].resize(nx * ny * levels);
        Eigen::Map<Eigen::MatrixXd>(field.component[c].data() + nx * ny * level,
                                    static_cast<Eigen::Index>(nx), static_cast<Eigen::Index>(ny)) =
            own.topLeftCorner(static_cast<Eigen::Index>(nx), static_cast<Eigen::Index>(ny));
      }
    }
  }
  return field;
}

} // namespace

struct SkinFields::Parts {
  static constexpr ComponentChoice normal_components{true, true, true, false, false, false};
  /// Sums over rows of cells of the waves of a band.
  struct BandRows {
    RowStrains core, electrodes;
  };

  FieldSkin skin;
  ContactGrid cells;
  FieldTarget core, electrodes;
  /// Calculates the normal strains of the core, for their means over the whole plane.
  FaceFields core_normal;
  std::vector<WaveBand> bands; ///< first the modes of the whole skin
  /// Sums over rows for each band but the first; empty where the slider moves across the skin.
  std::vector<BandRows> rows;
  double rows_at = 0; ///< position of the slider along y for which these sums hold [m]

  Parts(const FieldSkin& layered, const ContactGrid& contact, const std::vector<double>& heights,
        double column, const WaveSplit& split, const ComponentChoice& components,
        const std::optional<PlacesAcross>& across, int threads, double tolerance)
      : skin(layered), cells(contact),
        core(skin, core_levels(skin, heights, tolerance), with_shear_forces(components)),
        electrodes(skin, electrode_levels(skin, column, tolerance), all_components),
        core_normal(skin, core.levels().levels, normal_components, 1),
        bands(wave_bands(
            skin, cells, split,
            std::max(largest(core.levels().cutoffs), largest(electrodes.levels().cutoffs)))) {
    if (across) {
      rows_at = across->centre_y;
      const std::array<double, 2> centre{0, across->centre_y};
      const std::vector<Interval> of_core = with_whole(across->y, skin.width),
                                  columns = intervals(across->column_y);
      for (std::size_t i = 1; i < bands.size(); ++i) {
        const PlaneWaves& waves = bands[i].waves;
        const PlaneBox box = box_of(bands[i], centre);
        const ModeTransform means = of_rows(waves, box, across->centre_y);
        rows.push_back({core.row_strains(waves, box, means, of_core, threads),
                        electrodes.row_strains(waves, box, means, columns, threads)});
      }
    }
  }

  ModeTransform of_rows(const PlaneWaves& waves, const PlaneBox& box, double centre_y) const {
    return mode_means(from_corner(cells.y, centre_y - box.y), waves.step_y(), waves.modes_y());
  }

  /// Box of a band about the footprint.
  /// @param centre of the slider, from the skin's corner [m]
  PlaneBox box_of(const WaveBand& band, const std::array<double, 2>& centre) const {
    return band.box(
        {centre[0] + 0.5 * (cells.x.front() + cells.x.back()),
         cells.half ? centre[1] : centre[1] + 0.5 * (cells.y.front() + cells.y.back())});
  }

  WaveLoads loads_in(const PlaneWaves& waves, const PlaneBox& box, const CellForces& forces,
                     const std::array<double, 2>& centre) const {
    return {forces,
            mode_means(from_corner(cells.x, centre[0] - box.x), waves.step_x(), waves.modes_x()),
            of_rows(waves, box, centre[1])};
  }

  /// Calculates the force over the whole plane at each level of the core. Of the modes on rollers,
  /// only the uniform one has a mean normal stress, which is that of the forces.
  /// @param core_strain strain with the whole plane as the last place along x and y
  /// @param normal force on all cells [N]
  std::vector<std::array<double, 3>> force_through_levels(const ByKind& core_strain,
                                                          const FieldPlaces& places, double normal,
                                                          const FaceMotion& motion) const {
    constexpr std::size_t yz = 3, xz = 4;
    const ElasticLayer& layer = skin.layers[skin.core];
    const double area = skin.length * skin.width;
    const auto levels = static_cast<Eigen::Index>(core.levels().levels.size());
    std::vector<ByKind> mean{{Eigen::MatrixXd::Zero(1, 3 * levels), Eigen::MatrixXd(1, 0)}};
    core_normal.add({motion}, {{{{0, skin.length}}, {{0, skin.width}}}}, mean);
    std::vector<std::array<double, 3>> result;
    for (Eigen::Index level = 0; level < levels; ++level) {
      const auto at = mean[0][0].row(0).segment(3 * level, 3);
      const auto shear = [&](std::size_t c) {
        const Eigen::MatrixXd own =
            core.component(core_strain, places, c, static_cast<std::size_t>(level));
        return 2 * layer.shear_modulus * area * own(own.rows() - 1, own.cols() - 1);
      };
      result.push_back(
          {normal - area * (layer.lame_lambda * at.sum() + 2 * layer.shear_modulus * at(2)),
           shear(xz), shear(yz)});
    }
    return result;
  }

  /// Sums the forces by the modes of the whole skin, in the layout that the faces expect: for a
  /// symmetric load, with the odd modes across the skin, which are 0.
  std::array<Eigen::MatrixXd, 3> on_faces(const WaveLoads& loads) const {
    const PlaneWaves& waves = bands.front().waves;
    const Eigen::Index modes_x = waves.modes_x(), modes_y = waves.modes_y();
    std::array<Eigen::MatrixXd, 3> result;
    for (std::size_t c = 0; c < 3; ++c) {
      const Eigen::MatrixXd own = loads.by_mode(c, 0, modes_x, 0, modes_y);
      if (!cells.half) {
        result[c] = own;
        continue;
      }
      result[c] = Eigen::MatrixXd::Zero(modes_x, 2 * modes_y);
      result[c](Eigen::all, Eigen::seqN(0, modes_y, 2)) = own;
    }
    return result;
  }
};

SkinFields::SkinFields(const FieldSkin& skin, const ContactGrid& cells,
                       const std::vector<double>& heights, double column, const WaveSplit& split,
                       const ComponentChoice& components, const std::optional<PlacesAcross>& across,
                       int threads, double tolerance) {
  parts_ = std::make_unique<Parts>(skin, cells, heights, column, split, components, across, threads,
                                   tolerance);
}

SkinFields::~SkinFields() = default;

std::vector<CoreAndElectrodes> SkinFields::at(const std::vector<FieldState>& states) const {
  const Parts& parts = *parts_;
  const FieldSkin& skin = parts.skin;
  std::vector<CellForces> by_cell;
  std::vector<FieldPlaces> in_core, columns;
  std::vector<ByKind> core, electrodes;
  for (const FieldState& state : states) {
    if (state.forces.size() != static_cast<std::size_t>(3 * parts.cells.count())) {
      throw InternalError("each cell has three forces");
    }
    if (!parts.rows.empty() &&
        std::abs(state.centre[1] - parts.rows_at) > same_place * skin.width) {
      throw InternalError("a slider that keeps its place across the skin has left it");
    }
    by_cell.push_back(by_cells(parts.cells, state.forces));
    in_core.push_back(
        {with_whole(state.grid.x, skin.length), with_whole(state.grid.y, skin.width)});
    columns.push_back({intervals(state.grid.column_x), intervals(state.grid.column_y)});
    core.push_back(parts.core.none(in_core.back()));
    electrodes.push_back(parts.electrodes.none(columns.back()));
  }
  std::vector<FaceMotion> motions;
  for (std::size_t i = 0; i < parts.bands.size(); ++i) {
    const PlaneWaves& waves = parts.bands[i].waves;
    std::vector<PlaneBox> boxes;
    std::vector<WaveLoads> loads;
    for (std::size_t state = 0; state < states.size(); ++state) {
      const std::array<double, 2>& centre = states[state].centre;
      boxes.push_back(parts.box_of(parts.bands[i], centre));
      loads.push_back(parts.loads_in(waves, boxes.back(), by_cell[state], centre));
      if (i == 0) {
        motions.push_back(face_motion(skin, parts.on_faces(loads.back()), parts.cells.half));
      }
    }
    const Parts::BandRows* rows = i > 0 && !parts.rows.empty() ? &parts.rows[i - 1] : nullptr;
    parts.core.add_waves(waves, loads, boxes, in_core, rows ? &rows->core : nullptr, core);
    parts.electrodes.add_waves(waves, loads, boxes, columns, rows ? &rows->electrodes : nullptr,
                               electrodes);
  }
  parts.core.faces().add(motions, in_core, core);
  parts.electrodes.faces().add(motions, columns, electrodes);
  std::vector<CoreAndElectrodes> result;
  for (std::size_t state = 0; state < states.size(); ++state) {
    result.push_back({strain_field(parts.core, core[state], in_core[state], true),
                      strain_field(parts.electrodes, electrodes[state], columns[state], false),
                      parts.force_through_levels(core[state], in_core[state],
                                                 by_cell[state][0].sum(), motions[state])});
  }
  return result;
}

} // namespace ionskin::finite_layers
