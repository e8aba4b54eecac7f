// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/vtu_writer.hpp"

#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/results/slider_surface.hpp"
#include "ionskin/results/vtu_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace ionskin::results {
namespace {

constexpr const char* core_prefix = "fields";
constexpr const char* layers_prefix = "layers";
constexpr const char* contact_prefix = "contact";
constexpr const char* slider_prefix = "slider";

std::string name_of(const std::string& prefix, std::size_t instant) {
  return fmt::format("{}_{:04}.vtu", prefix, instant);
}

std::string in_folder(const std::string& name) {
  return std::string(file_names::fields) + "/" + name;
}

/// Grid of the core with separate points for each lateral column, four at each z level: values are
/// constant over a column, so neighbouring columns cannot share points.
VtuGrid column_grid(const electrochemistry::TransportGrid& grid, double core_bottom) {
  VtuGrid result;
  const auto levels = static_cast<std::int64_t>(grid.z_nodes.size());
  std::int64_t column = 0;
  for (std::size_t y = 0; y + 1 < grid.y_edges.size(); ++y) {
    for (std::size_t x = 0; x + 1 < grid.x_edges.size(); ++x, ++column) {
      for (const double z : grid.z_nodes) {
        for (const auto [dx, dy] : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
          result.points.insert(result.points.end(),
                               {grid.x_edges[x + dx], grid.y_edges[y + dy], core_bottom + z});
        }
      }
      for (std::int64_t level = 0; level + 1 < levels; ++level) {
        for (std::int64_t vertex = 0; vertex < 8; ++vertex) {
          result.vertices.push_back(4 * (column * levels + level) + vertex);
        }
      }
    }
  }
  return result;
}

/// Values at the points of `column_grid`, four equal ones per node.
/// @param field values at the nodes [level][column]
std::vector<float> at_column_points(const std::vector<double>& field, std::size_t levels) {
  const std::size_t columns = field.size() / levels;
  std::vector<float> result;
  result.reserve(4 * field.size());
  for (std::size_t column = 0; column < columns; ++column) {
    for (std::size_t level = 0; level < levels; ++level) {
      result.insert(result.end(), 4, static_cast<float>(field[level * columns + column]));
    }
  }
  return result;
}

/// Array with several components, [point or cell][component].
/// @param values one vector per component
template <std::size_t count>
VtuArray interleaved(std::string name, std::string unit, std::vector<std::string> components,
                     const std::array<const std::vector<double>*, count>& values) {
  VtuArray result{std::move(name), std::move(unit), std::move(components), {}};
  result.values.reserve(count * values[0]->size());
  for (std::size_t i = 0; i < values[0]->size(); ++i) {
    for (const std::vector<double>* component : values) {
      result.values.push_back(static_cast<float>((*component)[i]));
    }
  }
  return result;
}

VtuArray vectors(const char* name, const char* unit,
                 const std::array<std::vector<double>, 3>& values) {
  return interleaved<3>(name, unit, {"x", "y", "z"}, {&values[0], &values[1], &values[2]});
}

/// Von Mises stress [Pa].
/// @param stress components xx, yy, zz, yz, xz, xy, each per cell [Pa]
VtuArray von_mises(const std::array<std::vector<double>, 6>& stress) {
  VtuArray result{"von_mises_stress", "Pa", {}, {}};
  for (std::size_t i = 0; i < stress[0].size(); ++i) {
    const double xx = stress[0][i], yy = stress[1][i], zz = stress[2][i];
    const double shear =
        stress[3][i] * stress[3][i] + stress[4][i] * stress[4][i] + stress[5][i] * stress[5][i];
    result.values.push_back(static_cast<float>(
        std::sqrt(0.5 * ((xx - yy) * (xx - yy) + (yy - zz) * (yy - zz) + (zz - xx) * (zz - xx)) +
                  3 * shear)));
  }
  return result;
}

VtuGrid layers_of(const handover::SkinDeformation& skin) {
  VtuGrid grid = VtuGrid::between(skin.x, skin.y, skin.z);
  grid.at_points.push_back(vectors("displacement", "m", skin.displacement));
  VtuArray layer{"layer", "1", {}, {}};
  for (const std::size_t own : skin.layer) {
    layer.values.insert(layer.values.end(), (skin.x.size() - 1) * (skin.y.size() - 1),
                        static_cast<float>(own));
  }
  const auto& s = skin.stress; // VTK has xy before yz and xz
  grid.at_cells = {std::move(layer),
                   interleaved<6>("stress", "Pa", {"XX", "YY", "ZZ", "XY", "YZ", "XZ"},
                                  {&s[0], &s[1], &s[2], &s[5], &s[3], &s[4]}),
                   von_mises(s)};
  return grid;
}

VtuGrid contact_of(const SkinSnapshot& snapshot) {
  const std::vector<double>&x = snapshot.cell_x, &y = snapshot.cell_y;
  VtuGrid grid =
      VtuGrid::surface(x, y, std::vector<double>(x.size() * y.size(), snapshot.skin.z.back()));
  VtuArray pressure{"pressure", "Pa", {}, {}};
  for (const double upwards : snapshot.traction[2]) {
    pressure.values.push_back(static_cast<float>(-upwards));
  }
  grid.at_cells = {vectors("traction", "Pa", snapshot.traction), std::move(pressure),
                   vectors("displacement", "m", snapshot.surface)};
  return grid;
}

std::vector<double> shifted(std::vector<double> places, double by) {
  std::ranges::for_each(places, [by](double& place) { place += by; });
  return places;
}

/// Surface of the slider's underside. Cells of the plan that the underside does not reach are left
/// out, such as the corners around a ball.
VtuGrid slider_of(const SkinSnapshot& snapshot, const SliderSurface& surface) {
  const auto beyond = [](double height) { return height >= shapes::unreachable_gap; };
  double highest = 0;
  for (const double height : surface.height) {
    highest = beyond(height) ? highest : std::max(highest, height);
  }
  std::vector<double> z = surface.height;
  for (double& height : z) {
    height = snapshot.skin.z.back() + snapshot.height + std::min(height, highest);
  }
  VtuGrid grid = VtuGrid::surface(shifted(surface.x, snapshot.centre[0]),
                                  shifted(surface.y, snapshot.centre[1]), z);
  std::vector<std::int64_t> vertices;
  for (auto cell = grid.vertices.begin(); cell != grid.vertices.end(); cell += 4) {
    if (std::none_of(cell, cell + 4, [&](std::int64_t at) {
          return beyond(surface.height[static_cast<std::size_t>(at)]);
        })) {
      vertices.insert(vertices.end(), cell, cell + 4);
    }
  }
  grid.vertices = std::move(vertices);
  return grid;
}

} // namespace

