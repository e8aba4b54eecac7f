// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/rows.hpp"

namespace ionskin::verification {

std::vector<Row> verify_electrochemistry(const Options& options) {
  std::vector<Row> rows = identity_rows(options);
  for (const auto& more :
       {linear_step_rows(options), impedance_rows(), circuit_rows(options),
        double_layer_rows(options), manufactured_rows(options), lateral_average_rows(options),
        steric_rows(options), taxel_rows(options), crossbar_rows(options), sheet_rows(options),
        interface_rows(options), noise_rows(), error_estimate_rows(options)}) {
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

} // namespace ionskin::verification
