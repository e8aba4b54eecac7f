// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/training/channel_reduction.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/laws/shear/shear_measure.hpp"
#include "ionskin/mechanics/skin/strain_recovery.hpp"
#include "ionskin/parallel/task_pool.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>

namespace ionskin::live {
namespace {

using mechanics::CoreStrain;
using Matrix = Eigen::MatrixXd;

constexpr std::size_t most_snapshots = 800, most_modes = 60;
constexpr double negligible_mode = 1e-4; // of the snapshots, over their norm
constexpr std::size_t points_per_mode = 2;
constexpr double negligible_place_mode = 1e-5;

/// Rows whose norm is the channel, or the one row that it is.
using Rows = std::vector<std::array<double, 6>>; ///< weights of xx, yy, zz, yz, xz, xy

double value_of(const Rows& rows, const std::array<double, 6>& strain) {
  double square = 0, value = 0;
  for (const auto& row : rows) {
    value = std::inner_product(row.begin(), row.end(), strain.begin(), 0.0);
    square += value * value;
  }
  return rows.size() == 1 ? value : std::sqrt(square);
}

std::array<double, 6> strain_at(const CoreStrain& strain, std::size_t point) {
  std::array<double, 6> at{};
  for (std::size_t c = 0; c < at.size(); ++c) {
    at[c] = strain.component[c].empty() ? 0.0 : strain.component[c][point]; // no channel reads it
  }
  return at;
}

/// Rows whose norm, or whose one value, is a shear measure: of one linear in the strain its own
/// coefficients, else those of the quadratic form that its square must be.
/// Throws UserError for a measure that is neither.
Rows rows_of(const laws::ShearMeasure& measure) {
  constexpr std::size_t components = 6;
  const auto unit = [&](std::size_t i, std::size_t j) {
    std::array<double, components> strain{};
    strain[i] += 1;
    strain[j] += 1;
    return measure.at(strain);
  };
  constexpr std::array<double, components> probe{0.3, -0.7, 0.2, 0.5, -0.4, 0.9};
  std::array<double, components> opposite{};
  std::ranges::transform(probe, opposite.begin(), std::negate<>{});
  const double expected = measure.at(probe);
  Rows rows;
  if (measure.at(opposite) == -expected) {
    rows.emplace_back();
    for (std::size_t i = 0; i < components; ++i) {
      rows[0][i] = unit(i, i) / 2;
    }
  } else {
    Eigen::Matrix<double, components, components> form;
    for (std::size_t i = 0; i < components; ++i) {
      for (std::size_t j = 0; j < components; ++j) {
        const double own = std::pow(unit(i, i) / 2, 2), other = std::pow(unit(j, j) / 2, 2);
        form(static_cast<int>(i), static_cast<int>(j)) =
            i == j ? own : (std::pow(unit(i, j), 2) - own - other) / 2;
      }
    }
    const Eigen::SelfAdjointEigenSolver<decltype(form)> modes(form);
    for (int mode = 0; mode < static_cast<int>(components); ++mode) {
      const double value = modes.eigenvalues()[mode];
      if (value > 1e-12 * modes.eigenvalues().maxCoeff()) {
        rows.emplace_back();
        for (std::size_t i = 0; i < components; ++i) {
          rows.back()[i] = std::sqrt(value) * modes.eigenvectors()(static_cast<int>(i), mode);
        }
      }
    }
    if (rows.size() == 1) {
      rows.emplace_back(); // a single row has a sign, a norm of two has none
    }
  }
  if (!(std::abs(value_of(rows, probe) - expected) <= 1e-9 * std::abs(expected))) {
    throw UserError(fmt::format(
        "coupling.measure = \"{}\": a live skin knows measures that are linear in the strain, or "
        "the root of a quadratic form of it\n  = choose another measure",
        measure.name));
  }
  return rows;
}

Rows rows_of(const Case& input, const std::string& channel) {
  if (channel == history::channel_name::dilation) {
    return {{-1, -1, -1, 0, 0, 0}};
  }
  return rows_of(laws::shear_measure(input.coupling.measure));
}

/// Roots of the volumes of the Gauss points with the slider in the middle of its range.
Eigen::VectorXd point_weights(const mesh::SkinMesh& mesh, const std::array<double, 2>& centre,
                              const std::array<std::size_t, 3>& points) {
  const mesh::MeshLines lines = mesh.lines(centre);
  const std::vector<double> z(lines.z.begin() + static_cast<std::ptrdiff_t>(mesh.core_z()[0]),
                              lines.z.begin() + static_cast<std::ptrdiff_t>(mesh.core_z()[1]) + 1);
  const auto length = [](const std::vector<double>& line, std::size_t point) {
    return (line[point / 2 + 1] - line[point / 2]) / 2;
  };
  Eigen::VectorXd weights(static_cast<Eigen::Index>(points[0] * points[1] * points[2]));
  Eigen::Index at = 0;
  for (std::size_t k = 0; k < points[2]; ++k) {
    for (std::size_t j = 0; j < points[1]; ++j) {
      for (std::size_t i = 0; i < points[0]; ++i) {
        weights[at++] = std::sqrt(length(lines.x, i) * length(lines.y, j) * length(z, k));
      }
    }
  }
  return weights / weights.maxCoeff();
}

/// A state of a path, and where the history of its run has the instant.
struct Snapshot {
  const mechanics::ContactState* state = nullptr;
  const history::CoreHistory* history = nullptr;
  std::size_t sample = 0;
};

std::vector<Snapshot> snapshots_of(const std::vector<FullRun>& runs) {
  std::vector<Snapshot> all;
  for (const FullRun& run : runs) {
    const history::CoreHistory& history = run.history;
    if (history.grid.x_edges != runs.front().history.grid.x_edges ||
        history.grid.y_edges != runs.front().history.grid.y_edges ||
        history.grid.z_nodes != runs.front().history.grid.z_nodes) {
      throw InternalError("the runs of a training are not on one grid");
    }
    for (const mechanics::SteppedInstant& instant : run.contact.stepped) {
      const auto sample = std::ranges::lower_bound(history.time, instant.time - 1e-12);
      if (instant.state && instant.state->normal_force > 0 && sample != history.time.end() &&
          std::abs(*sample - instant.time) < 1e-12) {
        all.push_back({instant.state.get(), &history,
                       static_cast<std::size_t>(sample - history.time.begin())});
      }
    }
  }
  const std::size_t stride = (all.size() + most_snapshots - 1) / most_snapshots;
  std::vector<Snapshot> kept;
  for (std::size_t i = 0; i < all.size(); i += std::max<std::size_t>(1, stride)) {
    kept.push_back(all[i]);
  }
  if (kept.empty()) {
    throw InternalError("no snapshot of the training carries load");
  }
  return kept;
}

/// Pivots of a QR factorisation, and as many points again that count most in the fit.
std::vector<Eigen::Index> choose_points(const Matrix& modes) { // [points, modes], orthonormal
  const Matrix transposed = modes.transpose();
  const Eigen::ColPivHouseholderQR<Matrix> factor(transposed);
  std::vector<Eigen::Index> chosen;
  for (Eigen::Index i = 0; i < modes.cols(); ++i) {
    chosen.push_back(factor.colsPermutation().indices()[i]);
  }
  const Matrix picked = modes(chosen, Eigen::indexing::all);
  const Matrix inverse = (picked.transpose() * picked).inverse();
  const Eigen::VectorXd leverage = (modes * inverse).rowwise().norm();
  std::vector<Eigen::Index> order(static_cast<std::size_t>(modes.rows()));
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = static_cast<Eigen::Index>(i);
  }
  std::ranges::stable_sort(order, [&](auto a, auto b) { return leverage[a] > leverage[b]; });
  const auto wanted =
      std::min(points_per_mode * static_cast<std::size_t>(modes.cols()), order.size());
  for (std::size_t i = 0; chosen.size() < wanted; ++i) {
    if (std::ranges::find(chosen, order[i]) == chosen.end()) {
      chosen.push_back(order[i]);
    }
  }
  return chosen;
}

void append(std::vector<float>& values, const Matrix& rows) {
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    for (Eigen::Index j = 0; j < rows.cols(); ++j) {
      values.push_back(static_cast<float>(rows(i, j)));
    }
  }
}

