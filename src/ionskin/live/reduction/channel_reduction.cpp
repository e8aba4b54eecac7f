// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/reduction/channel_reduction.hpp"

#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/handover/field_projection.hpp"
#include "ionskin/live/reduction/channel_basis.hpp"
#include "ionskin/live/reduction/fixed_modes.hpp"
#include "ionskin/live/reduction/measure_rows.hpp"
#include "ionskin/live/reduction/place_map.hpp"
#include "ionskin/live/reduction/place_symmetry.hpp"
#include "ionskin/live/reduction/reflections.hpp"
#include "ionskin/live/reduction/row_major.hpp"
#include "ionskin/live/reduction/unit_strains.hpp"
#include "ionskin/mechanics/output/core_strain.hpp"
#include "ionskin/mechanics/skin/strain_recovery.hpp"
#include "ionskin/parallel/task_pool.hpp"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <string>
#include <utility>

namespace ionskin::live {
namespace {

using mechanics::CoreStrain;
using Matrix = Eigen::MatrixXd;

constexpr double negligible_fit_mode = 1e-3;
constexpr std::size_t samples_at_node = 240;
/// Share of the signals of a channel beside the charges: its mean and its first moment, so much of
/// them.
constexpr double signal_share = 1e-2;
/// Largest displacement of an element relative to the slider, over all positions, at whose points
/// strain is evaluated, over the thickness of the skin [1]. A contact strains the skin beside
/// itself, too; points that move further than the strain changes are more than the fits bear.
constexpr double most_displaced = 0.15;

/// Largest displacement of each element relative to the slider, over the trained positions, along
/// one direction [m].
/// @param d direction, 0: x, 1: y
std::vector<double> displacements(const mesh::SkinMesh& mesh, const std::array<double, 2>& centre,
                                  const PlaceNodes& places, std::size_t d) {
  const auto middles = [&](const std::array<double, 2>& place) {
    const mesh::MeshLines lines = mesh.lines(place);
    const std::vector<double>& line = d == 0 ? lines.x : lines.y;
    std::vector<double> result;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      result.push_back((line[i] + line[i + 1]) / 2 - place[d]);
    }
    return result;
  };
  const std::vector<double> at_centre = middles(centre);
  std::vector<double> largest(at_centre.size());
  const std::vector<double>& nodes = d == 0 ? places.x : places.y;
  for (const double end : {nodes.front(), nodes.back()}) {
    std::array<double, 2> place = centre;
    place[d] = end;
    const std::vector<double> at_end = middles(place);
    for (std::size_t i = 0; i < largest.size(); ++i) {
      largest[i] = std::max(largest[i], std::abs(at_end[i] - at_centre[i]));
    }
  }
  return largest;
}

/// Roots of the volumes of the Gauss points with the slider at a position [m^(3/2)]; 0 where the
/// mesh lines do not keep their distances from the slider.
/// @param most largest displacement of an element whose points count [m]
std::vector<double> point_weights(const mesh::SkinMesh& mesh, const std::array<double, 2>& centre,
                                  const PlaceNodes& places,
                                  const std::array<std::size_t, 3>& points, double most) {
  const mesh::MeshLines lines = mesh.lines(centre);
  const std::vector<double> z(lines.z.begin() + static_cast<std::ptrdiff_t>(mesh.core_z()[0]),
                              lines.z.begin() + static_cast<std::ptrdiff_t>(mesh.core_z()[1]) + 1),
      along_x = displacements(mesh, centre, places, 0),
      along_y = displacements(mesh, centre, places, 1);
  const auto length = [](const std::vector<double>& line, std::size_t point) {
    return (line[point / 2 + 1] - line[point / 2]) / 2;
  };
  std::vector<double> weights;
  for (std::size_t k = 0; k < points[2]; ++k) {
    for (std::size_t j = 0; j < points[1]; ++j) {
      for (std::size_t i = 0; i < points[0]; ++i) {
        const bool counts = along_x[i / 2] <= most && along_y[j / 2] <= most;
        weights.push_back(counts ? std::sqrt(length(lines.x, i) * length(lines.y, j) * length(z, k))
                                 : 0.0);
      }
    }
  }
  return weights;
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

/// Areas of the columns of a grid that rides with the slider, as far as they lie within the core
/// and not in zones at its ends [y][x] [m2].
std::vector<double> areas_within(const history::StrainGrid& grid,
                                 const std::array<double, 2>& place,
                                 const std::array<double, 2>& extent,
                                 const std::array<double, 2>& zones) {
  const auto lengths = [&](const std::vector<double>& edges, std::size_t d) {
    std::vector<double> result;
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
      result.push_back(std::clamp(edges[i + 1] + place[d], zones[d], extent[d] - zones[d]) -
                       std::clamp(edges[i] + place[d], zones[d], extent[d] - zones[d]));
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

/// Weights of a basis under a reflection.
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

/// Weights at a node that reflections map onto itself, in a middle plane of the skin: the mean of
/// their images, for its samples have none.
Matrix of_own_images(const Matrix& fit, const ChannelBasis& basis, std::size_t node,
                     const std::array<std::size_t, 3>& nodes, const Reflections& reflections) {
  Matrix sum = Matrix::Zero(fit.rows(), fit.cols());
  double images = 0;
  for (std::size_t g = 0; g < reflections.count(); ++g) {
    if (reflections.image(g, node, nodes) == node) {
      sum += mirrored_fit(fit, basis, g, reflections);
      ++images;
    }
  }
  return sum / images;
}

/// Combinations of the levels that count alike: what drives the charges, and, of the channel that
/// tells signals of the core, a little of these. Water is driven by how its pressure differs
/// through the thickness, a hundredth of it.
Matrix level_measure(const ChannelMap& map, const SkinData& data, bool tells, bool drives) {
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
  if (tells) {
    add(form, rows(map.mean), signal_share);
    add(form, rows(map.moment), signal_share);
  }
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
                                      const std::vector<MeasureRows>& rows,
                                      const mechanics::StrainRecovery& recovery,
                                      const handover::FieldProjection& projection, int threads,
                                      const std::function<void(double)>& progress) {
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
        progress(static_cast<double>(done) / static_cast<double>(samples.size()));
      });
  return result;
}

/// Leaves out what lies beside the area of the measure, at the ends of the skin or beyond them.
void ride_alone(const ChannelMeasure& measure, ChannelSamples& samples) {
  const auto columns = static_cast<Eigen::Index>(measure.cell_area.size());
  for (Eigen::Index row = 0; row < samples.fields.rows(); ++row) {
    if (measure.cell_area[static_cast<std::size_t>(row % columns)] <= 0) {
      samples.fields.row(row).setZero();
    }
  }
}

/// Nodes of the positions whose fits are solved; the fits of their mirror images are mirrored.
std::vector<std::size_t> nodes_to_solve(const PlaceNodes& places, const SkinData& data,
                                        const Reflections& reflections) {
  const std::array<std::size_t, 3> nodes{places.x.size(), places.y.size(), 1};
  const std::size_t images = are_mirrored(places, data) ? reflections.count() : 1;
  std::vector<std::size_t> result;
  for (std::size_t node = 0; node < nodes[0] * nodes[1]; ++node) {
    bool first = true;
    for (std::size_t g = 1; g < images; ++g) {
      first = first && reflections.image(g, node, nodes) >= node;
    }
    if (first) {
      result.push_back(node);
    }
  }
  return result;
}

Matrix values_at(const ChannelSamples& samples, const std::vector<std::size_t>& points) {
  Matrix values(static_cast<Eigen::Index>(points.size()), samples.at_points.cols());
  for (std::size_t i = 0; i < points.size(); ++i) {
    values.row(static_cast<Eigen::Index>(i)) =
        samples.at_points.row(static_cast<Eigen::Index>(points[i])).cast<double>();
  }
  return values;
}

} // namespace

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
  std::vector<MeasureRows> rows;
  for (const std::string& channel : channels) {
    rows.push_back(measure_rows(input, channel));
  }
  const std::array<double, 2> middle{(places.x.front() + places.x.back()) / 2,
                                     (places.y.front() + places.y.back()) / 2};
  std::vector<ChannelSamples> of_channels =
      recovered(samples, middle, rows, recovery, projection, threads,
                [&](double fraction) { progress("strain of the contact", fraction); });
  ChannelMeasure measure;
  const double thickness = input.skin.thickness();
  measure.point_weight = point_weights(model->mesh, middle, places, of_channels.front().points,
                                       most_displaced * thickness);
  const std::array<double, 2> extent{data.length, data.width},
      zones = end_zones(data, places, thickness);
  measure.cell_area = areas_within(grid, middle, extent, zones);
  const auto fixed = fixed_edges(data, places, grid, thickness);
  ChannelMeasure fixed_measure;
  fixed_measure.cell_area =
      areas_within({fixed[0], fixed[1], grid.z_nodes}, {0, 0}, extent, {0, 0});
  const std::array<std::size_t, 3> fixed_size{fixed[0].size() - 1, fixed[1].size() - 1,
                                              grid.z_nodes.size()};
  std::vector<ChannelMap> maps;
  std::vector<ChannelBasis> bases;
  std::vector<WantedStrain> wanted;
  const auto measure_of = [&](std::size_t c) {
    return level_measure(maps[c], data, c == 0, c + 1 == channels.size());
  };
  std::vector<double> whole;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    ChannelMap& map = maps.emplace_back();
    map.x_edges = grid.x_edges;
    map.y_edges = grid.y_edges;
    map.fixed_x_edges = fixed[0];
    map.fixed_y_edges = fixed[1];
    set_level_weights(grid.z_nodes, map);
    measure.levels = measure_of(c);
    whole.push_back(
        static_cast<double>(measured(of_channels[c].fields, measure).norm()) *
        std::sqrt(static_cast<double>(samples_at_node) / static_cast<double>(samples.size())));
    ride_alone(measure, of_channels[c]);
    const double done = static_cast<double>(c) / static_cast<double>(channels.size());
    progress("modes of the strain", done);
    bases.push_back(channel_basis(std::exchange(of_channels[c], {}), measure, reflections));
    append(map.field, bases.back().field.transpose());
    wanted.push_back({rows[c], bases.back().points});
  }
  const std::array<std::size_t, 3> nodes{places.x.size(), places.y.size(), 1};
  const std::vector<std::vector<double>> fewer(
      samples.begin(),
      samples.begin() + static_cast<std::ptrdiff_t>(std::min(samples.size(), samples_at_node)));
  const bool mirror_places = are_mirrored(places, data);
  const std::vector<std::size_t> solved = nodes_to_solve(places, data, reflections);
  std::vector<std::vector<Matrix>> riding(channels.size());
  std::vector<std::vector<LeftAtPlace>> left(channels.size());
  for (std::size_t i = 0; i < solved.size(); ++i) {
    const std::array<double, 2> place{places.x[solved[i] % nodes[0]],
                                      places.y[solved[i] / nodes[0]]};
    std::vector<ChannelSamples> own =
        recovered(fewer, place, rows, recovery, projection, threads, [&](double fraction) {
          progress("strain at the positions",
                   (static_cast<double>(i) + fraction) / static_cast<double>(solved.size()));
        });
    measure.cell_area = areas_within(grid, place, extent, zones);
    for (std::size_t c = 0; c < channels.size(); ++c) {
      measure.levels = measure_of(c);
      riding[c].push_back(fit_at_place(bases[c], own[c], measure));
      const Matrix values = values_at(own[c], bases[c].points);
      own[c].fields -= (bases[c].field * (riding[c].back() * values)).cast<float>();
      left[c].push_back({values, on_fixed_cells(own[c].fields, grid, place, fixed)});
    }
  }
  for (std::size_t c = 0; c < channels.size(); ++c) {
    fixed_measure.levels = measure_of(c);
    const FixedModes fixed_own =
        fixed_modes(left[c], fixed_measure, fixed_size, reflections,
                    whole[c] * std::sqrt(static_cast<double>(solved.size())));
    append(maps[c].fixed_field, fixed_own.field.transpose());
    ChannelBasis& basis = bases[c];
    basis.parity.insert(basis.parity.end(), fixed_own.parity.begin(), fixed_own.parity.end());
    std::vector<std::vector<float>> fits(nodes[0] * nodes[1]);
    for (std::size_t i = 0; i < solved.size(); ++i) {
      Matrix fit(riding[c][i].rows() + fixed_own.fit[i].rows(), riding[c][i].cols());
      fit << riding[c][i], fixed_own.fit[i];
      if (mirror_places) {
        fit = of_own_images(fit, basis, solved[i], nodes, reflections);
      }
      for (std::size_t g = 0; g < (mirror_places ? reflections.count() : 1); ++g) {
        std::vector<float>& into = fits[reflections.image(g, solved[i], nodes)];
        if (into.empty()) {
          append(into, mirrored_fit(fit, basis, g, reflections));
        }
      }
    }
    maps[c].fit = place_map(places, fits, negligible_fit_mode);
  }
  add_unit_strains(*model, data, recovery, places, reflections, threads, wanted, maps);
  return maps;
}

} // namespace ionskin::live
