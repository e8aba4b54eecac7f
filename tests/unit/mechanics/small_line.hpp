// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/laws/friction/friction_law.hpp"
#include "ionskin/mechanics/engine/sliding_contact.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"

#include <memory>

namespace ionskin::mechanics {

/// The skin of the small case for a line of slider places.
struct SmallLine {
  Case input;
  std::shared_ptr<const SkinModel> model;

  SmallLine();
  SlidingContact slider(const laws::Friction& friction = laws::friction("coulomb", 0.3, {})) const;
};

/// Made once for all tests.
const SmallLine& line();

} // namespace ionskin::mechanics
