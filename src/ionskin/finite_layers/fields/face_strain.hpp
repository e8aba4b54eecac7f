// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/faces/free_ends.hpp"
#include "ionskin/finite_layers/fields/plane_waves.hpp"
#include "ionskin/finite_layers/plane/wave_split.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace ionskin::finite_layers {

/// Displacements that the modes of a skin answer to the motion of a pair of opposite faces. They
/// are stored for each mode along the faces and for selected modes across them, from one face to
/// the other; the modes between are interpolated, as strains are smooth in the mode number.
struct FaceModes {
  /// Faces that move. For `side`, along is x and across is y; for `end`, along is y and across is
  /// x.
  Face face = Face::side;
  double along = 0, across = 0;    ///< size of the skin along and across the faces [m]
  std::vector<Eigen::Index> modes; ///< numbers of the modes along the faces
  /// Numbers of the selected modes across, of one parity, ascending.
  std::vector<Eigen::Index> numbers;
  std::vector<std::vector<ModeMotion>> motion; ///< [mode][number]

  /// Selects the modes across and calculates their displacements.
  /// @param extent_along,extent_across size of the skin along and across the faces [m]
  /// @param modes_along numbers of the modes along the faces
  /// @param parity of the modes across: the faces move identically under even ones
  /// @param last wave number across up to which modes are summed [1/m]
  /// @param threads number of threads to use
  FaceModes(const ThicknessColumn& column, Face of_face, double extent_along, double extent_across,
            std::vector<Eigen::Index> modes_along, Parity parity, double last, int threads);

  /// Wave numbers of a pair of modes, by their indices in `modes` and `numbers`.
  PlaneMode mode(std::size_t at, std::size_t number) const;
};

/// Strain within the skin that the motion of a pair of opposite faces causes, at several levels,
/// docs/model.md (60). Its Fourier series need no convergence acceleration, as those of
/// displacements would: with the motion of the faces included, strains are smooth except at the
/// faces, and their coefficients fall like 1/n^2 or faster.
class FaceStrain {
public:
  /// Makes the operators from motions to strains.
  /// @param modes answer of the skin to the motion
  /// @param levels positions through the thickness
  /// @param components of the strain that are needed
  /// @param most largest number of modes along the faces to use
  FaceStrain(const ThicknessColumn& column, const FaceModes& modes,
             const std::vector<DepthLevel>& levels, const ComponentChoice& components,
             std::size_t most);

  /// Number of modes along the faces in use.
  Eigen::Index modes() const { return static_cast<Eigen::Index>(of_mode_.size()); }
  /// Calculates the strains of several states [1], each [place, level + number of levels * mode
  /// along the faces]. Components that were not chosen are empty.
  /// @param motions one entry per state, [node, mode along the faces] [m]
  /// @param places one entry per state, positions across the skin from its corner [m]
  std::vector<Strains> at(const std::vector<const Eigen::MatrixXd*>& motions,
                          const std::vector<const std::vector<Interval>*>& places) const;

private:
  /// Interpolation of one mode between the selected ones: its strain times n^2 is a cubic in ln n
  /// through the four nearest selected modes.
  struct Between {
    /// Index of the mode among all of its parity, and index of the first of the four selected
    /// modes.
    Eigen::Index mode = 0, first = 0;
    std::array<double, 4> share{}; ///< weights of the four selected modes [1]
  };
  /// Sums the means of cosines or sines of all modes over places into the selected modes, by the
  /// weights of the interpolation, [place, selected mode].
  /// @param means of the first modes of the parity, [place, mode]
  Eigen::MatrixXd gathered(const Eigen::ArrayXXd& means) const;
  /// Means of cosines and of sines over places, in the layout of `gathered`.
  std::array<Eigen::MatrixXd, 2> waves_at(const std::vector<Interval>& places) const;

  Face face_;
  ComponentChoice components_;
  double across_; ///< size of the skin across the faces [m]
  std::vector<Eigen::Index> numbers_;
  /// Splits of which only the long waves are felt far from both faces, for places from the farthest
  /// to nearer ones.
  std::vector<WaveSplit> smooth_;
  std::vector<Between> between_;
  Eigen::Index levels_;
  /// Strain per motion of each mode along the faces, [number + count of numbers * level, node].
  std::vector<Strains> of_mode_;
};

} // namespace ionskin::finite_layers
