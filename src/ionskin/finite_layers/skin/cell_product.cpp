// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/skin/cell_product.hpp"

#include <cstddef>
#include <utility>

namespace ionskin::finite_layers {
namespace {

using EveryThird = Eigen::Stride<Eigen::Dynamic, 3>;

} // namespace

CellProduct::CellProduct(std::shared_ptr<const CellConvolution> short_waves, LongWaves long_waves,
                         std::shared_ptr<const InverseWaves> inverse)
    : short_waves_(std::move(short_waves)), long_waves_(std::move(long_waves)),
      inverse_(std::move(inverse)), own_(long_waves_.own()) {
  for (std::size_t c = 0; c < 3; ++c) {
    own_[c] += short_waves_->own()[c];
  }
}

Eigen::MatrixXd CellProduct::field(const std::vector<double>& values, std::size_t component) const {
  const Eigen::Index columns = short_waves_->columns(), rows = short_waves_->rows();
  return Eigen::Map<const Eigen::MatrixXd, 0, EveryThird>(values.data() + component, columns, rows,
                                                          EveryThird(3 * columns, 3));
}

void CellProduct::set(const Eigen::MatrixXd& field, std::size_t component,
                      std::vector<double>& values) {
  Eigen::Map<Eigen::MatrixXd, 0, EveryThird>(values.data() + component, field.rows(), field.cols(),
                                             EveryThird(3 * field.rows(), 3)) = field;
}

std::vector<double> CellProduct::times(const std::vector<double>& forces) const {
  CellFields of_forces, moved;
  for (std::size_t c = 0; c < 3; ++c) {
    of_forces[c] = field(forces, c);
    moved[c] = Eigen::MatrixXd::Zero(of_forces[c].rows(), of_forces[c].cols());
  }
  short_waves_->add(of_forces, moved);
  long_waves_.add(of_forces, moved);
  std::vector<double> result(forces.size());
  for (std::size_t c = 0; c < 3; ++c) {
    set(moved[c], c, result);
  }
  return result;
}

void CellProduct::invert_normal(std::vector<double>& values) const {
  set(inverse_->normal(field(values, 0)), 0, values);
}

void CellProduct::invert_tangential(std::vector<double>& values) const {
  const auto forces = inverse_->tangential({field(values, 1), field(values, 2)});
  set(forces[0], 1, values);
  set(forces[1], 2, values);
}

} // namespace ionskin::finite_layers
