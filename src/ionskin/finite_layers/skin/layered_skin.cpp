// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/skin/layered_skin.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ionskin::finite_layers {

namespace {

/// Smaller of two lengths, reduced by up to 8 % where both are similar, so that the result is
/// smooth.
double smaller(double one, double other) {
  const double least = std::max(0.0, std::min(one, other));
  return least / std::pow(1 + std::pow(least / std::max(one, other), 8), 1.0 / 8);
}

} // namespace

LayeredSkin::LayeredSkin(const Skin& skin, ContactGrid grid, const SkinResolution& resolution,
                         int threads, ComplianceForm form)
    : grid_(std::move(grid)), box_(layer_box({skin, resolution, grid_.half}, threads)) {
  if (form == ComplianceForm::products) {
    return;
  }
  alike_ = plane_compliance(box_->short_waves, grid_, own_images(grid_));
  if (!grid_.half) {
    const ModeLine &x = box_->modes.along_x(), &y = box_->modes.along_y();
    const Eigen::ArrayXXd all = Eigen::ArrayXXd::Ones(x.wave_numbers.size(), y.wave_numbers.size());
    alike_rows_ = box_->modes.rows(grid_, 0, ModePart::alike, all);
    add_modes(alike_rows_, x, ModePart::alike, all.col(0), grid_, 0, alike_);
  }
}

std::vector<RowImage> LayeredSkin::images_in_sides(double centre_y) const {
  return box_->sides ? std::vector<RowImage>{}
                     : images_between(grid_, -centre_y, box_->key.width - centre_y,
                                      box_->key.resolution.reach);
}

LongWaves LayeredSkin::long_waves(const std::array<double, 2>& centre) const {
  return {box_, grid_, centre, near_ends(clearance_of_ends(grid_, centre[0]))};
}

// The slider that is nearer to an end decides which modes the ends contribute.
CellFields LayeredSkin::moved_by(const ContactGrid& other,
                                 const std::array<double, 2>& other_centre,
                                 const CellFields& forces,
                                 const std::array<double, 2>& centre) const {
  const NearEnds near = near_ends(
      std::min(clearance_of_ends(grid_, centre[0]), clearance_of_ends(other, other_centre[0])));
  CellFields result;
  for (Eigen::MatrixXd& one : result) {
    one = Eigen::MatrixXd::Zero(grid_.columns(), grid_.rows());
  }
  LongWaves(box_, other, other_centre, near)
      .add_at(LongWaves(box_, grid_, centre, near), forces, result);
  return result;
}

double LayeredSkin::clearance_of_ends(const ContactGrid& grid, double centre_x) const {
  return smaller(centre_x + grid.x.front(), box_->key.length - centre_x - grid.x.back());
}

WavesOfBody LayeredSkin::waves() const {
  return [box = box_](double wave_number) { return box->surface.at(wave_number); };
}

SkinFields LayeredSkin::fields(const std::vector<double>& heights, double column,
                               const ComponentChoice& components,
                               const std::optional<PlacesAcross>& across, int threads) const {
  return {box_->fields, grid_,  heights, column, box_->key.resolution.split(),
          components,   across, threads};
}

