// SPDX-License-Identifier: Apache-2.0
#include "ionskin/linear_algebra/forward_substitution.hpp"

#include "ionskin/linear_algebra/cholesky_panels.hpp"
#include "ionskin/linear_algebra/dense_kernels.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace ionskin::linear_algebra {
namespace {

/// Loads multiplied at once, to bound the memory of what they pass on.
constexpr int most_at_once = 256;

/// Those that reach a panel, in the order in which they are sorted.
struct Reach {
  int begin = std::numeric_limits<int>::max(), end = 0;

  bool empty() const { return begin >= end; }
  void widen(const Reach& other) {
    begin = std::min(begin, other.begin);
    end = std::max(end, other.end);
  }
};

/// Values of one unknown under loads from one on.
struct Row {
  double* first;
  std::ptrdiff_t step; ///< from load to load
};

/// Calls `use` with place and value of each entry of a load.
template <class Use> void for_entries(const SparseLoads& loads, int load, const Use& use) {
  for (int e = loads.start[load]; e < loads.start[load + 1]; ++e) {
    use(loads.place[e], loads.value[e]);
  }
}

/// Loads by the first unknown that they act on. Those that reach a panel are then neighbours where
/// each acts on one element: its unknowns lie on one path through the elimination tree.
std::vector<int> sorted_by_first_place(const SparseLoads& loads) {
  std::vector<int> first(static_cast<std::size_t>(loads.count()), std::numeric_limits<int>::max()),
      sorted(first.size());
  std::iota(sorted.begin(), sorted.end(), 0);
  for (const int load : sorted) {
    for_entries(loads, load,
                [&](int place, double) { first[load] = std::min(first[load], place); });
  }
  std::ranges::stable_sort(sorted, {}, [&](int load) { return first[load]; });
  return sorted;
}

} // namespace

ForwardSubstitution::ForwardSubstitution(const CholeskyPanels& panels, int trailing,
                                         const SparseLoads& loads)
    : unknowns_(panels.size - trailing), sorted_(sorted_by_first_place(loads)) {
  const std::vector<std::size_t> piece_of = make_pieces(panels, loads);
  DenseMatrix passed_on(trailing, loads.count()); // sorted
  const auto row_of = [&](int place, int load) -> Row {
    if (place >= unknowns_) {
      return {passed_on.column(load) + (place - unknowns_), passed_on.rows};
    }
    Piece& piece = pieces_[piece_of[place]];
    return {piece.values.column(load - piece.first_load) + (place - piece.first_unknown),
            piece.values.rows};
  };
  for (int k = 0; k < loads.count(); ++k) {
    for_entries(loads, sorted_[k],
                [&](int place, double value) { *row_of(place, k).first += value; });
  }
  DenseMatrix passed;
  std::vector<Row> below;
  for (Piece& piece : pieces_) {
    DenseMatrix& own = piece.values;
    const double* panel = panels.values + panels.value_start[piece.panel];
    const int height = panels.height(piece.panel), rows = height - own.rows;
    solve_left(false, own.rows, own.columns, panel, height, own.values.data(), own.rows);
    for (int first = 0; first < own.columns; first += most_at_once) {
      const int count = std::min(most_at_once, own.columns - first);
      passed.reshape(rows, count);
      product(false, rows, count, own.rows, 1.0, panel + own.rows, height, own.column(first),
              own.rows, 0.0, passed.values.data(), rows);
      below.clear();
      for (int r = own.rows; r < height; ++r) {
        const int place = panels.rows[panels.row_start[piece.panel] + r];
        below.push_back(row_of(place, piece.first_load + first));
      }
      for (int j = 0; j < count; ++j) {
        for (int r = 0; r < rows; ++r) {
          below[r].first[j * below[r].step] -= passed(r, j);
        }
      }
    }
  }
  passed_on_ = DenseMatrix(trailing, loads.count());
  for (int k = 0; k < loads.count(); ++k) {
    std::copy_n(passed_on.column(k), trailing, passed_on_.column(sorted_[k]));
  }
}

