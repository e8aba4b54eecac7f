// SPDX-License-Identifier: Apache-2.0
#include "mechanics/rows.hpp"

namespace ionskin::verification {

std::vector<Row> verify_mechanics(const Options& options) {
  std::vector<Row> rows = patch_rows();
  for (const auto& more :
       {thin_layer_rows(), round_contact_rows(options), convergence_rows(options),
        contact_rows(options), motion_rows(options), path_rows(options), friction_rows(options),
        drive_rows(options), adhesion_rows(options), solid_rows(options), pose_rows(options),
        several_sliders_rows(options), rolling_rows(options)}) {
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

} // namespace ionskin::verification
