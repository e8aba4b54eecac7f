// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/training/charge_spread_fit.hpp"

#include "ionskin/electrochemistry/coupling/driving_channel.hpp"
#include "ionskin/electrochemistry/equations/steric_excess.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/history/strain_projection.hpp"
#include "ionskin/live/charge_spread.hpp"
#include "ionskin/live/low_pass.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

namespace ionskin::live {
namespace {

using Matrix = Eigen::MatrixXd;

/// Largest ratio of the fit's error with spreading charge to the error without it, for using it
/// [1].
constexpr double worthwhile_spread = 0.9;
/// Rms error of the fit without spreading charge, over the largest charge, up to which the
/// computing time of the waves is not worthwhile [1].
constexpr double needs_spread = 1e-2;
/// Contribution of the waves that are left out, over the charges [1].
constexpr double negligible_waves = 1e-3;
constexpr std::size_t most_kept_waves = 400;

/// Values of all waves (`column_wave`) in all columns along one direction [wave][column] [1].
Matrix column_waves(std::size_t columns) {
  Matrix waves(columns, columns);
  for (std::size_t wave = 0; wave < columns; ++wave) {
    for (std::size_t i = 0; i < columns; ++i) {
      waves(static_cast<Eigen::Index>(wave), static_cast<Eigen::Index>(i)) =
          column_wave(columns, wave, i);
    }
  }
  return waves;
}

/// Speed D/lambda in the relaxation rates of docs/model.md (34), for small changes of the
/// concentration, which ions of finite size (15) increase [m/s].
double layer_speed(const Case& input) {
  const auto scales =
      electrochemistry::derive_scales(input.electrochemistry, input.skin.core_thickness());
  const auto excess = electrochemistry::steric_excess(input.electrochemistry);
  return input.electrochemistry.diffusivity / scales.debye_length /
         std::sqrt(1 - (excess ? excess->filling : 0));
}

/// Computes the states of the waves of spreading charge along a full run, in the order of time.
class Waves {
public:
  Waves(const FullRun& run, const SpreadMap& map)
      : run_(run), x_(column_waves(map.columns_x)), y_(column_waves(map.columns_y)),
        rate_(Matrix::Zero(y_.rows(), x_.rows())), taken_(rate_),
        projection_(
            run.history, electrochemistry::driving_channel(run.input.coupling.law, run.history),
            run.ions.grid.x_edges, run.ions.grid.y_edges,
            history::linear_interpolation(run.history.grid.z_nodes, run.history.grid.z_nodes)),
        levels_(run.history.grid.z_nodes.size()) {
    for (std::size_t i = 0; i < map.rates.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(map.wave_y[i]),
                 column = static_cast<Eigen::Index>(map.wave_x[i]);
      rate_(row, column) = map.rates[i];
      taken_(row, column) = 1;
    }
    for (const Taxel& taxel : run.input.readout.taxels) {
      const auto in_x = column_shares(map.columns_x, run.input.skin.length, taxel.lower[0],
                                      taxel.upper[0]),
                 in_y = column_shares(map.columns_y, run.input.skin.width, taxel.lower[1],
                                      taxel.upper[1]);
      taxel_x_.emplace_back(x_ * Eigen::Map<const Eigen::VectorXd>(in_x.data(), x_.cols()));
      taxel_y_.emplace_back(y_ * Eigen::Map<const Eigen::VectorXd>(in_y.data(), y_.cols()));
    }
  }