void write_fields(OutputFolder& folder, const electrochemistry::TransportGrid& grid,
                  double core_bottom, const std::vector<electrochemistry::IonSnapshot>& snapshots) {
  VtuGrid columns = column_grid(grid, core_bottom);
  const auto array = [&](const char* name, const char* unit, const std::vector<double>& field) {
    return VtuArray{name, unit, {}, at_column_points(field, grid.z_nodes.size())};
  };
  for (std::size_t i = 0; i < snapshots.size(); ++i) {
    const electrochemistry::IonSnapshot& own = snapshots[i];
    columns.at_points = {array("concentration", "mol/m3", own.concentration),
                         array("potential", "V", own.potential), array("shear", "1", own.shear)};
    write_vtu(folder.own(in_folder(name_of(core_prefix, i))), own.time, columns);
  }
}

void write_skin(OutputFolder& folder, const Slider& slider, const std::string& suffix,
                std::size_t instant, const SkinSnapshot& snapshot) {
  const auto write = [&](const char* prefix, const VtuGrid& grid) {
    write_vtu(folder.own(in_folder(name_of(prefix + suffix, instant))), snapshot.time, grid);
  };
  write(layers_prefix, layers_of(snapshot.skin));
  write(contact_prefix, contact_of(snapshot));
  // Samples at the edges of the contact cells resolve the contact under a much larger slider.
  write(slider_prefix,
        slider_of(snapshot, slider_surface(slider, shifted(snapshot.cell_x, -snapshot.centre[0]),
                                           shifted(snapshot.cell_y, -snapshot.centre[1]))));
}

void write_collection(OutputFolder& folder, const std::vector<double>& instants,
                      const std::vector<std::string>& suffixes) {
  std::vector<std::string> prefixes{core_prefix};
  for (const std::string& suffix : suffixes) {
    for (const char* prefix : {layers_prefix, contact_prefix, slider_prefix}) {
      prefixes.push_back(prefix + suffix);
    }
  }
  std::string collection;
  for (std::size_t i = 0; i < instants.size(); ++i) {
    int part = 0;
    for (const std::string& prefix : prefixes) {
      const std::string name = name_of(prefix, i);
      if (std::filesystem::exists(folder.file(in_folder(name)))) {
        collection += fmt::format(
            "<DataSet timestep=\"{}\" group=\"\" part=\"{}\" name=\"{}\" file=\"{}\"/>\n",
            instants[i], part, prefix == core_prefix ? "core" : prefix, name);
      }
      ++part;
    }
  }
  if (collection.empty()) {
    return;
  }
  base::AtomicFile file(folder.own(in_folder("fields.pvd")));
  file.stream() << "<?xml version=\"1.0\"?>\n"
                   "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
                   "<Collection>\n"
                << collection << "</Collection>\n</VTKFile>\n";
  file.commit();
}

} // namespace ionskin::results
