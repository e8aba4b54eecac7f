// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/plane/plane_compliance.hpp"
#include "ionskin/finite_layers/thickness/surface_compliance.hpp"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

namespace ionskin::finite_layers {

/// Means of the cosine and of the sine of each mode along one direction over each column or row of
/// cells, [column or row, mode] [1].
struct ModeTransform {
  Eigen::ArrayXXd cosine, sine;
};

/// Modes of the skin along one direction, with the wave numbers m pi / extent, m = 0, 1, ...
struct ModeLine {
  double extent = 0;           ///< size of the skin in this direction [m]
  Eigen::ArrayXd wave_numbers; ///< [1/m]
  Eigen::ArrayXd weights;      ///< 1/extent for m = 0 and 2/extent for m > 0 [1/m]

  /// Makes all modes of a direction up to a wave number.
  /// @param extent size of the skin in this direction [m]
  /// @param last largest wave number [1/m]
  static ModeLine up_to(double extent, double last);
  /// Calculates the means of the modes over the cells between grid lines, for one position of the
  /// slider.
  /// @param lines of the cells, measured from the slider's centre, ascending [m]
  /// @param centre position of the slider's centre, measured from the skin's corner [m]
  ModeTransform transform(const std::vector<double>& lines, double centre) const;
};

/// Part of the sum over modes along x or along y. `alike` is the part that does not depend on the
/// slider's position in this direction, as in a skin without faces there; `mirrored` is the part
/// that mirror images in the two faces add.
enum class ModePart { alike, mirrored };

/// Modes of a skin whose four side faces are held by rollers: displacements along the top face are
/// sines and cosines that meet this boundary condition exactly, docs/model.md (48). They carry the
/// share of long waves in the compliance of the top face (54). Mirror images of the load in the
/// four faces are included.
class BoxModes {
public:
  /// Makes the modes that the long waves of `split` need.
  /// @param length,width of the skin [m]
  BoxModes(const SurfaceCompliance& surface, double length, double width, const WaveSplit& split);

  const ModeLine& along_x() const { return x_; }
  const ModeLine& along_y() const { return y_; }

  /// Calculates the compliance of rows of cells for each mode along x: mean displacements over
  /// forces, which are normal (downwards), x and y and vary along x like cosine, sine and cosine.
  /// One matrix per mode, [3 row + component, 3 row + component] [m2/N].
  /// @param centre_y position of the slider's centre along y, from the skin's corner [m]
  std::vector<Eigen::MatrixXd> rows(const ContactGrid& grid, double centre_y) const;
  /// Calculates one part of the sum over the modes along y, in the same form. Not for a half grid,
  /// whose two halves are mirror images of each other.
  /// @param share factor on each of the first modes, [mode along x, mode along y] [1]; further
  /// modes are left out
  /// @param centre_y any value for `ModePart::alike`
  /// @returns one matrix for each mode along x of `share`
  std::vector<Eigen::MatrixXd> rows(const ContactGrid& grid, double centre_y, ModePart part,
                                    const Eigen::ArrayXXd& share) const;

  /// Compliance of all modes between two components, times the weight of the mode along y and the
  /// share of long waves. It does not depend on the position of the slider.
  struct Between {
    Eigen::Index at = 0, from = 0; ///< component of displacement and of force: 0 normal, 1 x, 2 y
    Eigen::MatrixXd waves;         ///< [mode along x, mode along y] [m2/N]
  };
  /// Compliance of all modes for each unordered pair of components; the compliance is symmetric.
  const std::array<Between, 6>& between() const { return between_; }

private:
  std::vector<Eigen::MatrixXd> summed(const ContactGrid& grid, double centre_y,
                                      std::optional<ModePart> part,
                                      const Eigen::ArrayXXd& share) const;

  ModeLine x_, y_;
  std::array<Between, 6> between_;
};

/// Adds one part of the sum over the modes along x to the compliance matrix of the cells, [3 cell +
/// component, 3 cell + component] [m/N].
/// @param rows compliance of the rows of cells for each mode along x, from `BoxModes::rows`
/// @param share factor on each of the first modes along x [1]; further modes are left out
/// @param centre_x position of the slider's centre along x, from the skin's corner [m]; any value
/// for `ModePart::alike`
void add_modes(const std::vector<Eigen::MatrixXd>& rows, const ModeLine& along_x, ModePart part,
               const Eigen::ArrayXd& share, const ContactGrid& grid, double centre_x,
               Eigen::MatrixXd& compliance);

} // namespace ionskin::finite_layers
