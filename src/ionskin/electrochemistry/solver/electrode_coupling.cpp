// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/solver/electrode_coupling.hpp"

#include <Eigen/Dense>

#include <algorithm>

namespace ionskin::electrochemistry {

ElectrodeCoupling::ElectrodeCoupling(const TopElectrodes& electrodes,
                                     const CosineTransform& transform)
    : count_(electrodes.size()), matrix_(count_ * count_) {
  for (const TopConductor& conductor : electrodes.conductors()) {
    std::vector<float> scratch(conductor.share.size());
    modes_.emplace_back(conductor.share.size());
    transform.forward(conductor.share, modes_.back(), scratch);
  }
}

void ElectrodeCoupling::set_admittance(std::span<const double> admittance) {
  std::vector<double> weighted(admittance.size());
  for (std::size_t e = 0; e < count_; ++e) {
    for (std::size_t m = 0; m < weighted.size(); ++m) {
      weighted[m] = admittance[m] * static_cast<double>(modes_[e][m]);
    }
    for (std::size_t f = 0; f <= e; ++f) {
      const float* other = modes_[f].data();
      double sum = 0.0;
#pragma omp simd reduction(+ : sum)
      for (std::size_t m = 0; m < weighted.size(); ++m) {
        sum += weighted[m] * static_cast<double>(other[m]);
      }
      matrix_[e * count_ + f] = matrix_[f * count_ + e] = sum;
    }
  }
  conductance_.clear();
}

void ElectrodeCoupling::invert(const ElectrodeStage& stage) {
  if (conductance_ == stage.conductance) {
    return;
  }
  const auto count = static_cast<Eigen::Index>(count_);
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Matrix system = Eigen::Map<const Matrix>(matrix_.data(), count, count);
  Matrix sources = Matrix::Identity(count, count);
  for (Eigen::Index e = 0; e < count; ++e) {
    if (stage.holds(static_cast<std::size_t>(e))) {
      system.row(e).setZero();
      system.col(e).setZero();
      system(e, e) = 1.0;
      sources(e, e) = 0.0;
    } else {
      system(e, e) += stage.conductance[static_cast<std::size_t>(e)];
    }
  }
  const Matrix inverse = system.ldlt().solve(sources);
  inverse_.assign(inverse.data(), inverse.data() + inverse.size());
  conductance_ = stage.conductance;
}

std::vector<double> ElectrodeCoupling::potentials(const ElectrodeStage& stage,
                                                  std::span<const float> charge) {
  invert(stage);
  std::vector<double> charges(count_, 0.0), result(count_, 0.0);
  for (std::size_t e = 0; e < count_; ++e) {
    const float* modes = modes_[e].data();
    double sum = 0.0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t m = 0; m < charge.size(); ++m) {
      sum += static_cast<double>(modes[m]) * static_cast<double>(charge[m]);
    }
    charges[e] = sum;
  }
  for (std::size_t e = 0; e < count_; ++e) {
    for (std::size_t f = 0; f < count_; ++f) {
      result[e] += inverse_[e * count_ + f] * charges[f];
    }
  }
  return result;
}

void ElectrodeCoupling::spread(std::span<const double> potentials, std::span<float> modes) const {
  std::ranges::fill(modes, 0.0F);
  for (std::size_t e = 0; e < count_; ++e) {
    const auto potential = static_cast<float>(potentials[e]);
    for (std::size_t m = 0; m < modes.size(); ++m) {
      modes[m] += potential * modes_[e][m];
    }
  }
}

} // namespace ionskin::electrochemistry
