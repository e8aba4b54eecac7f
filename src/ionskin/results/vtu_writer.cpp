// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/vtu_writer.hpp"

#include "ionskin/base/files/atomic_file.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <zlib.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <new>
#include <ostream>
#include <string>
#include <vector>

namespace ionskin::results {
namespace {

using electrochemistry::IonSnapshot;
using electrochemistry::TransportGrid;

static_assert(std::endian::native == std::endian::little, "the files say so");

/// One <DataArray> of VTK's XML format, its values compressed in the appended part of the file
/// (VTK file formats, "XML file formats", https://docs.vtk.org).
struct DataArray {
  std::string attributes;
  std::string bytes; ///< compressed, with their header
};

template <class Value>
DataArray compressed(std::string attributes, const std::vector<Value>& values) {
  constexpr std::size_t block_bytes = 1 << 20;
  const auto* raw = reinterpret_cast<const unsigned char*>(values.data());
  const std::size_t size = values.size() * sizeof(Value);
  const std::size_t blocks = (size + block_bytes - 1) / block_bytes;
  std::vector<std::uint64_t> header{blocks, block_bytes, size % block_bytes};
  std::string body;
  std::vector<unsigned char> buffer(compressBound(block_bytes));
  for (std::size_t begin = 0; begin < size; begin += block_bytes) {
    uLongf length = buffer.size();
    // The best compression takes seconds for a few per cent.
    if (compress2(buffer.data(), &length, raw + begin, std::min(block_bytes, size - begin),
                  Z_BEST_SPEED) != Z_OK) {
      throw std::bad_alloc(); // nothing else can fail: the buffer takes any result
    }
    header.push_back(length);
    body.append(reinterpret_cast<const char*>(buffer.data()), length);
  }
  std::string bytes(reinterpret_cast<const char*>(header.data()), 8 * header.size());
  return {std::move(attributes), bytes + body};
}

std::string named(const char* type, const char* name, int components, const char* unit = "") {
  return fmt::format("type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"{}", type, name, components,
                     *unit == 0 ? std::string() : fmt::format(" unit=\"{}\"", unit));
}

/// The elements between the levels of each column. Values are constant over a column, so that
/// columns share no points: four at each level, anticlockwise.
class ColumnMesh {
public:
  ColumnMesh(const TransportGrid& grid, double core_bottom)
      : columns_((grid.x_edges.size() - 1) * (grid.y_edges.size() - 1)),
        levels_(grid.z_nodes.size()) {
    for (std::size_t y = 0; y + 1 < grid.y_edges.size(); ++y) {
      for (std::size_t x = 0; x + 1 < grid.x_edges.size(); ++x) {
        for (const double z : grid.z_nodes) {
          for (const auto [dx, dy] : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
            points_.insert(points_.end(),
                           {grid.x_edges[x + dx], grid.y_edges[y + dy], core_bottom + z});
          }
        }
      }
    }
  }

  std::size_t points() const { return points_.size() / 3; }
  std::size_t elements() const { return columns_ * (levels_ - 1); }
  const std::vector<double>& coordinates() const { return points_; }

  std::vector<std::int64_t> connectivity() const {
    std::vector<std::int64_t> result;
    result.reserve(8 * elements());
    for (std::size_t column = 0; column < columns_; ++column) {
      for (std::size_t level = 0; level + 1 < levels_; ++level) {
        for (std::size_t vertex = 0; vertex < 8; ++vertex) {
          result.push_back(static_cast<std::int64_t>(4 * (column * levels_ + level) + vertex));
        }
      }
    }
    return result;
  }
  std::vector<std::int64_t> offsets() const {
    std::vector<std::int64_t> result;
    for (std::size_t element = 1; element <= elements(); ++element) {
      result.push_back(static_cast<std::int64_t>(8 * element));
    }
    return result;
  }
  /// @param field [level][column]
  std::vector<float> at_points(const std::vector<double>& field) const {
    std::vector<float> result;
    result.reserve(points());
    for (std::size_t column = 0; column < columns_; ++column) {
      for (std::size_t level = 0; level < levels_; ++level) {
        result.insert(result.end(), 4, static_cast<float>(field[level * columns_ + column]));
      }
    }
    return result;
  }

private:
  std::size_t columns_, levels_;
  std::vector<double> points_; ///< x, y, z of each [m]
};

void write_group(std::ostream& out, const char* tag, const std::vector<DataArray>& arrays,
                 std::size_t& offset) {
  fmt::print(out, "<{}>\n", tag);
  for (const DataArray& array : arrays) {
    fmt::print(out, "<DataArray {} format=\"appended\" offset=\"{}\"/>\n", array.attributes,
               offset);
    offset += array.bytes.size();
  }
  fmt::print(out, "</{}>\n", tag);
}

void write_vtu(const std::filesystem::path& path, const ColumnMesh& mesh,
               const IonSnapshot& snapshot) {
  constexpr std::uint8_t vtk_hexahedron = 12;
  const std::vector<DataArray> time{
      compressed("type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\"",
                 std::vector<double>{snapshot.time})};
  const std::vector<DataArray> points{
      compressed(named("Float64", "Points", 3), mesh.coordinates())};
  const std::vector<DataArray> cells{
      compressed(named("Int64", "connectivity", 1), mesh.connectivity()),
      compressed(named("Int64", "offsets", 1), mesh.offsets()),
      compressed(named("UInt8", "types", 1),
                 std::vector<std::uint8_t>(mesh.elements(), vtk_hexahedron))};
  const std::vector<DataArray> fields{
      compressed(named("Float32", "concentration", 1, "mol/m3"),
                 mesh.at_points(snapshot.concentration)),
      compressed(named("Float32", "potential", 1, "V"), mesh.at_points(snapshot.potential)),
      compressed(named("Float32", "shear", 1, "1"), mesh.at_points(snapshot.shear))};
  base::AtomicFile file(path);
  std::ostream& out = file.stream();
  out << "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>\n";
  std::size_t offset = 0;
  write_group(out, "FieldData", time, offset);
  fmt::print(out, "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", mesh.points(),
             mesh.elements());
  write_group(out, "Points", points, offset);
  write_group(out, "Cells", cells, offset);
  write_group(out, "PointData", fields, offset);
  out << "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
  for (const auto* group : {&time, &points, &cells, &fields}) {
    for (const DataArray& array : *group) {
      out << array.bytes;
    }
  }
  out << "\n</AppendedData>\n</VTKFile>\n";
  file.commit();
}

} // namespace

void write_fields(OutputFolder& folder, const TransportGrid& grid, double core_bottom,
                  const std::vector<IonSnapshot>& snapshots) {
  const auto place = [&](const std::string& name) {
    return folder.own(std::string(file_names::fields) + "/" + name);
  };
  const ColumnMesh mesh(grid, core_bottom);
  std::string collection;
  for (std::size_t i = 0; i < snapshots.size(); ++i) {
    const std::string name = fmt::format("fields_{:04}.vtu", i);
    write_vtu(place(name), mesh, snapshots[i]);
    collection += fmt::format("<DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n",
                              snapshots[i].time, name);
  }
  base::AtomicFile file(place("fields.pvd"));
  file.stream() << "<?xml version=\"1.0\"?>\n"
                   "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
                   "<Collection>\n"
                << collection << "</Collection>\n</VTKFile>\n";
  file.commit();
}

} // namespace ionskin::results
