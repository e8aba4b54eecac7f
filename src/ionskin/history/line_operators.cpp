// SPDX-License-Identifier: Apache-2.0
#include "ionskin/history/line_operators.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace ionskin::history {
namespace {

const double gauss_offset = 1.0 / std::sqrt(3.0);

/// Appends a dense row of weights, stripped of zeros at its begin and end.
void push_row(LineOperator& line, const std::vector<double>& dense) {
  std::size_t begin = 0;
  std::size_t end = dense.size();
  while (begin + 1 < end && dense[begin] == 0) {
    ++begin;
  }
  while (end > begin + 1 && dense[end - 1] == 0) {
    --end;
  }
  line.first.push_back(begin);
  line.weights.emplace_back(dense.begin() + static_cast<std::ptrdiff_t>(begin),
                            dense.begin() + static_cast<std::ptrdiff_t>(end));
}

/// Adds the integrals over [from, to] of the two hat functions on [left, right], which contains
/// [from, to], to their weights.
void add_linear_integral(double left, double right, double from, double to, double& weight_left,
                         double& weight_right) {
  const double mean = (0.5 * (from + to) - left) / (right - left);
  weight_left += (to - from) * (1 - mean);
  weight_right += (to - from) * mean;
}

/// L2 projection onto continuous piecewise linear functions, with `parts` equal pieces in each
/// interval. The source is linear in each interval, and given by its values at two points there.
/// @param offset distance of the two points from the middle of the interval, over half its length
///   [1]
LineOperator projection(const std::vector<double>& lines, Eigen::Index parts, double offset) {
  const auto intervals = static_cast<Eigen::Index>(lines.size() - 1);
  const Eigen::Index nodes = parts * intervals + 1;
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(nodes, nodes);
  Eigen::MatrixXd load = Eigen::MatrixXd::Zero(nodes, 2 * intervals);
  for (Eigen::Index e = 0; e < parts * intervals; ++e) {
    const Eigen::Index interval = e / parts;
    const double length = (lines[static_cast<std::size_t>(interval) + 1] -
                           lines[static_cast<std::size_t>(interval)]) /
                          static_cast<double>(parts);
    mass(e, e) += length / 3;
    mass(e + 1, e + 1) += length / 3;
    mass(e, e + 1) += length / 6;
    mass(e + 1, e) += length / 6;
    // Two Gauss points are exact for the product of two linear functions.
    for (Eigen::Index p = 0; p < 2; ++p) {
      const double right = 0.5 * (1 + (p == 0 ? -gauss_offset : gauss_offset));
      const double within = (static_cast<double>(e % parts) + right) / static_cast<double>(parts);
      for (Eigen::Index q = 0; q < 2; ++q) {
        // The function that is 1 at the interval's place q and 0 at the other.
        const double value = 0.5 + (q == 0 ? -1 : 1) * (within - 0.5) / offset;
        load(e, 2 * interval + q) += 0.5 * length * (1 - right) * value;
        load(e + 1, 2 * interval + q) += 0.5 * length * right * value;
      }
    }
  }
  const Eigen::MatrixXd weights = mass.llt().solve(load);
  LineOperator line;
  line.sources = static_cast<std::size_t>(2 * intervals);
  for (Eigen::Index i = 0; i < nodes; ++i) {
    std::vector<double> row(line.sources);
    for (std::size_t q = 0; q < line.sources; ++q) {
      row[q] = weights(i, static_cast<Eigen::Index>(q));
    }
    push_row(line, row);
  }
  return line;
}

} // namespace

LineOperator linear_projection(const std::vector<double>& lines) {
  return projection(lines, 1, gauss_offset);
}

LineOperator halved_projection(const std::vector<double>& lines) {
  return projection(lines, 2, gauss_offset);
}

LineOperator half_means_projection(const std::vector<double>& lines) {
  constexpr double middle_of_half = 0.5;
  return projection(lines, 1, middle_of_half);
}

std::vector<double> halved(const std::vector<double>& lines) {
  std::vector<double> nodes{lines.front()};
  for (std::size_t i = 1; i < lines.size(); ++i) {
    nodes.push_back(0.5 * (lines[i - 1] + lines[i]));
    nodes.push_back(lines[i]);
  }
  return nodes;
}

LineOperator cell_averages(const std::vector<double>& lines,
                           const std::vector<double>& cell_edges) {
  LineOperator line;
  line.sources = lines.size();
  for (std::size_t cell = 0; cell + 1 < cell_edges.size(); ++cell) {
    const double from = std::max(cell_edges[cell], lines.front());
    const double to = std::min(cell_edges[cell + 1], lines.back());
    std::vector<double> row(lines.size(), 0.0);
    if (to <= from) {
      (cell_edges[cell + 1] <= lines.front() ? row.front() : row.back()) = 1;
    } else {
      for (std::size_t e = 0; e + 1 < lines.size(); ++e) {
        const double a = std::max(from, lines[e]);
        const double b = std::min(to, lines[e + 1]);
        if (b > a) {
          add_linear_integral(lines[e], lines[e + 1], a, b, row[e], row[e + 1]);
        }
      }
      for (double& weight : row) {
        weight /= to - from;
      }
    }
    push_row(line, row);
  }
  return line;
}