/// Weights of the integral over z of a function that is linear between nodes, and of its moment.
void set_level_weights(const std::vector<double>& z, ChannelMap& map) {
  map.mean.assign(z.size(), 0);
  map.moment.assign(z.size(), 0);
  const double thickness = z.back();
  for (std::size_t i = 0; i + 1 < z.size(); ++i) {
    const double length = z[i + 1] - z[i];
    const auto arm = [&](double at) { return at / thickness - 0.5; };
    map.mean[i] += length / 2;
    map.mean[i + 1] += length / 2;
    map.moment[i] += length / 6 * (2 * arm(z[i]) + arm(z[i + 1]));
    map.moment[i + 1] += length / 6 * (arm(z[i]) + 2 * arm(z[i + 1]));
  }
}

/// Points at which the strain under unit forces is wanted, of one channel.
struct Wanted {
  Rows rows;
  std::vector<Eigen::Index> points;
};

ChannelMap reduce_fields(const std::vector<Snapshot>& snapshots, const std::string& channel,
                         const Eigen::VectorXd& weights, Matrix values,
                         std::vector<Eigen::Index>& points) {
  const history::StrainGrid& grid = snapshots.front().history->grid;
  const auto count = static_cast<Eigen::Index>(snapshots.size());
  values.array().colwise() *= weights.array(); // [points, snapshots]
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(values.transpose() * values);
  Eigen::Index modes = 0;
  double tail = eigen.eigenvalues().cwiseMax(0).sum();
  const double most = tail;
  while (modes < std::min<Eigen::Index>(most_modes, count) &&
         tail > std::pow(negligible_mode, 2) * most) {
    tail -= std::max(0.0, eigen.eigenvalues()[count - 1 - modes++]);
  }
  const Matrix combine = eigen.eigenvectors().rightCols(modes) *
                         eigen.eigenvalues().tail(modes).cwiseSqrt().cwiseInverse().asDiagonal();
  const Matrix basis = values * combine;
  points = choose_points(basis);
  Matrix sampled = basis(points, Eigen::indexing::all);
  for (std::size_t i = 0; i < points.size(); ++i) {
    sampled.row(static_cast<Eigen::Index>(i)) /= weights[points[i]];
  }
  ChannelMap map;
  append(map.fit, sampled.completeOrthogonalDecomposition().pseudoInverse());
  Matrix fields = Matrix::Zero(static_cast<Eigen::Index>(grid.values()), modes);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Snapshot& snapshot = snapshots[static_cast<std::size_t>(k)];
    const history::StrainField& field =
        *snapshot.history->channel(channel).samples[snapshot.sample];
    fields += Eigen::Map<const Eigen::VectorXd>(field.data(), fields.rows()) * combine.row(k);
  }
  append(map.field, fields.transpose());
  map.x_edges = grid.x_edges;
  map.y_edges = grid.y_edges;
  set_level_weights(grid.z_nodes, map);
  return map;
}

