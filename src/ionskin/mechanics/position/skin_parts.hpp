// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/linear_algebra/cholesky.hpp"
#include "ionskin/mechanics/elasticity/elastic_law.hpp"
#include "ionskin/mechanics/elasticity/elastic_space.hpp"
#include "ionskin/mechanics/surface/contact_cells.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace ionskin::mechanics {

/// Where the skin is cut across one axis, before and behind the footprint: what lies between rides
/// with the slider unchanged.
struct SkinCut {
  std::size_t axis = 0;
  std::array<std::size_t, 2> footprint{}; ///< first and one-past-last element along the axis
};

/// A box of the skin's elements with its own numbering. The unknowns that it shares with other
/// parts, the interface, are eliminated last.
struct SkinPart {
  ElasticSpace space;
  linear_algebra::SymbolicCholesky symbolic;
  int interface = 0; ///< unknowns in it, the last of the elimination order

  /// @param interface_nodes in the part's numbering
  SkinPart(ElasticSpace part_space, const std::vector<int>& interface_nodes);
};

/// Where a part lies in the skin. The outer parts are mirror images of each other: one numbering
/// serves both.
struct PlacedPart {
  std::shared_ptr<const SkinPart> part;
  std::size_t first = 0, last = 0; ///< elements along the axis of the cut
  bool mirrored = false;
  int first_interface = 0;        ///< of its interface unknowns among those of the skin
  std::vector<int> whole_unknown; ///< of each unknown in the part's elimination order
  std::vector<double> sign;       ///< likewise: -1 where the mirror turns it
};

/// Where the value of one of the skin's unknowns stands: in a part, the inner one before the outer
/// ones, at a place of its elimination order.
struct PartUnknown {
  int part = 0, place = 0;
  double sign = 1; ///< -1 where the mirror turns it
};

/// The skin cut into a part that holds the footprint and those before and behind it.
struct SkinParts {
  SkinCut cut;
  int interface = 0;             ///< unknowns in which the parts meet
  std::vector<PlacedPart> outer; ///< none where the footprint ends with the skin
  PlacedPart inner;
  /// Of each row of `ContactCells::unit_load` in the elimination order of the inner part.
  std::vector<int> load_place;
  std::vector<PartUnknown> unknown; ///< of the skin

  /// @param whole numbering of the skin
  /// @param threads that analyse parts side by side
  SkinParts(const ElasticSpace& whole, const mesh::MeshLines& any_lines,
            const std::vector<FixedFace>& fixed, const ContactCells& cells, const SkinCut& skin_cut,
            int threads = 1);
  /// Lines of the inner part: the same bits wherever the slider is.
  mesh::MeshLines inner_lines(const ContactCells& cells, const mesh::MeshLines& whole) const;
  mesh::MeshLines outer_lines(const PlacedPart& placed, const mesh::MeshLines& whole) const;
};

} // namespace ionskin::mechanics
