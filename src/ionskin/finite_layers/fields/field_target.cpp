// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/fields/field_target.hpp"

#include "ionskin/finite_layers/fields/mode_means.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace ionskin::finite_layers {
namespace {

/// Wave number times the size of the skin, below which a traction acts like a uniform load [1].
constexpr double even_load = 1e-4;

/// Parts of places that lie in a box, from the corner of the box [m], with the indices of the
/// places and the share of each place that lies in the box.
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
                         const ComponentChoice& components)
    : levels_(std::move(levels)), components_(components),
      depth_(skin.layers, levels_.levels, even_load / std::max(skin.length, skin.width),
             levels_.cutoffs),
      faces_(skin, levels_.levels, components) {}

ByKind FieldTarget::none(const FieldPlaces& places) const {
  ByKind result;
  const auto columns = static_cast<Eigen::Index>(places.y.size() * levels_.levels.size());
  for (const std::size_t kind : {0, 1}) {
    result[kind].setZero(static_cast<Eigen::Index>(places.x.size()),
                         columns * components_.count(kind));
  }
  return result;
}

Eigen::MatrixXd FieldTarget::component(const ByKind& sums, const FieldPlaces& places,
                                       std::size_t component, std::size_t level) const {
  const std::size_t kind = sine_along_x[component] ? 1 : 0;
  const std::vector<std::size_t>& own = components_.of_kind(kind);
  const auto found = std::ranges::find(own, component);
  if (found == own.end()) {
    return {};
  }
  const auto of_y = static_cast<Eigen::Index>(places.y.size());
  return sums[kind].middleCols(
      of_y * (found - own.begin() + components_.count(kind) * static_cast<Eigen::Index>(level)),
      of_y);
}

void FieldTarget::add_waves(const PlaneWaves& waves, const std::vector<WaveLoads>& loads,
                            const std::vector<PlaneBox>& boxes,
                            const std::vector<FieldPlaces>& places, const RowStrains* known,
                            std::vector<ByKind>& sums) const {
  std::vector<PlacesInBox> x, y;
  std::vector<WavePlaces> in_box;
  for (std::size_t state = 0; state < loads.size(); ++state) {
    x.emplace_back(places[state].x, boxes[state].x, boxes[state].length);
    y.emplace_back(places[state].y, boxes[state].y, boxes[state].width);
    in_box.push_back({x.back().means(waves.step_x(), waves.modes_x()),
                      y.back().means(waves.step_y(), waves.modes_y())});
  }
  std::vector<ByKind> own(loads.size());
  for (std::size_t level = 0; level < levels_.levels.size(); ++level) {
    for (std::size_t state = 0; state < loads.size(); ++state) {
      for (const std::size_t kind : {0, 1}) {
        own[state][kind].setZero(in_box[state].along_x.cosine.rows(),
                                 in_box[state].along_y.cosine.rows() * components_.count(kind));
      }
    }
    if (known != nullptr) {
      waves.add(*known, depth_, level, loads, in_box, own);
    } else {
      waves.add(depth_, level, components_, loads, in_box, own);
    }
    for (std::size_t state = 0; state < loads.size(); ++state) {
      const auto of_y = static_cast<Eigen::Index>(places[state].y.size());
      for (const std::size_t kind : {0, 1}) {
        Eigen::Index from = 0;
        for (Eigen::Index i = 0; i < components_.count(kind); ++i) {
          const Eigen::Index first =
              of_y * (i + components_.count(kind) * static_cast<Eigen::Index>(level));
          for (const Eigen::Index place : y[state].index) {
            sums[state][kind](x[state].index, first + place) += own[state][kind].col(from++);
          }
        }
      }
    }
  }
}

RowStrains FieldTarget::row_strains(const PlaneWaves& waves, const PlaneBox& box,
                                    const ModeTransform& rows, const std::vector<Interval>& y,
                                    int threads) const {
  return {waves,
          depth_,
          components_,
          rows,
          PlacesInBox(y, box.y, box.width).means(waves.step_y(), waves.modes_y()),
          threads};
}

} // namespace ionskin::finite_layers