/// Strains at the points under unit forces on every cell, at every node.
void add_unit_strains(const mechanics::SkinModel& model, const mechanics::StrainRecovery& recovery,
                      const PlaceNodes& places, int threads, const std::vector<Wanted>& wanted,
                      std::vector<ChannelMap>& maps) {
  constexpr std::size_t loads_at_once = 8;
  const std::size_t size = 3 * model.cells.count();
  std::vector<std::vector<std::vector<float>>> at_nodes(wanted.size());
  for (const double y : places.y) {
    for (const double x : places.x) {
      std::vector<std::vector<std::vector<float>>> of_loads(
          size, std::vector<std::vector<float>>(wanted.size()));
      parallel::run_tasks((size + loads_at_once - 1) / loads_at_once, threads, [&](std::size_t i) {
        base::check_interrupt();
        const std::size_t first = i * loads_at_once, count = std::min(loads_at_once, size - first);
        std::vector<mechanics::CellVector> loads(count, mechanics::CellVector(size, 0.0));
        for (std::size_t own = 0; own < count; ++own) {
          loads[own][first + own] = 1;
        }
        const std::vector<std::array<double, 2>> centres(count, {x, y});
        const auto strains = recovery.at(centres, loads);
        for (std::size_t own = 0; own < count; ++own) {
          for (std::size_t c = 0; c < wanted.size(); ++c) {
            for (const Eigen::Index point : wanted[c].points) {
              const auto at = strain_at(strains[own].core, static_cast<std::size_t>(point));
              for (const auto& row : wanted[c].rows) {
                of_loads[first + own][c].push_back(static_cast<float>(value_of({row}, at)));
              }
            }
          }
        }
      });
      for (std::size_t c = 0; c < wanted.size(); ++c) {
        std::vector<float>& values = at_nodes[c].emplace_back();
        for (const auto& of_load : of_loads) {
          values.insert(values.end(), of_load[c].begin(), of_load[c].end());
        }
      }
    }
  }
  for (std::size_t c = 0; c < wanted.size(); ++c) {
    maps[c].rows_per_point = wanted[c].rows.size();
    maps[c].strain = place_map(places, at_nodes[c], negligible_place_mode);
  }
}

} // namespace

