// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/plane/plane_compliance.hpp"
#include "ionskin/finite_layers/thickness/surface_compliance.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace ionskin::finite_layers {

/// Means of cos and sin of the modes of one direction over the columns or rows of a grid,
/// [column or row, mode].
struct ModeTransform {
  Eigen::ArrayXXd cosine, sine;
};

/// Modes m pi / extent along one direction of the skin, m = 0, 1, ...
struct ModeLine {
  double extent = 0;           ///< of the skin [m]
  Eigen::ArrayXd wave_numbers; ///< [1/m]
  Eigen::ArrayXd weights;      ///< 1 for m = 0 and 2 beyond, over the extent [1/m]

  /// Modes of a direction up to a wave number.
  /// @param last largest wave number [1/m]
  static ModeLine up_to(double extent, double last);
  /// Means of the modes over the cells between lines, with the slider at a place.
  /// @param lines of cells from the slider's centre [m]
  /// @param centre of the slider [m]
  ModeTransform transform(const std::vector<double>& lines, double centre) const;
};

/// The share of long waves in the surface compliance of a skin whose four
/// side faces are held by rollers: displacements along the face are sines and cosines that meet
/// them, docs/model.md (48), (54). Its mirror images in the faces come with it.
class BoxModes {
public:
  BoxModes(const SurfaceCompliance& surface, double length, double width, const WaveSplit& split);

  const ModeLine& along_x() const { return x_; }
  const ModeLine& along_y() const { return y_; }

  /// Compliance of the rows of cells for each mode along x, [3 row + component, the same]: normal,
  /// x, y, over forces that vary along x like cosine, sine, cosine.
  std::vector<Eigen::MatrixXd> rows(const ContactGrid& grid, double centre_y) const;

  /// Compliance of all modes between two components, with their weights along y and their share,
  /// [mode along x, along y]; the same at every place.
  struct Between {
    Eigen::Index at = 0, from = 0; ///< normal, x or y
    Eigen::MatrixXd waves;
  };
  /// Products of the modes of each two components, each pair once.
  const std::array<Between, 6>& between() const { return between_; }

private:
  ModeLine x_, y_;
  std::array<Between, 6> between_;
};

/// Part of the modes along x: what does not depend on the place along the skin, as in an endless
/// one, or what the ends mirror.
enum class ModePart { alike, mirrored };

/// Adds to the compliance of cells, [3 cell + component], a part of what modes along x do: for
/// each, the compliance of the rows, as `BoxModes::rows` gives them.
/// @param share of each of the first modes that counts
/// @param centre_x of the slider; any for the part that does not depend on it [m]
void add_modes(const std::vector<Eigen::MatrixXd>& rows, const ModeLine& along_x, ModePart part,
               const Eigen::ArrayXd& share, const ContactGrid& grid, double centre_x,
               Eigen::MatrixXd& compliance);

} // namespace ionskin::finite_layers
