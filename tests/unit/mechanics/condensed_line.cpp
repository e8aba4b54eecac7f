// SPDX-License-Identifier: Apache-2.0
#include "condensed_line.hpp"

#include "small_case.hpp"

namespace ionskin::mechanics {

CondensedLine::CondensedLine() : input(small_case()) {
  input.skin.length = 7.3e-3; // no place mirrors another
  model = std::make_shared<const SkinModel>(input, mesh::largest_footprint(input));
  const base::ProgressCallback none = base::no_progress;
  parallel::SharedProgress progress("mechanics", none);
  nodes = std::make_unique<const PositionNodes>(
      input, model, MotionBox{{1.5e-3, 1e-3}, {3.5e-3, 1e-3}}, NodeOptions{.threads = 2}, progress);
}

SlidingContact CondensedLine::slider(const laws::Friction& friction) const {
  return {nodes->compliance(), model->cells.area, model->gap, friction};
}

const CondensedLine& line() {
  static const CondensedLine line;
  return line;
}

} // namespace ionskin::mechanics
