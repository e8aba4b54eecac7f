// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/training/channel_reduction.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/handover/field_projection.hpp"
#include "ionskin/laws/shear/shear_measure.hpp"
#include "ionskin/live/training/channel_basis.hpp"
#include "ionskin/live/training/reflections.hpp"
#include "ionskin/mechanics/output/core_strain.hpp"
#include "ionskin/mechanics/skin/strain_recovery.hpp"
#include "ionskin/parallel/task_pool.hpp"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <numeric>
#include <string>
#include <utility>

namespace ionskin::live {
namespace {

using mechanics::CoreStrain;
using Matrix = Eigen::MatrixXd;

constexpr std::size_t loads_at_once = 8; // that are recovered together
constexpr double negligible_place_mode = 1e-5, negligible_fit_mode = 1e-3;
constexpr std::size_t samples_at_node = 240;
/// What counts of a channel beside the charges: its mean and its first moment, so much of them.
constexpr double signal_share = 1e-2;
constexpr double symmetric = 1e-9; // of a length, over the largest

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

/// Roots of the volumes of the Gauss points with the slider in the middle of its range; 0 of those
/// outside the lines that ride with it, which are elsewhere with each of its places.
std::vector<double> point_weights(const mesh::SkinMesh& mesh, const std::array<double, 2>& centre,
                                  const std::array<std::size_t, 3>& points) {
  const mesh::MeshLines lines = mesh.lines(centre);
  const std::vector<double> z(lines.z.begin() + static_cast<std::ptrdiff_t>(mesh.core_z()[0]),
                              lines.z.begin() + static_cast<std::ptrdiff_t>(mesh.core_z()[1]) + 1);
  const auto length = [](const std::vector<double>& line, std::size_t point) {
    return (line[point / 2 + 1] - line[point / 2]) / 2;
  };
  const auto x = mesh.footprint_x(), y = mesh.footprint_y(); // places in the lines
  std::vector<double> weights;
  for (std::size_t k = 0; k < points[2]; ++k) {
    for (std::size_t j = 0; j < points[1]; ++j) {
      for (std::size_t i = 0; i < points[0]; ++i) {
        const bool rides = i / 2 >= x[0] && i / 2 < x[1] && j / 2 >= y[0] && j / 2 < y[1];
        weights.push_back(rides ? std::sqrt(length(lines.x, i) * length(lines.y, j) * length(z, k))
                                : 0.0);
      }
    }
  }
  return weights;
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
  std::vector<std::size_t> points;
};

std::vector<double> about(double middle, std::vector<double> lines) {
  for (double& line : lines) {
    line -= middle;
  }
  return lines;
}

/// Whether values on the lines of a grid of cells are the same seen from its other end.
bool is_mirrored(const std::vector<double>& lines) {
  const double most = std::max(std::abs(lines.front()), std::abs(lines.back()));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (std::abs(lines[i] + lines[lines.size() - 1 - i]) > symmetric * most) {
      return false;
    }
  }
  return true;
}

/// Whether the mirror image of every node on the skin is a node.
bool are_mirrored(const PlaceNodes& places, const SkinData& data) {
  return is_mirrored(about(data.length / 2, places.x)) &&
         is_mirrored(about(data.width / 2, places.y));
}

/// Of the columns of a grid that rides with the slider, what lies within the core [y][x] [m2].
std::vector<double> areas_within(const history::StrainGrid& grid,
                                 const std::array<double, 2>& place,
                                 const std::array<double, 2>& extent) {
  const auto lengths = [&](const std::vector<double>& edges, std::size_t d) {
    std::vector<double> result;
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
      result.push_back(std::clamp(edges[i + 1] + place[d], 0.0, extent[d]) -
                       std::clamp(edges[i] + place[d], 0.0, extent[d]));
    }
    return result;
  };
  std::vector<double> areas;
  for (const double y : lengths(grid.y_edges, 1)) {
    for (const double x : lengths(grid.x_edges, 0)) {
      areas.push_back(x * y);
    }
  }
  return areas;
}

