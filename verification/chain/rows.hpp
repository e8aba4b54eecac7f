// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verification_table.hpp"

#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"

#include <vector>

namespace ionskin::verification {

/// The baseline at the coarse preset with its ions: what the chain's rows are taken from.
struct Chain {
  Case input;
  mechanics::ContactSolution contact;
  history::CoreHistory history;
};

/// C3: steady sliding at positions that are not interpolation nodes, and its smoothness on the
/// transport grid.
std::vector<Row> smooth_sliding_rows(const Chain& chain, const Options& options);
/// C4: charge jumps of touchdown and lift-off against the scalars that predict them.
std::vector<Row> spike_rows(const Chain& chain, const Options& options);

} // namespace ionskin::verification
