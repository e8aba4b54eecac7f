// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verification_table.hpp"

#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"

#include <vector>

namespace ionskin::verification {

/// Case that the rows of the chain check, with its solution of Study 1: the baseline skin at the
/// coarse preset, with its ions and one cycle of motion.
struct Chain {
  Case input;
  mechanics::ContactSolution contact;
  history::CoreHistory history;
};

/// Row set C3: steady sliding sampled at positions of the slider between interpolation nodes, and
/// smoothness of the shear's integral on the transport grid.
std::vector<Row> smooth_sliding_rows(const Chain& chain, const Options& options);
/// Row set C4: charge jumps of touchdown and lift-off against the two averages of the shear that
/// predict them.
std::vector<Row> spike_rows(const Chain& chain, const Options& options);

} // namespace ionskin::verification
