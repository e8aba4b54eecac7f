// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/vtu_file.hpp"

#include "ionskin/base/files/atomic_file.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <new>
#include <ostream>
#include <utility>

namespace ionskin::results {
namespace {

static_assert(std::endian::native == std::endian::little, "the files say so");

/// One <DataArray> element of VTK's XML format, with its values compressed for the appended part of
/// the file (VTK file formats, "XML file formats", https://docs.vtk.org).
struct DataArray {
  std::string attributes;
  std::string bytes; ///< compressed values behind their header
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
    // The best compression would take seconds longer and save only a few per cent.
    if (compress2(buffer.data(), &length, raw + begin, std::min(block_bytes, size - begin),
                  Z_BEST_SPEED) != Z_OK) {
      throw std::bad_alloc(); // the only possible failure: the buffer is large enough
    }
    header.push_back(length);
    body.append(reinterpret_cast<const char*>(buffer.data()), length);
  }
  std::string bytes(reinterpret_cast<const char*>(header.data()), 8 * header.size());
  return {std::move(attributes), bytes + body};
}

std::string attributes(const char* type, const VtuArray& array) {
  std::string text = fmt::format("type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"", type,
                                 array.name, std::max<std::size_t>(1, array.components.size()));
  for (std::size_t i = 0; i < array.components.size(); ++i) {
    text += fmt::format(" ComponentName{}=\"{}\"", i, array.components[i]);
  }
  return array.unit.empty() ? text : text + fmt::format(" unit=\"{}\"", array.unit);
}

template <class Value>
DataArray geometry(const char* type, const char* name, std::vector<std::string> components,
                   const std::vector<Value>& values) {
  return compressed(attributes(type, {name, "", std::move(components), {}}), values);
}

std::vector<DataArray> fields(const std::vector<VtuArray>& arrays) {
  std::vector<DataArray> result;
  for (const VtuArray& array : arrays) {
    result.push_back(compressed(attributes("Float32", array), array.values));
  }
  return result;
}

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

} // namespace

VtuGrid VtuGrid::between(const std::vector<double>& x, const std::vector<double>& y,
                         const std::vector<double>& z) {
  VtuGrid grid;
  for (const double height : z) {
    for (const double row : y) {
      for (const double column : x) {
        grid.points.insert(grid.points.end(), {column, row, height});
      }
    }
  }
  const auto nx = static_cast<std::int64_t>(x.size()), ny = static_cast<std::int64_t>(y.size());
  for (std::int64_t k = 0; k + 1 < static_cast<std::int64_t>(z.size()); ++k) {
    for (std::int64_t j = 0; j + 1 < ny; ++j) {
      for (std::int64_t i = 0; i + 1 < nx; ++i) {
        for (const std::int64_t level : {k, k + 1}) {
          const std::int64_t corner = i + nx * (j + ny * level);
          grid.vertices.insert(grid.vertices.end(),
                               {corner, corner + 1, corner + 1 + nx, corner + nx});
        }
      }
    }
  }
  return grid;
}

VtuGrid VtuGrid::surface(const std::vector<double>& x, const std::vector<double>& y,
                         const std::vector<double>& heights) {
  VtuGrid grid{Cell::quadrilateral, {}, {}, {}, {}};
  const auto nx = static_cast<std::int64_t>(x.size());
  for (std::size_t j = 0; j < y.size(); ++j) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      grid.points.insert(grid.points.end(), {x[i], y[j], heights[i + x.size() * j]});
      const std::int64_t corner = static_cast<std::int64_t>(i) + nx * static_cast<std::int64_t>(j);
      if (i + 1 < x.size() && j + 1 < y.size()) {
        grid.vertices.insert(grid.vertices.end(),
                             {corner, corner + 1, corner + 1 + nx, corner + nx});
      }
    }
  }
  return grid;
}

void write_vtu(const std::filesystem::path& path, double time, const VtuGrid& grid) {
  const std::size_t corners = grid.cell == VtuGrid::Cell::hexahedron ? 8 : 4,
                    cells = grid.vertices.size() / corners;
  std::vector<std::int64_t> ends;
  for (std::size_t cell = 1; cell <= cells; ++cell) {
    ends.push_back(static_cast<std::int64_t>(corners * cell));
  }
  const std::vector<DataArray> instant{compressed(
      "type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\"", std::vector<double>{time})};
  const std::vector<DataArray> points{geometry("Float64", "Points", {"x", "y", "z"}, grid.points)};
  const std::vector<DataArray> topology{
      geometry("Int64", "connectivity", {}, grid.vertices), geometry("Int64", "offsets", {}, ends),
      geometry("UInt8", "types", {},
               std::vector<std::uint8_t>(cells, static_cast<std::uint8_t>(grid.cell)))};
  const std::vector<DataArray> at_points = fields(grid.at_points), at_cells = fields(grid.at_cells);
  base::AtomicFile file(path);
  std::ostream& out = file.stream();
  out << "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>\n";
  std::size_t offset = 0;
  write_group(out, "FieldData", instant, offset);
  fmt::print(out, "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", grid.points.size() / 3,
             cells);
  write_group(out, "Points", points, offset);
  write_group(out, "Cells", topology, offset);
  write_group(out, "PointData", at_points, offset);
  write_group(out, "CellData", at_cells, offset);
  out << "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
  for (const auto* group : {&instant, &points, &topology, &at_points, &at_cells}) {
    for (const DataArray& array : *group) {
      out << array.bytes;
    }
  }
  out << "\n</AppendedData>\n</VTKFile>\n";
  file.commit();
}

} // namespace ionskin::results
