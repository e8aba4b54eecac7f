// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/faces/free_ends.hpp"
#include "ionskin/finite_layers/fields/plane_waves.hpp"
#include "ionskin/finite_layers/plane/wave_split.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace ionskin::finite_layers {

/// Answer of the modes of a skin to motions of two opposite faces: of modes along the faces and,
/// for each, a choice of modes across them between which strains are smooth.
struct FaceModes {
  Face face = Face::side;            ///< side: along is x and across is y; end: the other way round
  double along = 0, across = 0;      ///< extent of the skin [m]
  std::vector<Eigen::Index> modes;   ///< along
  std::vector<Eigen::Index> numbers; ///< across, of one parity, ascending
  std::vector<std::vector<ModeMotion>> motion; ///< [mode][number]

  /// @param parity of the modes across: the faces move alike under even ones
  /// @param last wave number across up to which modes are summed [1/m]
  /// @param threads that make it
  FaceModes(const ThicknessColumn& column, Face of_face, double extent_along, double extent_across,
            std::vector<Eigen::Index> modes_along, Parity parity, double last, int threads);

  PlaneMode mode(std::size_t at, std::size_t number) const;
};

/// Strain within the skin over the motion of two opposite faces, docs/model.md (60), at levels,
/// for modes along the faces. Strains need no help to converge, as
/// displacements would: with the face's motion in them they are the Fourier coefficients of what is
/// smooth but for the faces, and fall like 1/n^2 or faster.
class FaceStrain {
public:
  /// @param most modes along the face, of those that there are
  FaceStrain(const ThicknessColumn& column, const FaceModes& modes,
             const std::vector<DepthLevel>& levels, const ComponentChoice& components,
             std::size_t most);

  Eigen::Index modes() const { return static_cast<Eigen::Index>(of_mode_.size()); }
  /// Strains of states, each at its own places: at all levels, [place, level + count of levels *
  /// mode along the face], empty of components that were not chosen.
  /// @param motions [node, mode]
  /// @param places across the skin
  std::vector<Strains> at(const std::vector<const Eigen::MatrixXd*>& motions,
                          const std::vector<const std::vector<Interval>*>& places) const;

private:
  /// Shares of four chosen modes in one that lies between them, whose strain times n^2 is a cubic
  /// in ln n there.
  struct Between {
    Eigen::Index mode = 0, first = 0; ///< of all of the parity, of the chosen
    std::array<double, 4> share{};
  };
  /// Means of cos or sin of the first modes over places, gathered by the chosen ones,
  /// [place, number].
  Eigen::MatrixXd gathered(const Eigen::ArrayXXd& means) const;
  /// Means of cosines and of sines, gathered likewise.
  std::array<Eigen::MatrixXd, 2> waves_at(const std::vector<Interval>& places) const;

  Face face_;
  ComponentChoice components_;
  double across_; ///< extent of the skin [m]
  std::vector<Eigen::Index> numbers_;
  std::vector<WaveSplit> smooth_; ///< waves far from both faces, nearer and nearer
  std::vector<Between> between_;
  Eigen::Index levels_;
  std::vector<Strains> of_mode_; ///< [level, number] by rows, and node
};

} // namespace ionskin::finite_layers
