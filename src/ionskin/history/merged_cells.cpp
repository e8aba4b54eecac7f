// SPDX-License-Identifier: Apache-2.0
#include "ionskin/history/merged_cells.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace ionskin::history {
namespace {

/// Indices of the edges that remain: every other one, counted from both ends up to the middle.
std::vector<std::size_t> kept_edges(std::size_t edges) {
  const std::size_t last = edges - 1;
  std::vector<std::size_t> low, high;
  for (std::size_t i = 0; 2 * i <= last; i += 2) {
    low.push_back(i);
    high.push_back(last - i);
  }
  if (low.back() == high.back()) {
    high.pop_back();
  }
  low.insert(low.end(), high.rbegin(), high.rend());
  return low;
}

/// Means of a field over merged cells along one direction.
/// @param inner number of values between neighbours along that direction
StrainField merged(const StrainField& field, const std::vector<double>& edges,
                   const std::vector<std::size_t>& kept, std::size_t inner) {
  const std::size_t cells = edges.size() - 1, outer = field.size() / (cells * inner);
  StrainField result;
  result.reserve(outer * (kept.size() - 1) * inner);
  for (std::size_t o = 0; o < outer; ++o) {
    for (std::size_t k = 0; k + 1 < kept.size(); ++k) {
      const double width = edges[kept[k + 1]] - edges[kept[k]];
      for (std::size_t i = 0; i < inner; ++i) {
        double sum = 0;
        for (std::size_t cell = kept[k]; cell < kept[k + 1]; ++cell) {
          sum += field[(o * cells + cell) * inner + i] * (edges[cell + 1] - edges[cell]);
        }
        result.push_back(sum / width);
      }
    }
  }
  return result;
}

std::vector<double> chosen(const std::vector<double>& edges, const std::vector<std::size_t>& kept) {
  std::vector<double> result;
  for (const std::size_t i : kept) {
    result.push_back(edges[i]);
  }
  return result;
}

} // namespace

CoreHistory merge_cells(const CoreHistory& history) {
  CoreHistory result = history;
  const StrainGrid& grid = history.grid;
  const auto kept_x = kept_edges(grid.x_edges.size()), kept_y = kept_edges(grid.y_edges.size());
  result.grid.x_edges = chosen(grid.x_edges, kept_x);
  result.grid.y_edges = chosen(grid.y_edges, kept_y);
  std::map<const StrainField*, std::shared_ptr<const StrainField>> known;
  for (HistoryChannel& channel : result.channels) {
    for (auto& field : channel.samples) {
      auto& shared = known[field.get()];
      if (!shared) {
        const StrainField along_x = merged(*field, grid.x_edges, kept_x, 1);
        shared = std::make_shared<const StrainField>(
            merged(along_x, grid.y_edges, kept_y, result.grid.columns_x()));
      }
      field = shared;
    }
  }
  return result;
}

} // namespace ionskin::history
