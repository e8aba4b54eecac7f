// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/solver/electrode_coupling.hpp"

#include <Eigen/Dense>

namespace ionskin::electrochemistry {

ElectrodeCoupling::ElectrodeCoupling(const WallElectrodes& electrodes,
                                     const CosineTransform& transform)
    : count_(electrodes.size()), matrix_(count_ * count_) {
  for (const WallConductor& conductor : electrodes.conductors()) {
    std::vector<float> scratch(conductor.share.size());
    wall_.push_back(conductor.wall);
    modes_.emplace_back(conductor.share.size());
    transform.forward(conductor.share, modes_.back(), scratch);
  }
}

void ElectrodeCoupling::set_admittance(
    const std::array<std::array<std::vector<double>, 2>, 2>& admittance) {
  std::vector<double> weighted(modes_.front().size());
  for (std::size_t e = 0; e < count_; ++e) {
    for (const std::size_t wall : {bottom_wall, top_wall}) {
      const std::vector<double>& of_mode = admittance[wall_[e]][wall];
      if (of_mode.empty()) {
        continue;
      }
      for (std::size_t m = 0; m < weighted.size(); ++m) {
        weighted[m] = of_mode[m] * static_cast<double>(modes_[e][m]);
      }
      for (std::size_t f = 0; f < count_; ++f) {
        if (wall_[f] != wall) {
          continue;
        }
        const float* other = modes_[f].data();
        double sum = 0.0;
#pragma omp simd reduction(+ : sum)
        for (std::size_t m = 0; m < weighted.size(); ++m) {
          sum += weighted[m] * static_cast<double>(other[m]);
        }
        matrix_[e * count_ + f] = sum;
      }
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
  const Matrix inverse = system.partialPivLu().solve(sources);
  inverse_.assign(inverse.data(), inverse.data() + inverse.size());
  conductance_ = stage.conductance;
}

std::vector<double> ElectrodeCoupling::potentials(const ElectrodeStage& stage,
                                                  const std::array<std::vector<float>, 2>& charge) {
  invert(stage);
  std::vector<double> charges(count_, 0.0), result(count_, 0.0);
  for (std::size_t e = 0; e < count_; ++e) {
    const std::vector<float>& of_mode = charge[wall_[e]];
    const float* modes = modes_[e].data();
    double sum = 0.0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t m = 0; m < of_mode.size(); ++m) {
      sum += static_cast<double>(modes[m]) * static_cast<double>(of_mode[m]);
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

std::array<std::vector<float>, 2>
ElectrodeCoupling::spread(std::span<const double> potentials) const {
  std::array<std::vector<float>, 2> modes;
  for (std::size_t e = 0; e < count_; ++e) {
    std::vector<float>& of_wall = modes[wall_[e]];
    of_wall.resize(modes_[e].size(), 0.0F);
    const auto potential = static_cast<float>(potentials[e]);
    for (std::size_t m = 0; m < of_wall.size(); ++m) {
      of_wall[m] += potential * modes_[e][m];
    }
  }
  return modes;
}

} // namespace ionskin::electrochemistry
