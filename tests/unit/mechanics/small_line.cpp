// SPDX-License-Identifier: Apache-2.0
#include "small_line.hpp"

#include "small_case.hpp"

namespace ionskin::mechanics {

SmallLine::SmallLine() : input(small_case()) {
  input.skin.length = 7.3e-3; // no place mirrors another
  model = std::make_shared<const SkinModel>(input, mesh::largest_footprint(input),
                                            MotionBox{{1.5e-3, 1e-3}, {3.5e-3, 1e-3}});
}

SlidingContact SmallLine::slider(const laws::Friction& friction) const {
  return {[compliance = ContactCompliance(*model)](const auto& place, auto& result) mutable {
            compliance.at(place, result);
          },
          model->cells.area, model->gap, friction};
}

const SmallLine& line() {
  static const SmallLine line;
  return line;
}

} // namespace ionskin::mechanics
