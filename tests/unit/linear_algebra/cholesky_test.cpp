// SPDX-License-Identifier: Apache-2.0
#include "grid_graph.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/linear_algebra/cholesky.hpp"
#include "ionskin/linear_algebra/postorder.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <numeric>
#include <thread>
#include <utility>
#include <vector>

namespace ionskin::linear_algebra {
namespace {

/// The octants of a grid, the planes between them, then the trailing nodes.
std::vector<int> grid_order(const SymmetricPattern& graph, const std::vector<int>& trailing) {
  const int n = static_cast<int>(std::lround(std::cbrt(graph.size)));
  std::vector<int> order;
  for (int node = 0; node < graph.size; ++node) {
    if (std::ranges::find(trailing, node) == trailing.end()) {
      order.push_back(node);
    }
  }
  std::ranges::stable_sort(order, {}, [&](int node) {
    return std::array{node % n == n / 2, node / n % n == n / 2, node / (n * n) == n / 2};
  });
  order.insert(order.end(), trailing.begin(), trailing.end());
  return postordered(graph, order, static_cast<int>(trailing.size()));
}

/// Diagonally dominant values with varying couplings.
std::vector<double> values_on(const SymmetricPattern& pattern, double shift) {
  std::vector<double> values;
  for (int j = 0; j < pattern.size; ++j) {
    for (int p = pattern.column_start[j]; p < pattern.column_start[j + 1]; ++p) {
      const bool diagonal = pattern.row[p] == j;
      values.push_back(diagonal ? 7 + shift + 0.1 * (j % 5) : -1 - 0.01 * (pattern.row[p] % 7));
    }
  }
  return values;
}

Eigen::MatrixXd dense(const SymmetricPattern& pattern, const std::vector<double>& values) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(pattern.size, pattern.size);
  for (int j = 0; j < pattern.size; ++j) {
    for (int p = pattern.column_start[j]; p < pattern.column_start[j + 1]; ++p) {
      matrix(pattern.row[p], j) = matrix(j, pattern.row[p]) = values[p];
    }
  }
  return matrix;
}

Eigen::Map<const Eigen::MatrixXd> map(const DenseMatrix& matrix) {
  return {matrix.values.data(), matrix.rows, matrix.columns};
}

class CholeskyOnGrid : public testing::Test {
protected:
  CholeskyOnGrid() {
    for (int node = 5; node < graph.size; node += 9) {
      trailing.push_back(node);
    }
    std::reverse(trailing.begin(), trailing.end());
  }
  const SymmetricPattern graph = grid_graph(9);
  std::vector<int> trailing;
};

TEST_F(CholeskyOnGrid, ordering_is_a_permutation_with_the_trailing_nodes_last) {
  const std::vector<int> order = grid_order(graph, trailing);
  std::vector<int> sorted = order, identity(order.size());
  std::sort(sorted.begin(), sorted.end());
  std::iota(identity.begin(), identity.end(), 0);
  EXPECT_EQ(sorted, identity);
  EXPECT_TRUE(std::equal(trailing.rbegin(), trailing.rend(), order.rbegin()));
}

TEST_F(CholeskyOnGrid, solve_agrees_with_a_dense_solver) {
  const SymbolicCholesky symbolic(graph, grid_order(graph, trailing),
                                  static_cast<int>(trailing.size()));
  const auto values = values_on(graph, 0);
  const Cholesky factor(symbolic, values);
  DenseMatrix right(graph.size, 3);
  for (std::size_t i = 0; i < right.values.size(); ++i) {
    right.values[i] = std::sin(static_cast<double>(i));
  }
  const Eigen::MatrixXd expected = dense(graph, values).llt().solve(map(right));
  EXPECT_LT((map(factor.solve(right)) - expected).norm(), 1e-12 * expected.norm());
}

TEST_F(CholeskyOnGrid, last_block_gives_the_compliance_of_the_last_unknowns) {
  const int count = static_cast<int>(trailing.size());
  const SymbolicCholesky symbolic(graph, grid_order(graph, trailing), count);
  const Cholesky factor(symbolic, values_on(graph, 0));
  DenseMatrix unit(graph.size, count);
  for (int j = 0; j < count; ++j) {
    unit(trailing[j], j) = 1;
  }
  const Eigen::MatrixXd compliance = map(unit).transpose() * map(factor.solve(unit));
  for (const int last : {count, count / 2, 1}) {
    const DenseMatrix schur = gram_of_rows(factor.last_block(last)).dense();
    const Eigen::MatrixXd product = map(schur).selfadjointView<Eigen::Lower>() *
                                    compliance.bottomRightCorner(last, last).eval();
    EXPECT_LT((product - Eigen::MatrixXd::Identity(last, last)).norm(), 1e-12) << last;
  }
}

TEST(GramOfRows, is_the_product_whatever_the_number_of_panels) {
  for (const int n : {0, 1, 127, 128, 129, 300}) {
    DenseMatrix lower(n, n);
    for (int j = 0; j < n; ++j) {
      for (int i = j; i < n; ++i) {
        lower(i, j) = std::sin(i + 7.0 * j);
      }
    }
    const Eigen::MatrixXd expected = map(lower) * map(lower).transpose();
    const DenseMatrix product = gram_of_rows(lower).dense();
    EXPECT_LE((map(product) - Eigen::MatrixXd(expected.triangularView<Eigen::Lower>())).norm(),
              1e-13 * expected.norm())
        << n;
  }
}

TEST_F(CholeskyOnGrid, completes_solutions_of_loads_on_trailing_unknowns) {
  const int count = static_cast<int>(trailing.size()), states = 4;
  const std::vector<int> order = grid_order(graph, trailing);
  const SymbolicCholesky symbolic(graph, order, count);
  const Cholesky factor(symbolic, values_on(graph, 0));
  DenseMatrix right(graph.size, states);
  Eigen::MatrixXd loads(count, states);
  for (int j = 0; j < states; ++j) {
    for (int i = 0; i < count; ++i) {
      loads(i, j) = right(trailing[i], j) = std::cos(i + 3.0 * j);
    }
  }
  const DenseMatrix solution = factor.solve(right), block = factor.last_block(count);
  const Eigen::MatrixXd forward = map(block).triangularView<Eigen::Lower>().solve(loads);
  const int first = graph.size - count;
  for (const int known : {0, 1, count / 3, count}) {
    DenseMatrix columns(states, graph.size);
    std::ranges::fill(columns.values, std::nan(""));
    for (int k = first; k < graph.size; ++k) {
      for (int j = 0; j < states; ++j) {
        columns(j, k) = k < graph.size - known ? forward(k - first, j) : solution(order[k], j);
      }
    }
    factor.complete(known, count - known, columns);
    double error = 0;
    for (int k = 0; k < graph.size; ++k) {
      for (int j = 0; j < states; ++j) {
        error = std::max(error, std::abs(columns(j, k) - solution(order[k], j)));
      }
    }
    EXPECT_LT(error, 1e-14 * map(solution).norm()) << known << " known";
  }
}

TEST_F(CholeskyOnGrid, completes_without_the_last_block_that_was_taken) {
  const int count = static_cast<int>(trailing.size()), states = 3;
  const SymbolicCholesky symbolic(graph, grid_order(graph, trailing), count);
  const Cholesky whole(symbolic, values_on(graph, 0));
  Cholesky rest(symbolic, values_on(graph, 0));
  EXPECT_EQ(rest.take_last_block(count).values, whole.last_block(count).values);
  DenseMatrix expected(states, graph.size);
  for (std::size_t i = 0; i < expected.values.size(); ++i) {
    expected.values[i] = std::sin(static_cast<double>(i));
  }
  DenseMatrix completed = expected;
  whole.complete(count, 0, expected);
  rest.complete(count, 0, completed);
  EXPECT_EQ(completed.values, expected.values);
}

TEST_F(CholeskyOnGrid, substitutes_forward_where_loads_reach) {
  const int count = static_cast<int>(trailing.size()), loads = 300, before = graph.size - count;
  const std::vector<int> order = grid_order(graph, trailing);
  const auto values = values_on(graph, 0);
  SparseLoads sparse;
  Eigen::MatrixXd load = Eigen::MatrixXd::Zero(graph.size, loads);
  for (int j = 0; j < loads; ++j) {
    for (const int place : {(7 * j + 11) % graph.size, (90 * j) % graph.size}) {
      sparse.place.push_back(place);
      sparse.value.push_back(1 + 0.1 * j);
      load(place, j) += 1 + 0.1 * j;
    }
    sparse.start.push_back(static_cast<int>(sparse.place.size()));
  }
  const SymbolicCholesky symbolic(graph, order, count), all(graph, order, graph.size);
  const ForwardSubstitution forward = Cholesky(symbolic, values).forward(sparse);
  const DenseMatrix lower = Cholesky(all, values).last_block(graph.size);
  const Eigen::MatrixXd y = map(lower)
                                .topLeftCorner(before, before)
                                .triangularView<Eigen::Lower>()
                                .solve(load.topRows(before)),
                        passed_on =
                            load.bottomRows(count) - map(lower).bottomLeftCorner(count, before) * y,
                        gram = y.transpose() * y;
  EXPECT_LT((map(forward.passed_on()) - passed_on).norm(), 1e-13 * passed_on.norm());
  EXPECT_LT((map(forward.gram()) - gram).norm(), 1e-13 * gram.norm());

  DenseMatrix states(3, graph.size), weights(loads, 3);
  std::ranges::fill(states.values, std::nan(""));
  forward.select({5, 299, 0}, states);
  for (const auto& [state, chosen] : {std::pair{0, 5}, {1, 299}, {2, 0}}) {
    EXPECT_LT((map(states).row(state).head(before).transpose() - y.col(chosen)).norm(), 1e-13);
  }
  for (std::size_t i = 0; i < weights.values.size(); ++i) {
    weights.values[i] = std::cos(static_cast<double>(i));
  }
  std::ranges::fill(states.values, std::nan(""));
  forward.combine(weights, states);
  const Eigen::MatrixXd combined = y * map(weights);
  EXPECT_LT((map(states).leftCols(before).transpose() - combined).norm(), 1e-13 * combined.norm());
}

TEST_F(CholeskyOnGrid, one_analysis_serves_several_threads) {
  const SymbolicCholesky symbolic(graph, grid_order(graph, trailing),
                                  static_cast<int>(trailing.size()));
  std::vector<double> error(4);
  {
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < error.size(); ++t) {
      threads.emplace_back([&, t] {
        const auto values = values_on(graph, static_cast<double>(t));
        DenseMatrix right(graph.size, 1);
        std::fill(right.values.begin(), right.values.end(), 1.0);
        const DenseMatrix solution = Cholesky(symbolic, values).solve(right);
        error[t] = (dense(graph, values) * map(solution) - map(right)).norm();
      });
    }
  }
  for (const double e : error) {
    EXPECT_LT(e, 1e-12);
  }
}

TEST_F(CholeskyOnGrid, indefinite_matrix_is_a_solver_error) {
  const SymbolicCholesky symbolic(graph, grid_order(graph, trailing),
                                  static_cast<int>(trailing.size()));
  EXPECT_THROW(Cholesky(symbolic, values_on(graph, -9)), SolverError);
}

std::ptrdiff_t threads_of_this_process() {
  const std::filesystem::directory_iterator tasks("/proc/self/task");
  return std::distance(begin(tasks), end(tasks));
}

TEST(Cholesky, a_factorisation_starts_no_threads_of_its_own) {
  const SymmetricPattern graph = grid_graph(16);
  const SymbolicCholesky symbolic(graph, grid_order(graph, {}), 0);
  const auto before = threads_of_this_process();
  const Cholesky factor(symbolic, values_on(graph, 0));
  EXPECT_EQ(threads_of_this_process(), before);
}

} // namespace
} // namespace ionskin::linear_algebra
