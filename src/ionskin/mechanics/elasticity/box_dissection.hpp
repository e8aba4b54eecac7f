// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::mechanics {

/// What stands on a face of a box of elements: unknowns like those inside, none, as it is held, or
/// unknowns that are eliminated after all others.
enum class BoxFace { open, held, later };

/// Elimination order of the nodes of a box of triquadratic elements by nested dissection (George
/// 1973, doi 10.1137/0710032): a plane of nodes between elements parts the box and comes after both
/// sides, which are dissected in turn. Of all ways to cut, the one of fewest operations, found by
/// dynamic programming over the boxes inside.
/// @param elements along x, y, z
/// @param faces across each axis, below and above
/// @return numbers of the nodes in the lattice of 2 elements + 1 places along each axis, x fastest,
/// without those on held and later faces
std::vector<int> dissection_order(const std::array<std::size_t, 3>& elements,
                                  const std::array<std::array<BoxFace, 2>, 3>& faces);

} // namespace ionskin::mechanics
