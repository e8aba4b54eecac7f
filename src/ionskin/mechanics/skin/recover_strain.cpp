// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/skin/recover_strain.hpp"

namespace ionskin::mechanics {

RecoveredStrain recover_strain(const SkinModel& model, const std::array<double, 2>& centre,
                               const CellVector&) {
  const mesh::MeshLines lines = model.mesh.lines(centre);
  const auto core = model.mesh.core_z();
  RecoveredStrain r;
  r.core.points = {2 * (lines.x.size() - 1), 2 * (lines.y.size() - 1), 2 * (core[1] - core[0])};
  r.core.component.fill(
      std::vector<double>(r.core.points[0] * r.core.points[1] * r.core.points[2]));
  return r;
}

} // namespace ionskin::mechanics
