// SPDX-License-Identifier: Apache-2.0
#include "ionskin/linear_algebra/cholesky.hpp"

#include "ionskin/base/error.hpp"
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

SymbolicCholesky::SymbolicCholesky(SymmetricPattern pattern, std::vector<int> order, int trailing)
    : pattern_(std::move(pattern)), order_(std::move(order)), trailing_(trailing),
      symbols_(std::make_unique<Symbols>()) {
  CholmodWorkspace& workspace = symbols_->workspace;
  workspace->nmethods = 1;
  workspace->method[0].ordering = CHOLMOD_GIVEN;
  workspace->postorder = 0; // a postorder of CHOLMOD's own could move the trailing unknowns
  cholmod_sparse matrix = view(pattern_, nullptr);
  symbols_->factor = cholmod_analyze_p(&matrix, order_.data(), nullptr, 0, *workspace);
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

namespace {

/// The dense lower triangle of the last `count` columns of a supernodal factor.
DenseMatrix trailing_block(const cholmod_factor& factor, int count) {
  const int* super = static_cast<const int*>(factor.super);
  const int* row_start = static_cast<const int*>(factor.pi);
  const int* value_start = static_cast<const int*>(factor.px);
  const int* rows = static_cast<const int*>(factor.s);
  const double* values = static_cast<const double*>(factor.x);
  const int first = static_cast<int>(factor.n) - count;
  DenseMatrix block(count, count);
  for (std::size_t s = 0; s < factor.nsuper; ++s) {
    const int height = row_start[s + 1] - row_start[s];
    for (int column = std::max(first, super[s]); column < super[s + 1]; ++column) {
      const int local = column - super[s];
      const double* x = values + value_start[s] + static_cast<std::ptrdiff_t>(local) * height;
      for (int r = local; r < height; ++r) {
        block(rows[row_start[s] + r] - first, column - first) = x[r];
      }
    }
  }
  return block;
}

} // namespace

Cholesky::Cholesky(const SymbolicCholesky& symbolic, const std::vector<double>& values, int threads)
    : symbolic_(symbolic), threads_(threads), numbers_(std::make_unique<Numbers>()) {
  const KernelThreads kernel_threads(threads_);
  CholmodWorkspace& workspace = numbers_->workspace;
  numbers_->factor = cholmod_copy_factor(symbolic.symbols_->factor, *workspace);
  workspace.check("copying the symbolic factor");
  cholmod_sparse matrix = view(symbolic.pattern_, values.data());
  cholmod_factorize(&matrix, numbers_->factor, *workspace);
  workspace.check("factorize");
  if (workspace->status == CHOLMOD_NOT_POSDEF) {
    throw SolverError("the stiffness matrix is not positive definite at unknown " +
                          std::to_string(numbers_->factor->minor),
                      "check the elastic constants and layer thicknesses for extreme ratios");
  }
  trailing_block_ = trailing_block(*numbers_->factor, symbolic.trailing());
}

Cholesky::~Cholesky() = default;

DenseMatrix Cholesky::solve(DenseMatrix right_hand_sides) const {
  const KernelThreads kernel_threads(threads_);
  CholmodWorkspace& workspace = numbers_->workspace;
  cholmod_dense b = view(right_hand_sides);
  cholmod_dense* x = cholmod_solve(CHOLMOD_A, numbers_->factor, &b, *workspace);
  workspace.check("solve");
  const auto* solution = static_cast<const double*>(x->x);
  std::copy(solution, solution + right_hand_sides.values.size(), right_hand_sides.values.begin());
  cholmod_free_dense(&x, *workspace);
  return right_hand_sides;
}

DenseMatrix Cholesky::trailing_forward(DenseMatrix loads) const {
  const KernelThreads kernel_threads(threads_);
  solve_left(loads.rows, loads.columns, trailing_block_.values.data(), trailing_block_.rows,
             loads.values.data(), loads.rows);
  return loads;
}

DenseMatrix Cholesky::backward_from_trailing(const DenseMatrix& forward) const {
  const KernelThreads kernel_threads(threads_);
  CholmodWorkspace& workspace = numbers_->workspace;
  const int size = symbolic_.pattern().size;
  DenseMatrix permuted(size, forward.columns);
  for (int j = 0; j < forward.columns; ++j) {
    std::copy(forward.column(j), forward.column(j) + forward.rows,
              permuted.column(j) + size - forward.rows);
  }
  DenseMatrix gather(forward.columns, static_cast<int>(numbers_->factor->maxesize));
  cholmod_dense x = view(permuted), work = view(gather);
  cholmod_super_ltsolve(numbers_->factor, &x, &work, *workspace);
  workspace.check("backward substitution");
  DenseMatrix solution(size, forward.columns);
  const std::vector<int>& order = symbolic_.order();
  for (int j = 0; j < forward.columns; ++j) {
    const double* from = permuted.column(j);
    double* to = solution.column(j);
    for (int k = 0; k < size; ++k) {
      to[order[k]] = from[k];
    }
  }
  return solution;
}

DenseMatrix gram(const DenseMatrix& y) {
  DenseMatrix result(y.columns, y.columns);
  symmetric_product(true, y.columns, y.rows, 1.0, y.values.data(), y.rows, result.values.data(),
                    result.rows);
  for (int j = 0; j < result.columns; ++j) {
    for (int i = 0; i < j; ++i) {
      result(i, j) = result(j, i);
    }
  }
  return result;
}

DenseMatrix multiply(const DenseMatrix& a, const DenseMatrix& b) {
  DenseMatrix result(a.rows, b.columns);
  product(false, a.rows, b.columns, a.columns, 1.0, a.values.data(), a.rows, b.values.data(),
          b.rows, 0.0, result.values.data(), result.rows);
  return result;
}

} // namespace ionskin::linear_algebra
