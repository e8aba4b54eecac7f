// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/fields/field_target.hpp"

#include "ionskin/finite_layers/fields/mode_means.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <utility>

namespace ionskin::finite_layers {
namespace {

/// Wave number over the size of the skin below which a column is loaded evenly.
constexpr double even_load = 1e-4;

/// Places as far as they lie in a box, from its corner, with their indices, and the share of each
/// that lies in it.
struct PlacesInBox {
  std::vector<Interval> places;
  std::vector<Eigen::Index> index;
  std::vector<double> share;

  PlacesInBox(const std::vector<Interval>& all, double corner, double size) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Interval inside{std::max(all[i].from - corner, 0.0),
                            std::min(all[i].to - corner, size)};
      const bool point = all[i].size() == 0;
      if (point ? inside.from <= inside.to : inside.from < inside.to) {
        places.push_back(inside);
        index.push_back(static_cast<Eigen::Index>(i));
        share.push_back(point ? 1.0 : inside.size() / all[i].size());
      }
    }
  }

  ModeTransform means(double step, Eigen::Index modes) const {
    ModeTransform result = mode_means(places, step, modes);
    const Eigen::Map<const Eigen::ArrayXd> shares(share.data(), result.cosine.rows());
    result.cosine.colwise() *= shares;
    result.sine.colwise() *= shares;
    return result;
  }
};

} // namespace

FieldTarget::FieldTarget(const FieldSkin& skin, FieldLevels levels,
                         const std::vector<FaceModes>& sides, const std::vector<FaceModes>& ends)
    : levels_(std::move(levels)),
      depth_(skin.layers, levels_.levels, even_load / std::max(skin.length, skin.width),
             levels_.cutoffs),
      width_(skin.width) {
  for (const FaceModes& modes : sides) {
    sides_.emplace_back(*skin.column, modes, levels_.levels);
  }
  for (const FaceModes& modes : ends) {
    ends_.emplace_back(*skin.column, modes, levels_.levels);
  }
}

Strains FieldTarget::none(const FieldPlaces& places) const {
  Strains result;
  const std::size_t columns = places.y.size() * levels_.levels.size();
  result.fill(Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(places.x.size()),
                                    static_cast<Eigen::Index>(columns)));
  return result;
}

void FieldTarget::add_waves(const PlaneWaves& waves, const PlaneWaves::Tractions& tractions,
                            const PlaneBox& box, const FaceMotion* motion,
                            const FieldPlaces& places, Strains& sum) const {
  const PlacesInBox x(places.x, box.x, box.length), y(places.y, box.y, box.width);
  if (x.index.empty() || y.index.empty()) {
    return;
  }
  const ModeTransform along_x = x.means(waves.step_x(), waves.modes_x()),
                      along_y = y.means(waves.step_y(), waves.modes_y());
  const auto places_y = static_cast<Eigen::Index>(places.y.size());
  std::vector<Eigen::MatrixXd> of_sides;
  if (motion != nullptr) {
    for (std::size_t p = 0; p < sides_.size(); ++p) {
      of_sides.push_back(sides_[p].at(motion->sides[p], places.y));
    }
  }
  for (std::size_t level = 0; level < levels_.levels.size(); ++level) {
    Strains rows = waves.rows(depth_, level, tractions, along_y);
    for (std::size_t c = 0; c < 6; ++c) {
      const auto first = static_cast<Eigen::Index>(6 * level + c) * places_y;
      for (const Eigen::MatrixXd& own : of_sides) {
        const Eigen::Index felt = std::min(rows[c].rows(), own.cols());
        rows[c].topRows(felt) += own.block(first, 0, places_y, felt).transpose();
      }
      const Eigen::ArrayXXd& wave = sine_along_x[c] ? along_x.sine : along_x.cosine;
      const Eigen::MatrixXd at = wave.leftCols(rows[c].rows()).matrix() * rows[c];
      const auto column = static_cast<Eigen::Index>(level) * places_y;
      for (std::size_t j = 0; j < y.index.size(); ++j) {
        sum[c](x.index, column + y.index[j]) += at.col(static_cast<Eigen::Index>(j));
      }
    }
  }
}

void FieldTarget::add_ends(const FaceMotion& motion, const FieldPlaces& places,
                           Strains& sum) const {
  const auto places_x = static_cast<Eigen::Index>(places.x.size()),
             places_y = static_cast<Eigen::Index>(places.y.size());
  for (std::size_t e = 0; e < ends_.size(); ++e) {
    const FreeEnds::Motion& end = motion.ends[e];
    const ModeTransform all =
        mode_means(places.y, std::numbers::pi / width_, end.modes_y.back() + 1);
    const Eigen::MatrixXd cosine = all.cosine(Eigen::all, end.modes_y),
                          sine = all.sine(Eigen::all, end.modes_y);
    const Eigen::MatrixXd strain = ends_[e].at(end.nodes, places.x);
    for (std::size_t level = 0; level < levels_.levels.size(); ++level) {
      for (std::size_t c = 0; c < 6; ++c) {
        const auto first = static_cast<Eigen::Index>(6 * level + c) * places_x;
        sum[c].middleCols(static_cast<Eigen::Index>(level) * places_y, places_y).noalias() +=
            strain.middleRows(first, places_x) * (sine_along_y[c] ? sine : cosine).transpose();
      }
    }
  }
}

} // namespace ionskin::finite_layers