PlaceMap place_map(const PlaceNodes& places, const std::vector<std::vector<float>>& nodes,
                   double negligible) {
  const auto count = static_cast<Eigen::Index>(nodes.size()),
             size = static_cast<Eigen::Index>(nodes.front().size());
  Matrix values(size, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    values.col(i) = Eigen::Map<const Eigen::VectorXf>(nodes[i].data(), size).cast<double>();
  }
  const Eigen::VectorXd mean = values.rowwise().mean();
  values.colwise() -= mean;
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(values.transpose() * values);
  std::vector<Eigen::Index> large;
  for (Eigen::Index i = count; i-- > 0;) {
    if (eigen.eigenvalues()[i] > std::pow(negligible * mean.norm(), 2)) {
      large.push_back(i);
    }
  }
  const Matrix amplitude = eigen.eigenvectors()(Eigen::indexing::all, large);
  PlaceMap map{places.x, places.y, {}, {}};
  append(map.values, mean.transpose());
  append(map.values, (values * amplitude).transpose());
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index k = 0; k < amplitude.cols(); ++k) {
      map.amplitude.push_back(amplitude(i, k));
    }
  }
  return map;
}

PlaceMap reduce_compliance(const mechanics::SkinModel& model, const PlaceNodes& places) {
  mechanics::ContactCompliance compliance(model);
  std::vector<std::vector<float>> values;
  for (const double y : places.y) {
    for (const double x : places.x) {
      Matrix matrix;
      compliance.at({x, y}, matrix);
      values.emplace_back(matrix.data(), matrix.data() + matrix.size());
    }
  }
  return place_map(places, values, negligible_place_mode);
}

std::vector<ChannelMap> reduce_channels(const std::vector<FullRun>& runs,
                                        const std::shared_ptr<const mechanics::SkinModel>& model,
                                        const PlaceNodes& places, int threads,
                                        const std::vector<std::string>& channels) {
  const mechanics::StrainRecovery recovery(model, mechanics::strain_components(runs.front().input),
                                           threads);
  const std::vector<Snapshot> snapshots = snapshots_of(runs);
  std::vector<Wanted> wanted;
  for (const std::string& channel : channels) {
    wanted.push_back({rows_of(runs.front().input, channel), {}});
  }
  std::vector<Matrix> values(channels.size());
  Eigen::VectorXd weights;
  for (std::size_t k = 0; k < snapshots.size(); ++k) {
    base::check_interrupt();
    const CoreStrain& strain = mechanics::core_strain(*snapshots[k].state);
    const std::size_t points = strain.points[0] * strain.points[1] * strain.points[2];
    if (k == 0) {
      weights =
          point_weights(model->mesh, {places.x[places.x.size() / 2], places.y[places.y.size() / 2]},
                        strain.points);
    }
    for (std::size_t c = 0; c < channels.size(); ++c) {
      values[c].resize(static_cast<Eigen::Index>(points),
                       k == 0 ? static_cast<Eigen::Index>(snapshots.size()) : values[c].cols());
      for (std::size_t point = 0; point < points; ++point) {
        values[c](static_cast<Eigen::Index>(point), static_cast<Eigen::Index>(k)) =
            value_of(wanted[c].rows, strain_at(strain, point));
      }
    }
  }
  std::vector<ChannelMap> maps;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    maps.push_back(
        reduce_fields(snapshots, channels[c], weights, std::move(values[c]), wanted[c].points));
  }
  add_unit_strains(*model, recovery, places, threads, wanted, maps);
  return maps;
}

} // namespace ionskin::live
