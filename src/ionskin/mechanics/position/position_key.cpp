// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/position_key.hpp"

#include "ionskin/linear_algebra/dense_kernels.hpp"

#include <cstdint>

namespace ionskin::mechanics {
namespace {

/// To be raised whenever the numbers of a condensed position change for the same input:
/// elements, assembly, lattice, rounding, or the layout of what it gives.
constexpr std::uint32_t numerical_version = 7;

} // namespace

base::Digest position_key(const ElasticSkin& skin, const mesh::MeshLines& lines) {
  base::DigestBuilder key;
  key.add("condensed position").add(numerical_version).add(linear_algebra::kernel_name());
  // Every list behind its length.
  key.add(lines.x).add(lines.y).add(lines.z).add(std::uint64_t{skin.fixed.size()});
  for (const FixedFace& face : skin.fixed) {
    key.add(face.name).add(face.face);
    for (const bool held : face.component) {
      key.add(held);
    }
  }
  key.add(std::uint64_t{skin.law_of_row.size()});
  for (const ElasticLaw& law : skin.law_of_row) {
    key.add(law.lame_lambda).add(law.shear_modulus);
  }
  key.add(skin.layer_of_row).add(skin.core_z[0]).add(skin.core_z[1]);
  const ContactCells& cells = skin.cells;
  key.add(cells.lines_x).add(cells.lines_y).add(cells.area).add(cells.nodes);
  const linear_algebra::DenseMatrix& load = cells.unit_load;
  key.add(load.rows).add(load.columns).add(load.values);
  key.add(skin.cut.axis).add(skin.cut.footprint[0]).add(skin.cut.footprint[1]);
  return key.finish();
}

} // namespace ionskin::mechanics
