// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/laws/friction/friction_law.hpp"
#include "ionskin/mechanics/engine/position_nodes.hpp"
#include "ionskin/mechanics/engine/sliding_contact.hpp"

#include <memory>

namespace ionskin::mechanics {

/// The skin of the small case condensed for a line of slider positions.
struct CondensedLine {
  Case input;
  std::shared_ptr<const SkinModel> model;
  std::unique_ptr<const PositionNodes> nodes;

  CondensedLine();
  SlidingContact slider(const laws::Friction& friction = laws::friction("coulomb", 0.3, {})) const;
};

/// Made once for all tests.
const CondensedLine& line();

} // namespace ionskin::mechanics
