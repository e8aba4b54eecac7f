// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/solver/contact_coupling.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <numbers>

namespace ionskin::electrochemistry {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Values of all orthonormal cosines in a cell, even modes first up to `first_odd`; in ascending
/// order if that is `cells`.
std::vector<double> cosines(std::size_t cell, std::size_t cells, std::size_t first_odd) {
  std::vector<double> values;
  const auto count = static_cast<double>(cells);
  for (std::size_t i = 0; i < cells; ++i) {
    const std::size_t mode = first_odd == cells ? i
                             : i < first_odd    ? 2 * i
                                                : 2 * (i - first_odd) + 1;
    const double angle =
        std::numbers::pi * static_cast<double>(mode) * (static_cast<double>(cell) + 0.5) / count;
    values.push_back(std::sqrt((mode == 0 ? 1.0 : 2.0) / count) * std::cos(angle));
  }
  return values;
}

} // namespace

ContactCoupling::ContactCoupling(const ScaledGrid& grid, const SheetElectrodes& electrodes)
    : grid_(grid), electrodes_(electrodes), rows_(electrodes.contact().columns_y.size()),
      ends_(electrodes.contact().columns_x.size()) {
  // `CosineTransform` orders the even modes of x before the odd ones.
  for (const std::size_t x : electrodes.contact().columns_x) {
    modes_x_.push_back(cosines(x, grid.columns_x, (grid.columns_x + 1) / 2));
  }
  for (const std::size_t y : electrodes.contact().columns_y) {
    modes_y_.push_back(cosines(y, grid.columns_y, grid.columns_y));
  }
}

double ContactCoupling::hold(double step) const {
  return step * electrodes_.total_contact(bottom_wall) / static_cast<double>(grid_.columns());
}

void ContactCoupling::invert(const std::array<std::array<std::span<const float>, 2>, 2>& answers,
                             double step) {
  const std::size_t touched = this->touched(), holding = 2 * touched;
  const auto size = static_cast<Eigen::Index>(holding + 1);
  Matrix answer = Matrix::Zero(size, size);
  const auto at = [&](std::size_t i, std::size_t j) -> double& {
    return answer(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  };
  for (std::size_t a = 0; a < 2; ++a) {
    for (std::size_t b = 0; b < 2; ++b) {
      for (std::size_t p = 0; p < ends_; ++p) {
        for (std::size_t q = 0; q < ends_; ++q) {
          for (std::size_t m = 0; m < grid_.columns_y; ++m) {
            double along = 0.0;
            const float* modes = answers[a][b].data() + m * grid_.columns_x;
            for (std::size_t n = 0; n < grid_.columns_x; ++n) {
              along += modes_x_[p][n] * modes_x_[q][n] * static_cast<double>(modes[n]);
            }
            for (std::size_t i = 0; i < rows_; ++i) {
              for (std::size_t j = 0; j < rows_; ++j) {
                at(a * touched + i * ends_ + p, b * touched + j * ends_ + q) +=
                    modes_y_[i][m] * modes_y_[j][m] * along;
              }
            }
          }
        }
      }
    }
    for (std::size_t i = 0; i < rows_; ++i) {
      for (std::size_t p = 0; p < ends_; ++p) {
        const double value = modes_x_[p][0] * modes_y_[i][0];
        const std::size_t here = a * touched + i * ends_ + p;
        at(here, holding) = value * static_cast<double>(answers[a][bottom_wall][0]);
        at(holding, here) = value * static_cast<double>(answers[bottom_wall][a][0]);
      }
    }
  }
  at(holding, holding) = static_cast<double>(answers[bottom_wall][bottom_wall][0]);

  Matrix contact = Matrix::Zero(size, size);
  for (std::size_t wall = 0; wall < 2; ++wall) {
    const std::vector<double> conductance = electrodes_.contact_conductance(wall);
    const auto first = static_cast<Eigen::Index>(wall * touched);
    for (std::size_t i = 0; i < touched; ++i) {
      const Eigen::Index row = first + static_cast<Eigen::Index>(i);
      contact(row, row) = step * conductance[i];
    }
    if (wall == top_wall && electrodes_.admittance()) {
      const Eigen::Map<const Eigen::VectorXd> each(conductance.data(),
                                                   static_cast<Eigen::Index>(touched));
      const double all =
          step * electrodes_.total_contact(wall) +
          static_cast<double>(grid_.columns()) * electrodes_.circuit_conductance(step);
      contact.block(first, first, each.size(), each.size()) -=
          (step * step / all) * each * each.transpose();
    }
  }
  contact(size - 1, size - 1) = -hold(step);
  const Matrix system = Matrix::Identity(size, size) + answer * contact;
  const Matrix result = -contact * system.partialPivLu().inverse();
  charge_by_potential_.assign(result.data(), result.data() + result.size());
}

void ContactCoupling::gather(std::span<const float> modes, double* potentials) const {
  for (std::size_t p = 0; p < ends_; ++p) {
    for (std::size_t m = 0; m < grid_.columns_y; ++m) {
      double along = 0.0;
      for (std::size_t n = 0; n < grid_.columns_x; ++n) {
        along += modes_x_[p][n] * static_cast<double>(modes[m * grid_.columns_x + n]);
      }
      for (std::size_t i = 0; i < rows_; ++i) {
        potentials[i * ends_ + p] += modes_y_[i][m] * along;
      }
    }
  }
}

void ContactCoupling::spread(const double* charges, std::span<float> modes) const {
  for (std::size_t p = 0; p < ends_; ++p) {
    for (std::size_t m = 0; m < grid_.columns_y; ++m) {
      double across = 0.0;
      for (std::size_t i = 0; i < rows_; ++i) {
        across += modes_y_[i][m] * charges[i * ends_ + p];
      }
      for (std::size_t n = 0; n < grid_.columns_x; ++n) {
        modes[m * grid_.columns_x + n] += static_cast<float>(modes_x_[p][n] * across);
      }
    }
  }
}

std::array<std::vector<float>, 2>
ContactCoupling::charges(const std::array<std::span<const float>, 2>& potentials) const {
  const std::size_t touched = this->touched(), size = 2 * touched + 1;
  std::vector<double> without(size, 0.0), brought(size, 0.0);
  for (std::size_t wall = 0; wall < 2; ++wall) {
    gather(potentials[wall], without.data() + wall * touched);
  }
  without.back() = static_cast<double>(potentials[bottom_wall][0]);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      brought[i] += charge_by_potential_[i * size + j] * without[j];
    }
  }
  std::array<std::vector<float>, 2> modes;
  for (std::size_t wall = 0; wall < 2; ++wall) {
    modes[wall].assign(grid_.columns(), 0.0F);
    spread(brought.data() + wall * touched, modes[wall]);
  }
  modes[bottom_wall][0] += static_cast<float>(brought.back());
  return modes;
}

} // namespace ionskin::electrochemistry