/// What a reflection makes of the weights of a basis.
Matrix mirrored_fit(const Matrix& fit, const ChannelBasis& basis, std::size_t g,
                    const Reflections& reflections) {
  // Points stand in orbits, in the order of the reflections, whose products are reflections.
  const std::size_t orbit = reflections.count();
  Matrix result(fit.rows(), fit.cols());
  for (std::size_t i = 0; i < basis.points.size(); ++i) {
    const std::size_t image = i / orbit * orbit + ((i % orbit) ^ g);
    for (Eigen::Index mode = 0; mode < fit.rows(); ++mode) {
      result(mode, static_cast<Eigen::Index>(image)) =
          reflections.sign(basis.parity[static_cast<std::size_t>(mode)], g) *
          fit(mode, static_cast<Eigen::Index>(i));
    }
  }
  return result;
}

/// Those of the slider; the skin has both.
Reflections reflections_of(const mechanics::SkinModel& model) {
  const std::array<std::size_t, 3> size{model.cells.columns(), model.cells.rows(), 1};
  const double deepest = *std::ranges::max_element(model.gap);
  std::array<bool, 2> along{is_mirrored(model.cells.lines_x),
                            !model.mesh.half_model() && is_mirrored(model.cells.lines_y)};
  for (std::size_t d = 0; d < 2; ++d) {
    const Reflections alone(d == 0, d == 1);
    for (std::size_t cell = 0; along[d] && cell < model.gap.size(); ++cell) {
      along[d] =
          std::abs(model.gap[cell] - model.gap[alone.image(1, cell, size)]) <= symmetric * deepest;
    }
  }
  return {along[0], along[1]};
}

/// A box of places that is its own mirror image on the skin.
MotionBox mirrored_box(const MotionBox& box, const SkinData& data) {
  const std::array<double, 2> extent{data.length, data.width};
  MotionBox both = box;
  for (std::size_t d = 0; d < 2; ++d) {
    both.low[d] = std::min(box.low[d], extent[d] - box.high[d]);
    both.high[d] = extent[d] - both.low[d];
  }
  return both;
}

/// Rows of which each counts alike: what drives the charges, and a little of the signals of the
/// core themselves.
Matrix level_measure(const ChannelMap& map, const SkinData& data, bool drives) {
  const auto levels = static_cast<Eigen::Index>(map.mean.size());
  const auto add = [](Matrix& form, const Matrix& rows, double share) {
    const double norm = rows.squaredNorm();
    if (norm > 0) {
      form += share / norm * rows.transpose() * rows;
    }
  };
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto rows = [&](const std::vector<double>& values) {
    return Eigen::Map<const RowMajor>(values.data(),
                                      static_cast<Eigen::Index>(values.size()) / levels, levels);
  };
  Matrix form = Matrix::Zero(levels, levels);
  add(form, rows(map.mean), signal_share);
  add(form, rows(map.moment), signal_share);
  if (drives) {
    for (const ChargeModel* model : {&data.whole, &data.part}) {
      add(form, rows(model->direct), 1);
      add(form, rows(model->residue), 1);
    }
    add(form, rows(data.spread.weights), signal_share);
  }
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(form);
  // Where fewer combinations than levels count, an eigenvalue may round to below 0.
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal() *
         eigen.eigenvectors().transpose();
}

/// The strain of the samples at the Gauss points, and the fields of the channels.
std::vector<ChannelSamples> recovered(const std::vector<std::vector<double>>& samples,
                                      const std::array<double, 2>& place,
                                      const std::vector<Rows>& rows,
                                      const mechanics::StrainRecovery& recovery,
                                      const handover::FieldProjection& projection, int threads,
                                      const base::ProgressCallback& progress) {
  std::vector<ChannelSamples> result(rows.size());
  const history::StrainGrid& grid = projection.grid();
  std::mutex one_by_one;
  std::size_t done = 0;
  parallel::run_tasks(
      (samples.size() + loads_at_once - 1) / loads_at_once, threads, [&](std::size_t task) {
        base::check_interrupt();
        const std::size_t first = task * loads_at_once,
                          count = std::min(loads_at_once, samples.size() - first);
        const std::vector<std::array<double, 2>> centres(count, place);
        std::vector<mechanics::CellVector> forces;
        for (std::size_t i = first; i < first + count; ++i) {
          forces.push_back(samples[i]);
        }
        const auto strains = recovery.at(centres, forces);
        for (std::size_t i = 0; i < count; ++i) {
          const CoreStrain& strain = strains[i].core;
          const std::size_t points = strain.points[0] * strain.points[1] * strain.points[2];
          for (std::size_t c = 0; c < rows.size(); ++c) {
            std::vector<double> values(points);
            for (std::size_t point = 0; point < points; ++point) {
              values[point] = value_of(rows[c], strain_at(strain, point));
            }
            const history::StrainField field = projection.at(values, strain.points, centres[i]);
            const std::lock_guard lock(one_by_one);
            ChannelSamples& own = result[c];
            if (own.at_points.size() == 0) {
              own.points = strain.points;
              own.cells = {grid.x_edges.size() - 1, grid.y_edges.size() - 1, grid.z_nodes.size()};
              const auto columns = static_cast<Eigen::Index>(samples.size());
              own.at_points.resize(static_cast<Eigen::Index>(points), columns);
              own.fields.resize(static_cast<Eigen::Index>(field.size()), columns);
            }
            const auto column = static_cast<Eigen::Index>(first + i);
            own.at_points.col(column) =
                Eigen::Map<const Eigen::VectorXd>(values.data(), own.at_points.rows())
                    .cast<float>();
            own.fields.col(column) =
                Eigen::Map<const Eigen::VectorXd>(field.data(), own.fields.rows()).cast<float>();
          }
        }
        const std::lock_guard lock(one_by_one);
        done += count;
        progress("strain of the contact",
                 static_cast<double>(done) / static_cast<double>(samples.size()));
      });
  return result;
}

