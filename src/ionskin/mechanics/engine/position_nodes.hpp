// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/files/disk_cache.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/engine/compliance_map.hpp"
#include "ionskin/mechanics/engine/path_response.hpp"
#include "ionskin/mechanics/position/canonical_position.hpp"
#include "ionskin/mechanics/position/condensed_position.hpp"
#include "ionskin/parallel/shared_progress.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace ionskin::mechanics {

/// The smallest rectangle that holds the slider's centre while it touches, or the case's shared one
/// [m]; empty when it never touches. That of a slider on a drive may turn out to be wider.
std::optional<MotionBox> contact_box(const Case& input);

/// Nodes that a rectangle is expected to need along x and y.
std::array<std::size_t, 2> expected_counts(const Case& input, const MotionBox& box);

/// Places that these nodes factorise: those that mirror each other are one.
std::size_t expected_places(const Case& input, const MotionBox& box);

/// Coordinates of the nodes along x and y [m].
NodeLines node_lines(const Case& input, const MotionBox& box,
                     const std::array<std::size_t, 2>& counts);

/// Of the strain between the nodes over its largest norm: the `interpolation_tolerance` of a line
/// or a rectangle.
double node_tolerance(const Case& input, const MotionBox& box);

/// How the nodes are solved.
struct NodeOptions {
  int threads = 1;
  base::DiskCache* cache = nullptr; ///< of condensed positions; none when null
  std::size_t count = 0;            ///< of lines each way; 0 for as many as keep the tolerance
  /// Of nodes along one line: forces across it act near its ends alone, see `loads_across_at_ends`.
  bool across_at_ends = false;
  /// Positions whose responses have room, all of them or none; 0 for those that the rectangle is
  /// expected to need.
  std::size_t positions = 0;
};

/// Whether the slider lands, rests, turns and leaves at the ends of one line alone and slides from
/// end to end under a held level. Cells that stick also pull across the line; once all slip their
/// way, none does. The response to such forces, a third of a position's work and memory, is then
/// made at both ends and taken as linear between them.
bool loads_across_at_ends(const Case& input, const MotionBox& box);

/// The skin condensed at the nodes of a rectangle of slider positions, and what it does in between.
/// As many lines along x and along y as the polynomials through them need: the strain under a test
/// load is interpolated to `node_tolerance`. Places that mirror each other in the skin's
/// middle are factorised once. Positions that hold a factor are not kept but made again.
class PositionNodes {
public:
  /// Throws Interrupted on request.
  PositionNodes(const Case& input, std::shared_ptr<const SkinModel> model, const MotionBox& box,
                const NodeOptions& options, parallel::SharedProgress& progress);

  const SkinModel& model() const { return *model_; }
  /// Not to be asked for once it is forgotten.
  const ComplianceMap& compliance() const { return *compliance_; }
  /// Frees it once all contacts are solved: the recovery of strains does without.
  void forget_compliance() { compliance_.reset(); }
  std::size_t count() const { return lines_.at[0].size() * lines_.at[1].size(); }
  /// Whether `solve` factorises again, as the responses to all unit forces do not fit.
  bool holds_factors() const { return !places_.front().condensed; }
  /// Estimated error of the strain between the nodes over its largest norm.
  double error() const { return error_; }

  /// Load patterns of successive states of a path at any places in the rectangle, not yet solved.
  /// @param forces of the cells, of each state
  PathResponse patterns(std::span<const std::array<double, 2>> places,
                        std::span<const CellVector> forces) const;
  /// Solves the patterns of paths together: positions that hold a factor are made once for all of
  /// them. Each path is the same bits as alone.
  /// @param finished called after each position
  void solve(
      const std::vector<PathResponse*>& paths, const std::function<void()>& finished = [] {}) const;
  /// Both at once.
  std::vector<StateResponse> respond(const std::vector<std::array<double, 2>>& places,
                                     const std::vector<CellVector>& forces) const;
  /// Positions that `solve` goes through.
  std::size_t places() const { return places_.size(); }
  int threads() const { return options_.threads; }

private:
  struct Node {
    CanonicalPosition position;
    std::size_t condensed = 0; ///< index
  };
  using Condensed = std::shared_ptr<const CondensedPosition>;
  /// Of the nodes at a place, for forces along the line, or any, and for those across it.
  struct Weights {
    std::vector<double> along, across;
  };

  void condense(const NodeLines& lines, parallel::SharedProgress& progress);
  Condensed condensed_at(std::size_t index, parallel::SpareThreads& spare) const;
  /// Of the strain under the test load along each axis: error and lines that would keep it.
  std::array<std::size_t, 2> wanted_counts(double tolerance);
  linear_algebra::DenseMatrix reflected_compliance(const Node& node) const;
  ForceDirections along_line() const; ///< all but those across it
  Weights weights_at(const std::array<double, 2>& place) const;
  CellVector weighted(const CellVector& force, double along, double across) const;

  std::shared_ptr<const SkinModel> model_;
  Skin skin_;
  NodeOptions options_;
  std::size_t expected_places_;
  std::vector<std::array<bool, 2>> reflections_; ///< that the rectangle holds
  NodeLines lines_;
  std::vector<Node> nodes_; ///< x fastest
  struct Place {
    std::array<double, 2> centre{};         ///< canonical [m]
    ForceDirections forces{};               ///< that it responds to
    linear_algebra::DenseMatrix compliance; ///< as there [m/N]
    Condensed condensed;                    ///< null where it holds a factor
    /// Its strain under the test load, and those of its mirror images in the rectangle, by
    /// `mirror_index`.
    std::array<std::shared_ptr<const CoreStrain>, 4> test;
  };
  std::vector<Place> places_;
  std::unique_ptr<const ComplianceMap> compliance_;
  double tolerance_ = 0, error_ = 0;
};

} // namespace ionskin::mechanics