LineOperator half_means_averages(const std::vector<double>& lines,
                                 const std::vector<double>& target_edges) {
  LineOperator line;
  line.sources = 2 * (lines.size() - 1);
  for (std::size_t cell = 0; cell + 1 < target_edges.size(); ++cell) {
    const double from = target_edges[cell], to = target_edges[cell + 1];
    std::vector<double> dense(line.sources, 0.0);
    for (std::size_t e = 0; e + 1 < lines.size(); ++e) {
      const double low = std::max(from, lines[e]), high = std::min(to, lines[e + 1]);
      if (high <= low) {
        continue;
      }
      const double share = (high - low) / (to - from);
      const double place = (low + high - lines[e] - lines[e + 1]) / (lines[e + 1] - lines[e]);
      dense[2 * e] += share * (0.5 - place);
      dense[2 * e + 1] += share * (0.5 + place);
    }
    push_row(line, dense);
  }
  return line;
}

LineOperator overlap_averages(const std::vector<double>& source_edges,
                              const std::vector<double>& target_edges) {
  LineOperator line;
  line.sources = source_edges.size() - 1;
  std::size_t begin = 0;
  for (std::size_t cell = 0; cell + 1 < target_edges.size(); ++cell) {
    const double from = target_edges[cell];
    const double to = target_edges[cell + 1];
    while (begin + 1 < line.sources && source_edges[begin + 1] <= from) {
      ++begin;
    }
    std::vector<double> weights;
    for (std::size_t e = begin; e < line.sources && (e == begin || source_edges[e] < to); ++e) {
      const double overlap = std::min(to, source_edges[e + 1]) - std::max(from, source_edges[e]);
      weights.push_back(std::max(0.0, overlap) / (to - from));
    }
    line.first.push_back(begin);
    line.weights.push_back(std::move(weights));
  }
  return line;
}

LineOperator hat_averages(const std::vector<double>& source_nodes,
                          const std::vector<double>& target_nodes) {
  std::vector<std::vector<double>> dense(target_nodes.size(),
                                         std::vector<double>(source_nodes.size(), 0.0));
  std::vector<double> volume(target_nodes.size(), 0.0);
  for (std::size_t t = 0; t + 1 < target_nodes.size(); ++t) {
    const double left = target_nodes[t];
    const double right = target_nodes[t + 1];
    volume[t] += 0.5 * (right - left);
    volume[t + 1] += 0.5 * (right - left);
    for (std::size_t s = 0; s + 1 < source_nodes.size(); ++s) {
      const double a = std::max(left, source_nodes[s]);
      const double b = std::min(right, source_nodes[s + 1]);
      if (b <= a) {
        continue;
      }
      // Two Gauss points integrate the product of two linear functions exactly.
      for (const double offset : {-gauss_offset, gauss_offset}) {
        const double z = 0.5 * (a + b) + 0.5 * (b - a) * offset;
        const double hat = (z - left) / (right - left);
        const double source = (z - source_nodes[s]) / (source_nodes[s + 1] - source_nodes[s]);
        const double weight = 0.5 * (b - a);
        dense[t][s] += weight * (1 - hat) * (1 - source);
        dense[t][s + 1] += weight * (1 - hat) * source;
        dense[t + 1][s] += weight * hat * (1 - source);
        dense[t + 1][s + 1] += weight * hat * source;
      }
    }
  }
  LineOperator line;
  line.sources = source_nodes.size();
  for (std::size_t t = 0; t < target_nodes.size(); ++t) {
    for (double& weight : dense[t]) {
      weight /= volume[t];
    }
    push_row(line, dense[t]);
  }
  return line;
}

LineOperator linear_interpolation(const std::vector<double>& source_nodes,
                                  const std::vector<double>& target_nodes) {
  LineOperator line;
  line.sources = source_nodes.size();
  std::size_t interval = 0;
  for (const double node : target_nodes) {
    while (interval + 2 < source_nodes.size() && source_nodes[interval + 1] < node) {
      ++interval;
    }
    const double left = source_nodes[interval], right = source_nodes[interval + 1];
    const double weight = std::clamp((node - left) / (right - left), 0.0, 1.0);
    line.first.push_back(interval);
    line.weights.push_back({1 - weight, weight});
  }
  return line;
}

LineOperator compose(const LineOperator& second, const LineOperator& first) {
  LineOperator line;
  line.sources = first.sources;
  for (std::size_t i = 0; i < second.rows(); ++i) {
    std::vector<double> row(first.sources, 0.0);
    for (std::size_t j = 0; j < second.weights[i].size(); ++j) {
      const std::size_t middle = second.first[i] + j;
      for (std::size_t k = 0; k < first.weights[middle].size(); ++k) {
        row[first.first[middle] + k] += second.weights[i][j] * first.weights[middle][k];
      }
    }
    push_row(line, row);
  }
  return line;
}

void apply_along(const LineOperator& line, std::size_t outer, std::size_t inner,
                 const std::vector<double>& field, std::vector<double>& result) {
  result.assign(outer * line.rows() * inner, 0.0);
  for (std::size_t o = 0; o < outer; ++o) {
    for (std::size_t row = 0; row < line.rows(); ++row) {
      double* out = &result[(o * line.rows() + row) * inner];
      if (inner == 1) {
        // Values lie one behind the other: a dot product in vector instructions.
        const auto size = static_cast<Eigen::Index>(line.weights[row].size());
        const double* in = &field[o * line.sources + line.first[row]];
        *out = Eigen::Map<const Eigen::VectorXd>(line.weights[row].data(), size)
                   .dot(Eigen::Map<const Eigen::VectorXd>(in, size));
        continue;
      }
      for (std::size_t j = 0; j < line.weights[row].size(); ++j) {
        const double weight = line.weights[row][j];
        const double* in = &field[(o * line.sources + line.first[row] + j) * inner];
        for (std::size_t i = 0; i < inner; ++i) {
          out[i] += weight * in[i];
        }
      }
    }
  }
}

} // namespace ionskin::history
