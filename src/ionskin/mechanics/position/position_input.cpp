// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/position_input.hpp"

#include "ionskin/base/byte_record.hpp"
#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/base/files/cache_file.hpp"
#include "ionskin/linear_algebra/dense_kernels.hpp"

#include <cstdint>
#include <span>
#include <string>

namespace ionskin::mechanics {
namespace {

/// To be raised whenever the numbers of a condensed position change for the same input:
/// elements, assembly, lattice, rounding, or the layout of what it gives.
constexpr std::uint32_t numerical_version = 7;

/// Of files of inputs.
base::Digest file_key() {
  return base::DigestBuilder().add("input of a position").add(numerical_version).finish();
}

/// Adds an input to bytes or to a digest. What positions share is an `ElasticSkin` or an input.
template <class Sink, class Shared>
void add_input(Sink& sink, const mesh::MeshLines& lines, const Shared& shared) {
  sink.add(lines.x).add(lines.y).add(lines.z).add(std::uint64_t{shared.fixed.size()});
  for (const FixedFace& face : shared.fixed) {
    sink.add(face.name).add(face.face);
    for (const bool held : face.component) {
      sink.add(held);
    }
  }
  sink.add(std::uint64_t{shared.law_of_row.size()});
  for (const ElasticLaw& law : shared.law_of_row) {
    sink.add(law.lame_lambda).add(law.shear_modulus);
  }
  sink.add(shared.layer_of_row).add(shared.core_z[0]).add(shared.core_z[1]);
  const ContactCells& cells = shared.cells;
  sink.add(cells.lines_x).add(cells.lines_y).add(cells.area).add(cells.nodes);
  const linear_algebra::DenseMatrix& load = cells.unit_load;
  sink.add(load.rows).add(load.columns).add(load.values);
  sink.add(shared.cut.axis).add(shared.cut.footprint[0]).add(shared.cut.footprint[1]);
}

std::optional<PositionInput> input_of(std::span<const std::byte> bytes) {
  base::ByteReader reader(bytes);
  PositionInput input;
  std::uint64_t faces = 0;
  bool whole = reader.take(input.lines.x) && reader.take(input.lines.y) &&
               reader.take(input.lines.z) && reader.take(faces);
  for (std::uint64_t i = 0; whole && i < faces; ++i) {
    FixedFace& face = input.fixed.emplace_back();
    whole = reader.take(face.name) && reader.take(face.face) && reader.take(face.component);
  }
  ContactCells& cells = input.cells;
  whole = whole && reader.take(input.law_of_row) && reader.take(input.layer_of_row) &&
          reader.take(input.core_z) && reader.take(cells.lines_x) && reader.take(cells.lines_y) &&
          reader.take(cells.area) && reader.take(cells.nodes) &&
          reader.take(cells.unit_load.rows) && reader.take(cells.unit_load.columns) &&
          reader.take(cells.unit_load.values) && reader.take(input.cut.axis) &&
          reader.take(input.cut.footprint) && reader.at_end();
  return whole ? std::optional(std::move(input)) : std::nullopt;
}

} // namespace

PositionInput position_input(const ElasticSkin& skin, const mesh::MeshLines& lines) {
  return {lines, skin.fixed, skin.law_of_row, skin.layer_of_row, skin.core_z, skin.cells, skin.cut};
}

std::vector<std::byte> position_input_bytes(const PositionInput& input) {
  base::ByteWriter writer;
  add_input(writer, input.lines, input);
  return writer.take();
}

base::Digest position_key(const ElasticSkin& skin, const mesh::MeshLines& lines) {
  base::DigestBuilder builder;
  builder.add("condensed position").add(numerical_version).add(linear_algebra::kernel_name());
  add_input(builder, lines, skin);
  return builder.finish();
}

void write_position_input(const std::filesystem::path& path, const PositionInput& input) {
  const std::vector<std::byte> bytes = position_input_bytes(input);
  if (std::string error = base::write_cache_file(path, file_key(), {bytes}); !error.empty()) {
    throw base::UnwritableFile(path, std::move(error));
  }
}

std::optional<PositionInput> read_position_input(const std::filesystem::path& path) {
  const base::CacheFileContent file = base::read_cache_file(path, file_key());
  return file.state == base::CacheFileState::whole ? input_of(file.content) : std::nullopt;
}

} // namespace ionskin::mechanics
