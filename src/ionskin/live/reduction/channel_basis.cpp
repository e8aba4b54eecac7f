// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/reduction/channel_basis.hpp"

#include "ionskin/base/system/interrupt.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

namespace ionskin::live {
namespace {

using Matrix = Eigen::MatrixXd;
using Eigen::Index;

/// Norm of the part of the samples that the modes may leave out, over the norm of the samples [1].
constexpr double negligible_modes = 3e-4;
constexpr std::size_t most_modes = 160;
/// Weight of the integral over the core relative to the field, in the norm of the measure [1].
constexpr double integral_weight = 10;
/// Share of the samples that the fit does not use, for measuring its error [1].
constexpr double unseen_share = 0.2;
constexpr std::size_t most_candidates = 6000;
/// Numbers of points of a basis, mirror images included: at first, added at a time, and at most.
constexpr std::size_t fewest_points = 120, more_points = 80, most_points = 600;
/// Error in unseen samples, over their norm, at which no more points are added [1].
constexpr double good = 5e-3;
/// Ridge of the correction in `fit_at_place`, over the squared norm of the values at a point [1].
/// It may be large, since the fit at a position differs smoothly from the fit at the middle.
constexpr double departure = 1e-2;
/// Ridge of the other fits, over the squared norm of the values at a point, or of a mode [1].
constexpr double ridge = 1e-6;

/// Components of one parity (`Reflections`) of the samples and their mirror images.
struct Parity {
  Matrix amplitude; ///< amplitudes of the modes in the samples [mode][sample]
  Matrix combine;   ///< weights of the samples' fields that make each mode [fitted sample][mode]
  Eigen::VectorXd energy; ///< sum over the fitted samples of the squared amplitude of each mode
  Eigen::MatrixXf values; ///< values of the channel at the candidate points [candidate][sample]
};

/// Candidate points, one of each set of mirror images: those with the largest weighted values over
/// the samples, in descending order.
std::vector<std::size_t> candidates_of(const ChannelSamples& samples, const ChannelMeasure& measure,
                                       const Reflections& reflections) {
  const Eigen::VectorXf strength = samples.at_points.rowwise().norm();
  std::vector<std::size_t> result;
  std::vector<double> weight(measure.point_weight.size());
  for (std::size_t i = 0; i < weight.size(); ++i) {
    bool first = measure.point_weight[i] > 0;
    for (std::size_t g = 0; g < reflections.count(); ++g) {
      const std::size_t image = reflections.image(g, i, samples.points);
      first = first && i <= image;
      weight[i] += std::pow(measure.point_weight[image] *
                                static_cast<double>(strength[static_cast<Index>(image)]),
                            2);
    }
    if (first) {
      result.push_back(i);
    }
  }
  std::ranges::stable_sort(result, std::ranges::greater{},
                           [&](std::size_t i) { return weight[i]; });
  result.resize(std::min(result.size(), most_candidates));
  return result;
}

/// Orders candidate points by pivoted Gram-Schmidt orthogonalisation of their values over the
/// samples: next comes the candidate of which the largest part is not yet spanned by the earlier
/// ones.
/// @param weights weight of each candidate
/// @param count largest number of candidates to return
/// @returns indices of candidates
std::vector<std::size_t> best_first(const std::vector<Parity>& parities,
                                    const Eigen::VectorXf& weights, std::size_t count) {
  std::vector<Eigen::MatrixXf> left;
  for (const Parity& parity : parities) {
    left.emplace_back((weights.asDiagonal() * parity.values).transpose()); // [sample][candidate]
  }
  std::vector<std::size_t> order;
  while (order.size() < std::min(count, static_cast<std::size_t>(weights.size()))) {
    base::check_interrupt();
    Eigen::RowVectorXf strength = Eigen::RowVectorXf::Zero(weights.size());
    for (const Eigen::MatrixXf& own : left) {
      strength += own.colwise().squaredNorm();
    }
    for (const std::size_t taken : order) {
      strength[static_cast<Index>(taken)] = -1;
    }
    Index best = 0;
    strength.maxCoeff(&best);
    order.push_back(static_cast<std::size_t>(best));
    for (Eigen::MatrixXf& own : left) {
      const Eigen::VectorXf direction = own.col(best).normalized();
      if (direction.allFinite()) {
        own -= direction * (direction.transpose() * own).eval();
      }
    }
  }
  return order;
}

/// Ridge regression of the mode amplitudes of a parity on the channel's values at points.
/// @param order indices of candidates
/// @param count number of points to use, from the first of `order`
/// @param samples number of samples to fit, from the first
/// @returns weights [mode][point]
Matrix regression(const Parity& parity, const std::vector<std::size_t>& order, std::size_t count,
                  Index samples) {
  Matrix values(static_cast<Index>(count), samples);
  for (std::size_t i = 0; i < count; ++i) {
    values.row(static_cast<Index>(i)) =
        parity.values.row(static_cast<Index>(order[i])).head(samples).cast<double>();
  }
  const Eigen::VectorXd scale = values.rowwise().norm().cwiseMax(1e-30).cwiseInverse();
  values = scale.asDiagonal() * values;
  Matrix gram = values * values.transpose();
  gram.diagonal().array() += ridge;
  return gram.ldlt().solve(values * parity.amplitude.leftCols(samples).transpose()).transpose() *
         scale.asDiagonal();
}

/// Error of the regressions of all parities in the samples after the first `fitted`, over the norm
/// of their amplitudes [1].
double unseen_error(const std::vector<Parity>& parities, const std::vector<std::size_t>& order,
                    std::size_t count, Index fitted) {
  double error = 0, norm = 0;
  for (const Parity& parity : parities) {
    const Matrix weights = regression(parity, order, count, fitted);
    const Index unseen = parity.amplitude.cols() - fitted;
    Matrix values(static_cast<Index>(count), unseen);
    for (std::size_t i = 0; i < count; ++i) {
      values.row(static_cast<Index>(i)) =
          parity.values.row(static_cast<Index>(order[i])).tail(unseen).cast<double>();
    }
    const Matrix expected = parity.amplitude.rightCols(unseen);
    error += (weights * values - expected).squaredNorm();
    norm += expected.squaredNorm();
  }
  return std::sqrt(error / norm);
}

} // namespace

Eigen::MatrixXf of_parity(const Eigen::MatrixXf& values, const std::array<std::size_t, 3>& size,
                          const Reflections& reflections, std::size_t parity) {
  const double share = 1 / std::sqrt(static_cast<double>(reflections.count()));
  Eigen::MatrixXf result(values.rows(), values.cols());
  Eigen::RowVectorXd sum(values.cols()); // double precision: the order of the images has no effect
  for (Index i = 0; i < values.rows(); ++i) {
    sum.setZero();
    for (std::size_t g = 0; g < reflections.count(); ++g) {
      const auto from = static_cast<Index>(reflections.image(g, static_cast<std::size_t>(i), size));
      sum += reflections.sign(parity, g) * values.row(from).cast<double>();
    }
    result.row(i) = (share * sum).cast<float>();
  }
  return result;
}

Eigen::MatrixXf measured(const Eigen::MatrixXf& fields, const ChannelMeasure& measure) {
  const auto columns = static_cast<Index>(measure.cell_area.size()), rows = measure.levels.rows(),
             levels = measure.levels.cols();
  const Eigen::VectorXf area =
      Eigen::Map<const Eigen::VectorXd>(measure.cell_area.data(), columns).cast<float>();
  const float whole = area.sum(), weight = static_cast<float>(integral_weight);
  Eigen::MatrixXf result = Eigen::MatrixXf::Zero(rows * (columns + 1), fields.cols());
  for (Index row = 0; row < rows; ++row) {
    for (Index level = 0; level < levels; ++level) {
      const auto part = static_cast<float>(measure.levels(row, level));
      result.middleRows(row * columns, columns) +=
          part * fields.middleRows(level * columns, columns);
    }
    auto own = result.middleRows(row * columns, columns);
    result.row(rows * columns + row) = weight / std::sqrt(whole) * (area.transpose() * own);
    own.array().colwise() *= area.array().sqrt();
  }
  return result;
}

ChannelBasis channel_basis(const ChannelSamples& samples, const ChannelMeasure& measure,
                           const Reflections& reflections) {
  const Index count = samples.fields.cols(),
              fitted = std::max<Index>(
                  1, count - static_cast<Index>(unseen_share * static_cast<double>(count)));
  const std::vector<std::size_t> candidates = candidates_of(samples, measure, reflections);
  std::vector<Parity> parities(reflections.count());
  std::vector<std::pair<double, std::array<std::size_t, 2>>> energies; // of {parity, mode}
  double whole = 0;
  for (std::size_t p = 0; p < parities.size(); ++p) {
    base::check_interrupt();
    Parity& own = parities[p];
    const Eigen::MatrixXf fields =
        measured(of_parity(samples.fields, samples.cells, reflections, p), measure);
    const Matrix gram = (fields.transpose() * fields).cast<double>();
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(gram.topLeftCorner(fitted, fitted));
    own.energy = eigen.eigenvalues().cwiseMax(0).reverse();
    const Eigen::VectorXd scale =
        own.energy.cwiseMax(1e-30 * own.energy.maxCoeff() + 1e-300).cwiseSqrt().cwiseInverse();
    own.combine = eigen.eigenvectors().rowwise().reverse() * scale.asDiagonal();
    own.amplitude = own.combine.transpose() * gram.topRows(fitted);
    whole += own.energy.sum();
    for (Index k = 0; k < fitted; ++k) {
      energies.push_back({own.energy[k], {p, static_cast<std::size_t>(k)}});
    }
    const Eigen::MatrixXf values = of_parity(samples.at_points, samples.points, reflections, p);
    own.values.resize(static_cast<Index>(candidates.size()), count);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      own.values.row(static_cast<Index>(i)) = values.row(static_cast<Index>(candidates[i]));
    }
  }
  std::ranges::stable_sort(energies, std::ranges::greater{},
                           [](const auto& mode) { return mode.first; });
  std::vector<Index> modes(parities.size(), 0); // number of modes taken from each parity
  double left = whole;
  for (const auto& [energy, at] : energies) {
    if (left <= std::pow(negligible_modes, 2) * whole ||
        static_cast<std::size_t>(std::accumulate(modes.begin(), modes.end(), Index{0})) ==
            most_modes) {
      break;
    }
    left -= energy;
    ++modes[at[0]];
  }
  for (std::size_t p = 0; p < parities.size(); ++p) {
    parities[p].amplitude = parities[p].amplitude.topRows(modes[p]).eval();
    parities[p].combine = parities[p].combine.leftCols(modes[p]).eval();
  }