LayeredSkin::Across LayeredSkin::across(double centre_y) const {
  Across result;
  result.skin_ = this;
  const ModeLine& along_x = box_->modes.along_x();
  // Mirror images in the sides, and the motion of these, depend on the position across the skin.
  std::vector<Eigen::MatrixXd> rows =
      grid_.half ? box_->modes.rows(grid_, centre_y)
                 : box_->modes.rows(grid_, centre_y, ModePart::mirrored, near_sides(centre_y));
  if (box_->sides) {
    const Eigen::Index count = 3 * grid_.rows(),
                       modes = std::min(box_->sides->modes(), along_x.wave_numbers.size());
    rows.resize(std::max(rows.size(), static_cast<std::size_t>(modes)),
                Eigen::MatrixXd::Zero(count, count));
    box_->sides->add(grid_, centre_y, rows);
  }
  result.alike_ = alike_;
  if (const auto images = images_in_sides(centre_y); !images.empty()) {
    result.alike_ += plane_compliance(box_->short_waves, grid_, images);
  }
  const Eigen::ArrayXd all = Eigen::ArrayXd::Ones(static_cast<Eigen::Index>(rows.size()));
  add_modes(rows, along_x, ModePart::alike, all, grid_, 0, result.alike_);
  if (!grid_.half) {
    for (std::size_t m = 0; m < rows.size(); ++m) {
      rows[m] += alike_rows_[m];
    }
    rows.insert(rows.end(), alike_rows_.begin() + static_cast<std::ptrdiff_t>(rows.size()),
                alike_rows_.end());
  }
  result.rows_ = std::move(rows);
  result.ends_ = box_->ends->rows(grid_, centre_y);
  return result;
}

/// Share of the modes of the skin that mirror images in the sides still have from a slider at some
/// position, [mode along x, mode along y]: waves whose response ends before an image do not count.
/// The tolerance is near rounding, so that the matrix agrees with that of a half grid and with
/// `CellProduct`, which count all waves.
Eigen::ArrayXXd LayeredSkin::near_sides(double centre_y) const {
  constexpr double tolerance = 1e-14, least_share = 1e-15;
  const Eigen::ArrayXd &x = box_->modes.along_x().wave_numbers,
                       &y = box_->modes.along_y().wave_numbers;
  const double clearance =
      smaller(centre_y + grid_.y.front(), box_->key.width - centre_y - grid_.y.back());
  const WaveSplit split(std::max(2 * clearance, box_->key.resolution.reach), tolerance);
  if (split.last_long() >= std::min(x(x.size() - 1), y(y.size() - 1))) {
    return Eigen::ArrayXXd::Ones(x.size(), y.size());
  }
  const auto felt = [&](const Eigen::ArrayXd& waves) {
    const Eigen::ArrayXd shares = waves.unaryExpr([&](double k) { return split.long_share(k); });
    return (shares >= least_share).count();
  };
  Eigen::ArrayXXd share(felt(x), felt(y));
  for (Eigen::Index n = 0; n < share.cols(); ++n) {
    for (Eigen::Index m = 0; m < share.rows(); ++m) {
      share(m, n) = split.long_share(std::hypot(x(m), y(n)));
    }
  }
  return share;
}

// An image is twice as far away as the end that mirrors it: waves whose response ends before that
// distance do not count. Single waves do not decay with the distance from the ends, only their sum
// does. Each share is therefore cut off so late that forces do not jump where it ends.
NearEnds LayeredSkin::near_ends(double clearance) const {
  constexpr double least_share = 1e-6;
  const Eigen::ArrayXd& waves = box_->modes.along_x().wave_numbers;
  const SkinResolution& resolution = box_->key.resolution;
  const double reach = std::max(resolution.reach, 2 * clearance);
  const WaveSplit split(reach, resolution.split_tolerance);
  NearEnds result{Eigen::ArrayXd::Ones(waves.size()), resolution.face_waves / reach};
  if (reach > resolution.reach) { // otherwise the modes include this share already
    const Eigen::ArrayXd share = waves.unaryExpr([&](double k) { return split.long_share(k); });
    result.share = share.head((share >= least_share).count());
  }
  return result;
}

Eigen::MatrixXd LayeredSkin::Across::compliance(double centre_x) const {
  const ContactGrid& grid = skin_->grid_;
  const NearEnds near = skin_->near_ends(skin_->clearance_of_ends(grid, centre_x));
  Eigen::MatrixXd result = alike_;
  add_modes(rows_, skin_->box_->modes.along_x(), ModePart::mirrored, near.share, grid, centre_x,
            result);
  ends_.add(grid, centre_x, near.share, near.last, result);
  return result;
}

} // namespace ionskin::finite_layers
