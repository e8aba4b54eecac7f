// SPDX-License-Identifier: Apache-2.0
#include "poroelasticity/rows.hpp"

namespace ionskin::verification {

std::vector<Row> verify_poroelasticity(const Options& options) {
  std::vector<Row> rows = consolidation_rows();
  for (const auto& more :
       {pressure_step_rows(options), lateral_wave_rows(options), symmetry_rows(options),
        prescribed_load_rows(options), saxen_rows(options), thin_double_layer_rows(options),
        wall_rows(options), relaxation_rows(options)}) {
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

} // namespace ionskin::verification