  Eigen::VectorXf weights(static_cast<Index>(candidates.size()));
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    weights[static_cast<Index>(i)] = static_cast<float>(measure.point_weight[candidates[i]]);
  }
  const std::size_t orbit = reflections.count();
  const std::vector<std::size_t> order = best_first(parities, weights, most_points / orbit);
  ChannelBasis basis;
  std::size_t taken = std::min(fewest_points / orbit, order.size());
  while (basis.unseen = unseen_error(parities, order, taken, fitted),
         basis.unseen > good && taken < order.size()) {
    taken = std::min(taken + more_points / orbit, order.size());
  }

  const auto total = std::accumulate(modes.begin(), modes.end(), Index{0});
  basis.fit = Matrix::Zero(total, static_cast<Index>(taken * orbit));
  basis.field = Matrix::Zero(samples.fields.rows(), total);
  for (std::size_t i = 0; i < taken; ++i) {
    for (std::size_t g = 0; g < orbit; ++g) {
      basis.points.push_back(reflections.image(g, candidates[order[i]], samples.points));
    }
  }
  Index first = 0;
  for (std::size_t p = 0; p < parities.size(); ++p) {
    const Matrix own = regression(parities[p], order, taken, count);
    for (std::size_t i = 0; i < taken; ++i) {
      for (std::size_t g = 0; g < orbit; ++g) {
        basis.fit.col(static_cast<Index>(i * orbit + g)).segment(first, modes[p]) =
            reflections.sign(p, g) / static_cast<double>(orbit) * own.col(static_cast<Index>(i));
      }
    }
    basis.field.middleCols(first, modes[p]) =
        of_parity(samples.fields, samples.cells, reflections, p).leftCols(fitted).cast<double>() *
        parities[p].combine;
    first += modes[p];
    basis.parity.insert(basis.parity.end(), static_cast<std::size_t>(modes[p]), p);
  }
  return basis;
}

Matrix fit_at_place(const ChannelBasis& basis, const ChannelSamples& samples,
                    const ChannelMeasure& measure) {
  const Matrix modes = measured(basis.field.cast<float>(), measure).cast<double>(),
               fields = measured(samples.fields, measure).cast<double>();
  Matrix gram = modes.transpose() * modes;
  gram.diagonal().array() += ridge * gram.diagonal().mean();
  const Matrix amplitude = gram.ldlt().solve(modes.transpose() * fields);
  Matrix values(static_cast<Index>(basis.points.size()), samples.at_points.cols());
  for (std::size_t i = 0; i < basis.points.size(); ++i) {
    values.row(static_cast<Index>(i)) =
        samples.at_points.row(static_cast<Index>(basis.points[i])).cast<double>();
  }
  const Matrix left = amplitude - basis.fit * values;
  const Eigen::VectorXd scale = values.rowwise().norm().cwiseMax(1e-30).cwiseInverse();
  values = scale.asDiagonal() * values;
  Matrix square = values * values.transpose();
  square.diagonal().array() += departure;
  return basis.fit +
         square.ldlt().solve(values * left.transpose()).transpose() * scale.asDiagonal();
}

} // namespace ionskin::live
