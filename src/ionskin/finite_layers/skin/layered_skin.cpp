// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/skin/layered_skin.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ionskin::finite_layers {
namespace {

std::size_t core_index(const Skin& skin) {
  const auto core = std::ranges::find(skin.layers, LayerRole::core, &Layer::role);
  return static_cast<std::size_t>(core - skin.layers.begin());
}

/// The smaller of two lengths, or up to 8 % less where they are alike: without a bend between.
double smaller(double one, double other) {
  const double least = std::max(0.0, std::min(one, other));
  return least / std::pow(1 + std::pow(least / std::max(one, other), 8), 1.0 / 8);
}

} // namespace

LayeredSkin::LayeredSkin(const Skin& skin, ContactGrid grid, const SkinResolution& resolution)
    : grid_(std::move(grid)), length_(skin.length), width_(skin.width), core_(core_index(skin)),
      resolution_(resolution),
      surface_(std::make_unique<const SurfaceCompliance>(elastic_layers(skin))),
      column_(surface_->layers(), resolution_.elements, resolution_.degree) {
  const WaveSplit split = resolution_.split();
  modes_ = std::make_unique<const BoxModes>(*surface_, skin.length, skin.width, split);
  if (skin.sides == SideCondition::free) {
    sides_ = std::make_unique<const FreeSides>(column_, skin.length, skin.width, split,
                                               resolution_.face(skin.length));
  }
  ends_ = std::make_unique<const FreeEnds>(column_, skin.length, skin.width, split,
                                           resolution_.face(skin.width), sides_.get());
  short_waves_ = std::make_unique<const PlaneCompliance>(*surface_, split);
  short_compliance_ = plane_compliance(*short_waves_, grid_, own_images(grid_));
}

SkinFields LayeredSkin::fields(const std::vector<double>& heights, double column) const {
  return {FieldSkin{layers(), core_, length_, width_, &column_, sides_.get(), ends_.get()}, grid_,
          heights, column, resolution_.split()};
}

LayeredSkin::Across LayeredSkin::across(double centre_y) const {
  Across result;
  result.skin_ = this;
  result.rows_ = modes_->rows(grid_, centre_y);
  result.alike_ = short_compliance_;
  if (sides_) {
    sides_->add(grid_, centre_y, result.rows_);
  } else if (const auto images =
                 images_between(grid_, -centre_y, width_ - centre_y, resolution_.reach);
             !images.empty()) {
    result.alike_ += plane_compliance(*short_waves_, grid_, images);
  }
  result.ends_ = ends_->rows(grid_, centre_y);
  const Eigen::ArrayXd all = Eigen::ArrayXd::Ones(modes_->along_x().wave_numbers.size());
  add_modes(result.rows_, modes_->along_x(), ModePart::alike, all, grid_, 0, result.alike_);
  return result;
}

// An image lies twice as far away as the end that it is mirrored in: waves that end before it do
// not count. Single waves do not fall with the distance from the ends, only their sum does: each
// share ends so late that forces do not jump where it does.
LayeredSkin::NearEnds LayeredSkin::near_ends(double centre_x) const {
  constexpr double least_share = 1e-6;
  const Eigen::ArrayXd& waves = modes_->along_x().wave_numbers;
  const double clearance = smaller(centre_x + grid_.x.front(), length_ - centre_x - grid_.x.back());
  const double reach = std::max(resolution_.reach, 2 * clearance);
  const WaveSplit split(reach, resolution_.split_tolerance);
  NearEnds result{Eigen::ArrayXd::Ones(waves.size()), resolution_.face_waves / reach};
  if (reach > resolution_.reach) { // else the modes have this share already
    const Eigen::ArrayXd share = waves.unaryExpr([&](double k) { return split.long_share(k); });
    result.share = share.head((share >= least_share).count());
  }
  return result;
}

Eigen::MatrixXd LayeredSkin::Across::compliance(double centre_x) const {
  const ContactGrid& grid = skin_->grid_;
  const NearEnds near = skin_->near_ends(centre_x);
  Eigen::MatrixXd result = alike_;
  add_modes(rows_, skin_->modes_->along_x(), ModePart::mirrored, near.share, grid, centre_x,
            result);
  ends_.add(grid, centre_x, near.share, near.last, result);
  return result;
}

} // namespace ionskin::finite_layers
