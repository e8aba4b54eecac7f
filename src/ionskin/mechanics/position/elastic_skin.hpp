// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mechanics/elasticity/elastic_law.hpp"
#include "ionskin/mechanics/elasticity/elastic_space.hpp"
#include "ionskin/mechanics/position/skin_parts.hpp"
#include "ionskin/mechanics/surface/contact_cells.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <semaphore>
#include <vector>

namespace ionskin::mechanics {

struct InnerFactor;

/// The factor of the inner part at some lines across the cut, made by the first that needs it.
class SharedInner {
public:
  /// True for the first caller alone, who goes on to make it.
  bool begin() { return !begun_.exchange(true); }
  /// Waits while another thread makes it.
  template <class Make> std::shared_ptr<const InnerFactor> get(const Make& make) {
    std::call_once(made_, [&] { factor_ = make(); });
    return factor_;
  }

private:
  std::atomic<bool> begun_{false};
  std::once_flag made_;
  std::shared_ptr<const InnerFactor> factor_;
};

/// The symbolic factorisation of the parts of a skin, and how many positions the memory holds the
/// factors of. Thread-safe.
struct SkinAnalysis {
  SkinParts parts;
  std::ptrdiff_t factors_at_once;
  mutable std::counting_semaphore<> free_factors;

  explicit SkinAnalysis(SkinParts skin_parts);
  /// At lines of the inner part; those of the latest lines are kept.
  std::shared_ptr<SharedInner> inner(const mesh::MeshLines& lines) const;
  /// Frees the kept ones; the next position makes them again.
  void forget_inner() const;

private:
  struct Latest {
    mesh::MeshLines lines;
    std::shared_ptr<SharedInner> inner;
  };
  mutable std::mutex mutex_;
  mutable Latest latest_;
};

/// What the positions of a slider share: numbering, boundary conditions, elastic laws, contact
/// cells, the parts of the skin. Independent of the places of the mesh lines. Thread-safe.
struct ElasticSkin {
  std::vector<FixedFace> fixed;
  ElasticSpace space;                    ///< numbering alone: stiffness is assembled by parts
  std::vector<ElasticLaw> law_of_row;    ///< per element row along z
  std::vector<std::size_t> layer_of_row; ///< index of the layer, per element row along z
  std::array<std::size_t, 2> core_z{};   ///< first and one-past-last element row of the core
  ContactCells cells;
  SkinCut cut;

  ElasticSkin(const Case& input, const mesh::SkinMesh& mesh);
  /// Made at the first call: positions that come from a cache need none.
  /// @param threads of the first call, for which others wait
  const SkinAnalysis& analysis(int threads = 1) const;
  /// Frees what positions share of their factors, while none is made.
  void forget_factors() const;

private:
  mesh::MeshLines any_lines_; ///< of which the number counts
  mutable std::once_flag analysed_;
  mutable std::unique_ptr<const SkinAnalysis> analysis_;
};

} // namespace ionskin::mechanics