/// Strains at the points under unit forces on every cell, at every node. Of nodes that are mirror
/// images of each other one is solved.
void add_unit_strains(const mechanics::SkinModel& model, const SkinData& data,
                      const mechanics::StrainRecovery& recovery, const PlaceNodes& places,
                      const Reflections& reflections, int threads,
                      const std::vector<Wanted>& wanted, std::vector<ChannelMap>& maps) {
  const std::size_t size = 3 * model.cells.count(), columns = places.x.size();
  const std::array<std::size_t, 3> cells{model.cells.columns(), model.cells.rows(), 1},
      nodes{columns, places.y.size(), 1};
  // [node][channel]: values [load][point][row]
  std::vector<std::vector<std::vector<float>>> at_nodes(nodes[0] * nodes[1]);
  const bool mirror_places = are_mirrored(places, data);
  for (std::size_t node = 0; node < at_nodes.size(); ++node) {
    if (!at_nodes[node].empty()) {
      continue;
    }
    std::vector<std::size_t> images; // of the node, that of no reflection first
    for (std::size_t g = 0; g < reflections.count(); ++g) {
      images.push_back(reflections.image(g, node, nodes));
    }
    const auto is_new = [&](std::size_t g) {
      return g == 0 || (mirror_places &&
                        std::find(images.begin(), images.begin() + static_cast<std::ptrdiff_t>(g),
                                  images[g]) == images.begin() + static_cast<std::ptrdiff_t>(g));
    };
    std::size_t per_load = 0;
    for (std::size_t g = 0; g < images.size(); ++g) {
      if (is_new(g)) {
        at_nodes[images[g]].resize(wanted.size());
        for (std::size_t c = 0; c < wanted.size(); ++c) {
          per_load = wanted[c].points.size() * wanted[c].rows.size();
          at_nodes[images[g]][c].resize(size * per_load);
        }
      }
    }
    const std::array<double, 2> place{places.x[node % columns], places.y[node / columns]};
    parallel::run_tasks((size + loads_at_once - 1) / loads_at_once, threads, [&](std::size_t i) {
      base::check_interrupt();
      const std::size_t first = i * loads_at_once, count = std::min(loads_at_once, size - first);
      std::vector<mechanics::CellVector> loads(count, mechanics::CellVector(size, 0.0));
      for (std::size_t own = 0; own < count; ++own) {
        loads[own][first + own] = 1;
      }
      const std::vector<std::array<double, 2>> centres(count, place);
      const auto strains = recovery.at(centres, loads);
      for (std::size_t own = 0; own < count; ++own) {
        const std::size_t load = first + own, component = load % 3;
        for (std::size_t g = 0; g < images.size(); ++g) {
          if (!is_new(g)) {
            continue;
          }
          const auto& [x, y] = reflections.element(g);
          const CoreStrain strain = mechanics::mirrored(strains[own].core, {x, y});
          const double sign = (component == 1 && x) || (component == 2 && y) ? -1 : 1;
          const std::size_t image = 3 * reflections.image(g, load / 3, cells) + component;
          for (std::size_t c = 0; c < wanted.size(); ++c) {
            const std::size_t rows = wanted[c].rows.size();
            float* into = at_nodes[images[g]][c].data() + image * wanted[c].points.size() * rows;
            for (const std::size_t point : wanted[c].points) {
              const auto at = strain_at(strain, point);
              for (const auto& row : wanted[c].rows) {
                *into++ = static_cast<float>(sign * value_of({row}, at));
              }
            }
          }
        }
      }
    });
  }
  for (std::size_t c = 0; c < wanted.size(); ++c) {
    std::vector<std::vector<float>> of_channel;
    for (auto& node : at_nodes) {
      of_channel.push_back(std::move(node[c]));
    }
    maps[c].rows_per_point = wanted[c].rows.size();
    maps[c].strain = place_map(places, of_channel, negligible_place_mode);
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

std::vector<ChannelMap> reduce_channels(const Case& input, const SkinData& data,
                                        const std::shared_ptr<const mechanics::SkinModel>& model,
                                        const PlaceNodes& places,
                                        const std::vector<std::vector<double>>& samples,
                                        int threads, const std::vector<std::string>& channels,
                                        const base::ProgressCallback& progress) {
  const mechanics::StrainRecovery recovery(model, mechanics::strain_components(input), threads);
  const Reflections reflections = reflections_of(*model);
  const handover::FieldProjection projection(
      input, model->mesh, mirrored_box({data.lowest_place, data.highest_place}, data));
  const history::StrainGrid& grid = projection.grid();
  std::vector<Rows> rows;
  for (const std::string& channel : channels) {
    rows.push_back(rows_of(input, channel));
  }
  const std::array<double, 2> middle{(places.x.front() + places.x.back()) / 2,
                                     (places.y.front() + places.y.back()) / 2};
  std::vector<ChannelSamples> of_channels =
      recovered(samples, middle, rows, recovery, projection, threads, progress);
  ChannelMeasure measure;
  measure.point_weight = point_weights(model->mesh, middle, of_channels.front().points);
  measure.cell_area = areas_within(grid, middle, {data.length, data.width});
  std::vector<ChannelMap> maps;
  std::vector<ChannelBasis> bases;
  std::vector<Wanted> wanted;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    ChannelMap& map = maps.emplace_back();
    map.x_edges = grid.x_edges;
    map.y_edges = grid.y_edges;
    set_level_weights(grid.z_nodes, map);
    measure.levels = level_measure(map, data, c + 1 == channels.size());
    const ChannelBasis basis =
        channel_basis(std::exchange(of_channels[c], {}), measure, reflections);
    bases.push_back(basis);
    append(map.field, basis.field.transpose());
    wanted.push_back({rows[c], basis.points});
  }
  // At the nodes, of which mirror images have mirrored fits.
  const std::array<std::size_t, 3> nodes{places.x.size(), places.y.size(), 1};
  std::vector<std::vector<std::vector<float>>> fits(
      channels.size(), std::vector<std::vector<float>>(nodes[0] * nodes[1]));
  const std::vector<std::vector<double>> fewer(
      samples.begin(),
      samples.begin() + static_cast<std::ptrdiff_t>(std::min(samples.size(), samples_at_node)));
  const bool mirror_places = are_mirrored(places, data);
  for (std::size_t node = 0; node < nodes[0] * nodes[1]; ++node) {
    if (!fits.front()[node].empty()) {
      continue;
    }
    const std::array<double, 2> place{places.x[node % nodes[0]], places.y[node / nodes[0]]};
    const std::vector<ChannelSamples> own =
        recovered(fewer, place, rows, recovery, projection, threads, progress);
    measure.cell_area = areas_within(grid, place, {data.length, data.width});
    for (std::size_t c = 0; c < channels.size(); ++c) {
      measure.levels = level_measure(maps[c], data, c + 1 == channels.size());
      const Matrix fit = fit_at_place(bases[c], own[c], measure);
      for (std::size_t g = 0; g < (mirror_places ? reflections.count() : 1); ++g) {
        std::vector<float>& into = fits[c][reflections.image(g, node, nodes)];
        if (into.empty()) {
          append(into, mirrored_fit(fit, bases[c], g, reflections));
        }
      }
    }
  }
  for (std::size_t c = 0; c < channels.size(); ++c) {
    maps[c].fit = place_map(places, fits[c], negligible_fit_mode);
  }
  add_unit_strains(*model, data, recovery, places, reflections, threads, wanted, maps);
  return maps;
}

} // namespace ionskin::live
