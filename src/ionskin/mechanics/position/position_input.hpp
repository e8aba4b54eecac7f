// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/digest.hpp"
#include "ionskin/mechanics/elasticity/elastic_law.hpp"
#include "ionskin/mechanics/elasticity/elastic_space.hpp"
#include "ionskin/mechanics/position/elastic_skin.hpp"
#include "ionskin/mechanics/surface/contact_cells.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace ionskin::mechanics {

/// All that a condensed position needs, as values: it can be solved elsewhere, to the same bits by
/// the same kernels of BLAS. What it gives is a `StoredPosition`.
struct PositionInput {
  mesh::MeshLines lines; ///< with the slider at its place [m]
  std::vector<FixedFace> fixed;
  std::vector<ElasticLaw> law_of_row;    ///< per element row along z [Pa]
  std::vector<std::size_t> layer_of_row; ///< index of the layer, per element row along z
  std::array<std::size_t, 2> core_z{};   ///< first and one-past-last element row of the core
  ContactCells cells;
  SkinCut cut; ///< into parts that are factorised by themselves
};

/// @param lines of the skin's mesh with the slider at its place [m]
PositionInput position_input(const ElasticSkin& skin, const mesh::MeshLines& lines);

/// The input bit by bit, every list behind its length.
std::vector<std::byte> position_input_bytes(const PositionInput& input);

/// Digest of the input at these lines, the kernels of BLAS and the version of the numerical method:
/// positions of the same key are the same to the last bit.
base::Digest position_key(const ElasticSkin& skin, const mesh::MeshLines& lines);

/// Writes an input to a file. Throws UnwritableFile.
void write_position_input(const std::filesystem::path& path, const PositionInput& input);
/// Nothing where there is no such file, or a damaged one.
std::optional<PositionInput> read_position_input(const std::filesystem::path& path);

} // namespace ionskin::mechanics
