// SPDX-License-Identifier: Apache-2.0
#include "ionskin/linear_algebra/cholesky.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/linear_algebra/cholesky_panels.hpp"
#include "ionskin/linear_algebra/cholmod_handles.hpp"
#include "ionskin/linear_algebra/dense_kernels.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace ionskin::linear_algebra {

struct SymbolicCholesky::Symbols {
  CholmodWorkspace workspace;
  cholmod_factor* factor = nullptr;
  ~Symbols() { cholmod_free_factor(&factor, *workspace); }
};

SymbolicCholesky::SymbolicCholesky(const SymmetricPattern& pattern, std::vector<int> order,
                                   int trailing)
    : ordered_(renumbered(pattern, order)), order_(std::move(order)), trailing_(trailing),
      symbols_(std::make_unique<Symbols>()) {
  // A matrix in its elimination order is factorised as it stands; CHOLMOD would transpose another
  // twice each time.
  CholmodWorkspace& workspace = symbols_->workspace;
  workspace->nmethods = 1;
  workspace->method[0].ordering = CHOLMOD_NATURAL;
  workspace->postorder = 0; // a postorder of CHOLMOD's own could move the trailing unknowns
  cholmod_sparse matrix = view(ordered_.pattern, nullptr);
  symbols_->factor = cholmod_analyze(&matrix, *workspace);
  workspace.check("analyze");
}

SymbolicCholesky::SymbolicCholesky(SymbolicCholesky&&) noexcept = default;
SymbolicCholesky::~SymbolicCholesky() = default;

double SymbolicCholesky::factor_entries() const {
  return symbols_->workspace->lnz;
}
double SymbolicCholesky::operations() const {
  return symbols_->workspace->fl;
}

struct Cholesky::Numbers {
  mutable CholmodWorkspace workspace;
  cholmod_factor* factor = nullptr;
  ~Numbers() { cholmod_free_factor(&factor, *workspace); }
};

Cholesky::Cholesky(const SymbolicCholesky& symbolic, const std::vector<double>& values)
    : symbolic_(symbolic), numbers_(std::make_unique<Numbers>()) {
  const KernelThreads one_thread(1);
  CholmodWorkspace& workspace = numbers_->workspace;
  numbers_->factor = cholmod_copy_factor(symbolic.symbols_->factor, *workspace);
  workspace.check("copying the symbolic factor");
  std::vector<double> ordered;
  ordered.reserve(values.size());
  for (const int entry : symbolic.ordered_.source) {
    ordered.push_back(values[entry]);
  }
  cholmod_sparse matrix = view(symbolic.ordered_.pattern, ordered.data());
  cholmod_factorize(&matrix, numbers_->factor, *workspace);
  workspace.check("factorize");
  if (workspace->status == CHOLMOD_NOT_POSDEF) {
    throw SolverError("the stiffness matrix is not positive definite at unknown " +
                          std::to_string(numbers_->factor->minor),
                      "check the elastic constants and layer thicknesses for extreme ratios");
  }
}

Cholesky::~Cholesky() = default;

DenseMatrix Cholesky::solve(DenseMatrix right_hand_sides) const {
  const KernelThreads one_thread(1);
  CholmodWorkspace& workspace = numbers_->workspace;
  DenseMatrix ordered(right_hand_sides.rows, right_hand_sides.columns);
  for (int j = 0; j < ordered.columns; ++j) {
    for (int k = 0; k < ordered.rows; ++k) {
      ordered(k, j) = right_hand_sides(symbolic_.order()[k], j);
    }
  }
  cholmod_dense b = view(ordered);
  cholmod_dense* x = cholmod_solve(CHOLMOD_A, numbers_->factor, &b, *workspace);
  workspace.check("solve");
  const auto* solution = static_cast<const double*>(x->x);
  for (int j = 0; j < ordered.columns; ++j) {
    for (int k = 0; k < ordered.rows; ++k) {
      right_hand_sides(symbolic_.order()[k], j) = *solution++;
    }
  }
  cholmod_free_dense(&x, *workspace);
  return right_hand_sides;
}

DenseMatrix Cholesky::last_block(int count) const {
  const CholeskyPanels panels(*numbers_->factor);
  const int first = symbolic_.size() - count;
  DenseMatrix block(count, count);
  for (std::size_t s = panels.count; s-- > 0 && panels.first_column[s + 1] > first;) {
    const int height = panels.height(s);
    const int* rows = panels.rows + panels.row_start[s];
    for (int column = std::max(first, panels.first_column[s]); column < panels.first_column[s + 1];
         ++column) {
      const int local = column - panels.first_column[s];
      const double* x =
          panels.values + panels.value_start[s] + static_cast<std::ptrdiff_t>(local) * height;
      for (int r = local; r < height; ++r) {
        block(rows[r] - first, column - first) = x[r];
      }
    }
  }
  return block;
}