std::vector<std::size_t> ForwardSubstitution::make_pieces(const CholeskyPanels& panels,
                                                          const SparseLoads& loads) {
  std::vector<std::size_t> panel_of(static_cast<std::size_t>(unknowns_));
  std::vector<Reach> reach;
  for (std::size_t s = 0; s < panels.count && panels.first_column[s] < unknowns_; ++s) {
    std::fill_n(panel_of.begin() + panels.first_column[s], panels.columns_before(s, unknowns_), s);
    reach.emplace_back();
  }
  for (int k = 0; k < loads.count(); ++k) {
    for_entries(loads, sorted_[k], [&](int place, double) {
      if (place < unknowns_) {
        reach[panel_of[place]].widen({k, k + 1});
      }
    });
  }
  std::vector<std::size_t> piece_of(panel_of.size());
  for (std::size_t s = 0; s < reach.size(); ++s) {
    if (reach[s].empty()) {
      continue;
    }
    const int columns = panels.columns_before(s, unknowns_);
    std::fill_n(piece_of.begin() + panels.first_column[s], columns, pieces_.size());
    pieces_.push_back({s, panels.first_column[s], reach[s].begin,
                       DenseMatrix(columns, reach[s].end - reach[s].begin)});
    // The next row is of the panel's parent in the elimination tree, whose rows hold the others.
    const int next = panels.row_start[s] + columns;
    if (next < panels.row_start[s + 1] && panels.rows[next] < unknowns_) {
      reach[panel_of[panels.rows[next]]].widen(reach[s]);
    }
  }
  return piece_of;
}

DenseMatrix ForwardSubstitution::gram() const {
  const int loads = static_cast<int>(sorted_.size());
  DenseMatrix lower(loads, loads), result(loads, loads);
  for (const auto& [panel, first_unknown, first_load, values] : pieces_) {
    symmetric_product(true, values.columns, values.rows, 1.0, values.values.data(), values.rows,
                      1.0, lower.column(first_load) + first_load, loads);
  }
  for (int j = 0; j < loads; ++j) {
    for (int i = j; i < loads; ++i) {
      result(sorted_[i], sorted_[j]) = result(sorted_[j], sorted_[i]) = lower(i, j);
    }
  }
  return result;
}

template <class Use>
void ForwardSubstitution::for_pieces(DenseMatrix& states, const Use& use) const {
  int done = 0;
  for (const Piece& piece : pieces_) {
    std::fill(states.column(done), states.column(piece.first_unknown), 0.0);
    use(piece);
    done = piece.first_unknown + piece.values.rows;
  }
  std::fill(states.column(done), states.column(unknowns_), 0.0);
}

void ForwardSubstitution::select(const std::vector<int>& loads, DenseMatrix& states) const {
  std::vector<int> place(sorted_.size());
  for (std::size_t k = 0; k < sorted_.size(); ++k) {
    place[sorted_[k]] = static_cast<int>(k);
  }
  std::vector<const double*> column(loads.size()); // null where a load does not reach
  for_pieces(states, [&](const Piece& piece) {
    const DenseMatrix& values = piece.values;
    for (std::size_t j = 0; j < loads.size(); ++j) {
      const int k = place[loads[j]] - piece.first_load;
      column[j] = k >= 0 && k < values.columns ? values.column(k) : nullptr;
    }
    for (int i = 0; i < values.rows; ++i) {
      double* own = states.column(piece.first_unknown + i);
      for (std::size_t j = 0; j < loads.size(); ++j) {
        own[j] = column[j] != nullptr ? column[j][i] : 0.0;
      }
    }
  });
}

void ForwardSubstitution::combine(const DenseMatrix& weights, DenseMatrix& states) const {
  DenseMatrix sorted(weights.rows, weights.columns);
  for (int j = 0; j < weights.columns; ++j) {
    for (int k = 0; k < weights.rows; ++k) {
      sorted(k, j) = weights(sorted_[k], j);
    }
  }
  DenseMatrix own;
  for_pieces(states, [&](const Piece& piece) {
    const DenseMatrix& values = piece.values;
    own.reshape(values.rows, sorted.columns);
    product(false, values.rows, sorted.columns, values.columns, 1.0, values.values.data(),
            values.rows, sorted.values.data() + piece.first_load, sorted.rows, 0.0,
            own.values.data(), own.rows);
    for (int i = 0; i < own.rows; ++i) {
      for (int j = 0; j < own.columns; ++j) {
        states(j, piece.first_unknown + i) = own(i, j);
      }
    }
  });
}

} // namespace ionskin::linear_algebra