  /// Steps the waves through the rows of the run.
  /// @param combine weighted sums of the z levels that drive the waves [combination][level]
  /// @param take called with the index of each row and the states of the waves, driven by each
  /// combination [combination][wave of y][wave of x] [m2 times unit of the weights]
  template <class Take> void each_row(const Matrix& combine, const Take& take) {
    const double area =
        run_.input.skin.length * run_.input.skin.width / static_cast<double>(x_.rows() * y_.rows());
    std::vector<double> field;
    std::vector<Matrix> relaxed(static_cast<std::size_t>(combine.rows()),
                                Matrix::Zero(y_.rows(), x_.rows())),
        before = relaxed;
    const std::vector<double>& time = run_.ions.time;
    using Columns =
        Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;
    for (std::size_t row = 0; row < time.size(); ++row) {
      projection_.evaluate(time[row], field);
      const Columns by_level(field.data(), static_cast<Eigen::Index>(levels_),
                             x_.rows() * y_.rows());
      Matrix decay, weight_before, weight_now;
      if (row > 0) {
        const auto weight = [&](double LowPass::*part) -> Matrix {
          return rate_.unaryExpr(
              [&](double rate) { return LowPass::over(rate, time[row] - time[row - 1]).*part; });
        };
        decay = weight(&LowPass::decay);
        weight_before = weight(&LowPass::before);
        weight_now = weight(&LowPass::now);
      }
      for (std::size_t i = 0; i < relaxed.size(); ++i) {
        const Eigen::RowVectorXd values = combine.row(static_cast<Eigen::Index>(i)) * by_level;
        const Matrix now =
            area * (y_ * Columns(values.data(), y_.rows(), x_.rows()) * x_.transpose())
                       .cwiseProduct(taken_);
        if (row > 0) {
          relaxed[i] = decay.cwiseProduct(relaxed[i]) + weight_before.cwiseProduct(before[i]) +
                       weight_now.cwiseProduct(now);
        }
        before[i] = now;
      }
      take(row, relaxed);
    }
  }
  /// Sum over a taxel of waves in these states [unit of the states].
  double in_taxel(std::size_t taxel, const Matrix& relaxed) const {
    return taxel_y_[taxel].dot(relaxed * taxel_x_[taxel]);
  }
  /// Squared sum of each wave over the columns of a taxel, added up over all taxels [wave of
  /// y][wave of x] [1].
  Matrix shares() const {
    Matrix sum = Matrix::Zero(y_.rows(), x_.rows());
    for (std::size_t taxel = 0; taxel < taxel_x_.size(); ++taxel) {
      sum += (taxel_y_[taxel] * taxel_x_[taxel].transpose()).cwiseAbs2();
    }
    return sum;
  }
  std::size_t levels() const { return levels_; }

private:
  const FullRun& run_;
  Matrix x_, y_; ///< [wave][column]
  /// Rate of each wave [1/s], and 1 for waves of the map, 0 for other waves [wave of y][wave of x].
  Matrix rate_, taken_;
  history::StrainProjection projection_;
  std::size_t levels_;
  /// Sum of each wave along x and along y over the columns of a taxel [taxel][wave] [1].
  std::vector<Eigen::VectorXd> taxel_x_, taxel_y_;
};

/// Magnitude of the charges of all taxels, on top and bottom.
struct Magnitude {
  double square = 0, time = 0, largest = 0; ///< integral over time [C2 s], time [s], charge [C]
  double rms() const { return time > 0 ? std::sqrt(square / time) : 0; }
};

Magnitude magnitude_of(const std::vector<ChargeRecord>& records) {
  Magnitude all;
  for (const ChargeRecord& record : records) {
    for (std::size_t i = 1; i < record.time.size(); ++i) {
      const double step = record.time[i] - record.time[i - 1];
      for (const auto& charge : record.charge) {
        all.square += step * charge[i] * charge[i] / 2;
        all.largest = std::max(all.largest, std::abs(charge[i]));
      }
      all.time += step;
    }
  }
  return all;
}

/// Chooses the fewest waves such that the other waves contribute no more than `negligible_waves` of
/// the charges, strongest first.
/// @param energy time integral of the squared charge that each wave brings [wave] [C2 s]
/// @param square time integral of the squared charges [C2 s]
SpreadMap strongest(const SpreadMap& all, const std::vector<double>& energy, double square) {
  std::vector<std::size_t> order(energy.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::ranges::greater{},
                           [&](std::size_t wave) { return energy[wave]; });
  double left = std::accumulate(energy.begin(), energy.end(), 0.0);
  SpreadMap map{all.columns_x, all.columns_y, {}, {}, {}, {}};
  for (const std::size_t wave : order) {
    if (map.rates.size() == most_kept_waves || left <= std::pow(negligible_waves, 2) * square) {
      break;
    }
    left -= energy[wave];
    map.wave_x.push_back(all.wave_x[wave]);
    map.wave_y.push_back(all.wave_y[wave]);
    map.rates.push_back(all.rates[wave]);
  }
  return map;
}

} // namespace

std::vector<ChargeRecord> joined(const std::vector<std::vector<ChargeRecord>>& of_runs) {
  std::vector<ChargeRecord> all;
  for (const auto& records : of_runs) {
    all.insert(all.end(), records.begin(), records.end());
  }
  return all;
}

SpreadMap all_waves(const FullRun& run) {
  const auto& grid = run.ions.grid;
  SpreadMap map;
  map.columns_x = grid.x_edges.size() - 1;
  map.columns_y = grid.y_edges.size() - 1;
  const double speed = layer_speed(run.input), half = run.input.skin.core_thickness() / 2;
  const auto number = [](double extent, std::size_t columns, std::size_t wave) {
    const auto count = static_cast<double>(columns);
    return 2 * count / extent *
           std::sin(std::numbers::pi * static_cast<double>(wave) / (2 * count));
  };
  for (std::size_t j = 0; j < map.columns_y; ++j) {
    for (std::size_t i = 0; i < map.columns_x; ++i) {
      const double alpha = std::hypot(number(run.input.skin.length, map.columns_x, i),
                                      number(run.input.skin.width, map.columns_y, j));
      if (alpha > 0) { // without the mean, which does not relax
        map.wave_x.push_back(i);
        map.wave_y.push_back(j);
        map.rates.push_back(speed * alpha * std::tanh(alpha * half));
      }
    }
  }
  return map;
}

void record_spread(const FullRun& run, const SpreadMap& map, std::vector<ChargeRecord>& records) {
  Waves waves(run, map);
  const auto levels = static_cast<Eigen::Index>(waves.levels());
  for (ChargeRecord& record : records) {
    record.spread.clear();
  }
  waves.each_row(Matrix::Identity(levels, levels),
                 [&](std::size_t, const std::vector<Matrix>& relaxed) {
                   for (std::size_t taxel = 0; taxel < records.size(); ++taxel) {
                     for (const Matrix& level : relaxed) {
                       records[taxel].spread.push_back(waves.in_taxel(taxel, level));
                     }
                   }
                 });
}

std::vector<double> wave_energies(const FullRun& run, const SpreadMap& map) {
  Waves waves(run, map);
  Matrix square = Matrix::Zero(static_cast<Eigen::Index>(map.columns_y),
                               static_cast<Eigen::Index>(map.columns_x));
  const std::vector<double>& time = run.ions.time;
  const Matrix weights = Eigen::Map<const Eigen::RowVectorXd>(
      map.weights.data(), static_cast<Eigen::Index>(map.weights.size()));
  waves.each_row(weights, [&](std::size_t row, const std::vector<Matrix>& relaxed) {
    if (row > 0) {
      square += (time[row] - time[row - 1]) * relaxed.front().cwiseAbs2();
    }
  });
  square = square.cwiseProduct(waves.shares()).eval();
  std::vector<double> energies;
  for (std::size_t i = 0; i < map.rates.size(); ++i) {
    energies.push_back(
        square(static_cast<Eigen::Index>(map.wave_y[i]), static_cast<Eigen::Index>(map.wave_x[i])));
  }
  return energies;
}

SpreadMap find_spread(const std::vector<FullRun>& runs,
                      std::vector<std::vector<ChargeRecord>>& records, std::size_t inputs,
                      const std::vector<double>& rates) {
  const auto record = [&](const SpreadMap& waves) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
      record_spread(runs[i], waves, records[i]);
    }
  };
  SpreadMap all = all_waves(runs.front());
  if (all.rates.empty()) {
    return {};
  }
  const std::vector<ChargeRecord> own = joined(records);
  const Magnitude charges = magnitude_of(own);
  const double alone = unseen_error(own, inputs, rates);
  if (alone * charges.rms() <= needs_spread * charges.largest) {
    return {};
  }
  record(all);
  const std::vector<ChargeRecord> both = joined(records);
  SpreadMap map;
  if (unseen_error(both, inputs, rates) < worthwhile_spread * alone) {
    all.weights = fit_charges(both, inputs, rates).spread;
    std::vector<double> energy(all.rates.size(), 0.0);
    for (const FullRun& run : runs) {
      const std::vector<double> of_run = wave_energies(run, all);
      std::ranges::transform(energy, of_run, energy.begin(), std::plus<>{});
    }
    map = strongest(all, energy, charges.square);
  }
  if (map.rates.empty()) {
    for (auto& of_run : records) {
      for (ChargeRecord& one : of_run) {
        one.spread.clear();
      }
    }
    return {};
  }
  record(map);
  return map;
}

} // namespace ionskin::live