DenseMatrix Cholesky::take_last_block(int count) {
  DenseMatrix block = last_block(count);
  const CholeskyPanels panels(*numbers_->factor);
  const int before = panels.size - count;
  std::size_t s = 0; // panel in which the block begins
  while (s < panels.count && panels.first_column[s + 1] <= before) {
    ++s;
  }
  if (s < panels.count) {
    const auto own = static_cast<std::size_t>(panels.columns_before(s, before));
    const std::size_t kept = static_cast<std::size_t>(panels.value_start[s]) +
                             own * static_cast<std::size_t>(panels.height(s));
    cholmod_factor& factor = *numbers_->factor;
    factor.x = cholmod_realloc(kept, sizeof(double), factor.x, &factor.xsize, *numbers_->workspace);
    numbers_->workspace.check("giving memory back");
  }
  return block;
}

ForwardSubstitution Cholesky::forward(const SparseLoads& loads) const {
  const KernelThreads one_thread(1);
  return {CholeskyPanels(*numbers_->factor), symbolic_.trailing(), loads};
}

void Cholesky::complete(int known, int loaded, DenseMatrix& states) const {
  const CholeskyPanels panels(*numbers_->factor);
  const int unknown = symbolic_.size() - known, count = states.rows, unloaded = unknown - loaded;
  std::size_t end = 0;
  int most_rows = 0;
  for (; end < panels.count && panels.first_column[end] < unknown; ++end) {
    most_rows = std::max(most_rows, panels.height(end) - panels.columns_before(end, unknown));
  }
  DenseMatrix gathered(count, most_rows);
  for (std::size_t s = end; s-- > 0;) {
    const int height = panels.height(s), columns = panels.columns_before(s, unknown);
    const int* rows = panels.rows + panels.row_start[s] + columns;
    for (int r = 0; r < height - columns; ++r) {
      std::copy_n(states.column(rows[r]), count, gathered.column(r));
    }
    const double* panel = panels.values + panels.value_start[s];
    double* own = states.column(panels.first_column[s]);
    const bool replaced = panels.first_column[s] + columns <= unloaded;
    if (!replaced && panels.first_column[s] < unloaded) {
      std::fill(own, states.column(unloaded), 0.0);
    }
    product(false, count, columns, height - columns, -1.0, gathered.values.data(), count,
            panel + columns, height, replaced ? 0.0 : 1.0, own, count);
    solve_right(count, columns, panel, height, own, count);
  }
}

namespace {

void copy_lower_triangle(DenseMatrix& matrix) {
  for (int j = 0; j < matrix.columns; ++j) {
    for (int i = 0; i < j; ++i) {
      matrix(i, j) = matrix(j, i);
    }
  }
}

} // namespace

DenseMatrix gram(const DenseMatrix& y) {
  DenseMatrix result(y.columns, y.columns);
  symmetric_product(true, y.columns, y.rows, 1.0, y.values.data(), y.rows, 0.0,
                    result.values.data(), result.rows);
  copy_lower_triangle(result);
  return result;
}

LowerTriangle gram_of_rows(DenseMatrix l) {
  // In its place, a panel of columns at a time from the last: a column of L reaches the rows below
  // its diagonal alone, so that a third of the operations of a full product are left.
  constexpr int panel_columns = 128;
  DenseMatrix panel;
  for (int end = l.columns; end > 0;) {
    const int first = std::max(0, end - panel_columns), height = l.rows - first;
    panel.reshape(height, end - first);
    for (int j = 0; j < panel.columns; ++j) {
      double* column = l.column(first + j) + first;
      std::copy_n(column, height, panel.column(j));
      std::fill_n(column, height, 0.0);
    }
    symmetric_product(false, height, panel.columns, 1.0, panel.values.data(), height, 1.0,
                      l.column(first) + first, l.rows);
    end = first;
  }
  return LowerTriangle(l);
}

DenseMatrix multiply(const DenseMatrix& a, const DenseMatrix& b) {
  DenseMatrix result(a.rows, b.columns);
  product(false, a.rows, b.columns, a.columns, 1.0, a.values.data(), a.rows, b.values.data(),
          b.rows, 0.0, result.values.data(), result.rows);
  return result;
}

} // namespace ionskin::linear_algebra
