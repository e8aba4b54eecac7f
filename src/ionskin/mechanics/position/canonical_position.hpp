// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mechanics/surface/contact_cells.hpp"
#include "ionskin/mechanics/surface/contact_problem.hpp"

#include <array>

namespace ionskin::mechanics {

/// A slider position up to reflection of the rectangular skin: positions that are mirror images of
/// each other share one, and so share a factorisation.
struct CanonicalPosition {
  std::array<double, 2> centre{}; ///< x <= length / 2 and y <= width / 2 [m]
  std::array<bool, 2> reflect{};  ///< which coordinates were reflected to get there
};

CanonicalPosition canonical_position(const Skin& skin, const std::array<double, 2>& centre);

/// Whether two canonical places are one to rounding.
bool same_place(const Skin& skin, const std::array<double, 2>& a, const std::array<double, 2>& b);

/// A cell vector of the canonical position seen in the skin's own frame, and back.
CellVector reflected(const ContactCells& cells, const CellVector& vector,
                     const std::array<bool, 2>& reflect);

} // namespace ionskin::mechanics
