// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/fields/field_target.hpp"

#include "ionskin/finite_layers/fields/field_faces.hpp"
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

FieldTarget::FieldTarget(const FieldSkin& skin, FieldLevels levels)
    : levels_(std::move(levels)),
      depth_(skin.layers, levels_.levels, even_load / std::max(skin.length, skin.width),
             levels_.cutoffs),
      length_(skin.length), width_(skin.width) {
  for (const FaceModes& modes : skin.faces->sides) {
    sides_.emplace_back(*skin.column, modes, levels_.levels);
  }
  for (const FaceModes& modes : skin.faces->ends) {
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

void FieldTarget::add_waves(const PlaneWaves& waves, const std::vector<WaveLoads>& loads,
                            const std::vector<PlaneBox>& boxes,
                            const std::vector<FieldPlaces>& places, const RowStrains* known,
                            std::vector<Strains>& sums) const {
  std::vector<PlacesInBox> x, y;
  std::vector<WavePlaces> in_box;
  for (std::size_t state = 0; state < loads.size(); ++state) {
    x.emplace_back(places[state].x, boxes[state].x, boxes[state].length);
    y.emplace_back(places[state].y, boxes[state].y, boxes[state].width);
    in_box.push_back({x.back().means(waves.step_x(), waves.modes_x()),
                      y.back().means(waves.step_y(), waves.modes_y())});
  }
  for (std::size_t level = 0; level < levels_.levels.size(); ++level) {
    std::vector<Strains> own(loads.size());
    for (std::size_t state = 0; state < loads.size(); ++state) {
      own[state].fill(Eigen::MatrixXd::Zero(in_box[state].along_x.cosine.rows(),
                                            in_box[state].along_y.cosine.rows()));
    }
    waves.add(depth_, level, loads, in_box, known, own);
    for (std::size_t state = 0; state < loads.size(); ++state) {
      const auto first = static_cast<Eigen::Index>(level * places[state].y.size());
      for (std::size_t c = 0; c < 6; ++c) {
        for (std::size_t j = 0; j < y[state].index.size(); ++j) {
          sums[state][c](x[state].index, first + y[state].index[j]) +=
              own[state][c].col(static_cast<Eigen::Index>(j));
        }
      }
    }
  }
}

RowStrains FieldTarget::row_strains(const PlaneWaves& waves, const PlaneBox& box,
                                    const ModeTransform& rows, const std::vector<Interval>& y,
                                    int threads) const {
  return {waves, depth_, rows,
          PlacesInBox(y, box.y, box.width).means(waves.step_y(), waves.modes_y()), threads};
}

void FieldTarget::add_faces(const std::vector<FaceMotion>& motions,
                            const std::vector<FieldPlaces>& places,
                            std::vector<Strains>& sums) const {
  const std::size_t states = motions.size();
  const auto count_of_levels = static_cast<Eigen::Index>(levels_.levels.size());
  std::vector<const std::vector<Interval>*> x, y;
  for (const FieldPlaces& of_state : places) {
    x.push_back(&of_state.x);
    y.push_back(&of_state.y);
  }
  std::vector<const Eigen::MatrixXd*> nodes(states);
  for (std::size_t side = 0; side < sides_.size(); ++side) {
    for (std::size_t state = 0; state < states; ++state) {
      nodes[state] = &motions[state].sides[side];
    }
    const std::vector<Strains> strains = sides_[side].at(nodes, y);
    for (std::size_t state = 0; state < states; ++state) {
      const Eigen::Index modes = nodes[state]->cols();
      const ModeTransform along = mode_means(*x[state], std::numbers::pi / length_, modes);
      const auto count = static_cast<Eigen::Index>(y[state]->size());
      for (Eigen::Index level = 0; level < count_of_levels; ++level) {
        for (std::size_t c = 0; c < 6; ++c) {
          sums[state][c].middleCols(level * count, count).noalias() +=
              (sine_along_x[c] ? along.sine : along.cosine).matrix() *
              strains[state][c].middleCols(level * modes, modes).transpose();
        }
      }
    }
  }
  for (std::size_t end = 0; end < ends_.size(); ++end) {
    for (std::size_t state = 0; state < states; ++state) {
      nodes[state] = &motions[state].ends[end].nodes;
    }
    const std::vector<Strains> strains = ends_[end].at(nodes, x);
    for (std::size_t state = 0; state < states; ++state) {
      const std::vector<Eigen::Index>& modes = motions[state].ends[end].modes_y;
      const ModeTransform all = mode_means(*y[state], std::numbers::pi / width_, modes.back() + 1);
      const Eigen::MatrixXd cosine = all.cosine(Eigen::all, modes),
                            sine = all.sine(Eigen::all, modes);
      const auto count = static_cast<Eigen::Index>(y[state]->size());
      for (Eigen::Index level = 0; level < count_of_levels; ++level) {
        for (std::size_t c = 0; c < 6; ++c) {
          sums[state][c].middleCols(level * count, count).noalias() +=
              strains[state][c].middleCols(level * cosine.cols(), cosine.cols()) *
              (sine_along_y[c] ? sine : cosine).transpose();
        }
      }
    }
  }
}

} // namespace ionskin::finite_layers
