// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/grid/mid_width_mirror.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::electrochemistry {
namespace {

constexpr double mirror_tolerance = 1e-12;

bool edges_are_mirrored(const history::CoreHistory& history) {
  const auto edges = history::skin_y_edges(history, {0, 0.0});
  const std::size_t last = edges.size() - 1;
  for (std::size_t j = 0; j <= last; ++j) {
    if (std::abs(edges[j] + edges[last - j] - history.width) > mirror_tolerance * history.width) {
      return false;
    }
  }
  return true;
}

bool field_is_mirrored(const history::StrainGrid& grid, const history::StrainField& field) {
  const std::size_t columns = grid.columns_x(), rows = grid.columns_y();
  double largest = 0.0, difference = 0.0;
  for (std::size_t k = 0; k < grid.z_nodes.size(); ++k) {
    for (std::size_t j = 0; j < rows; ++j) {
      const double* row = field.data() + (k * rows + j) * columns;
      const double* mirror = field.data() + (k * rows + rows - 1 - j) * columns;
      for (std::size_t i = 0; i < columns; ++i) {
        largest = std::max(largest, std::abs(row[i]));
        difference = std::max(difference, std::abs(row[i] - mirror[i]));
      }
    }
  }
  return difference <= mirror_tolerance * largest;
}

} // namespace

bool is_mirrored(const history::CoreHistory& history) {
  if (!history.slider_y.empty() || !edges_are_mirrored(history)) {
    return false;
  }
  return std::ranges::all_of(history.channels, [&](const history::HistoryChannel& channel) {
    const history::StrainField* seen = nullptr;
    return std::ranges::all_of(channel.samples, [&](const auto& field) {
      const bool known = field.get() == seen;
      seen = field.get();
      return known || field_is_mirrored(history.grid, *field);
    });
  });
}

MidWidthMirror::MidWidthMirror(const TransportGrid& whole, const history::CoreHistory& history,
                               bool readout_is_mirrored)
    : solved_(whole),
      halved_(readout_is_mirrored && (whole.y_edges.size() - 1) % 2 == 0 && is_mirrored(history)) {
  if (halved_) {
    solved_.y_edges.resize((whole.y_edges.size() + 1) / 2);
  }
}

std::vector<double> MidWidthMirror::whole(std::span<const double> solved) const {
  std::vector<double> result(solved.begin(), solved.end());
  if (!halved_) {
    return result;
  }
  const std::size_t columns = solved_.x_edges.size() - 1, rows = solved_.y_edges.size() - 1;
  result.resize(2 * solved.size());
  for (std::size_t row = 0; row < solved.size() / columns; ++row) {
    const std::size_t level = row / rows, j = row % rows;
    const auto from = solved.begin() + static_cast<std::ptrdiff_t>(row * columns);
    const auto to = [&](std::size_t whole_row) {
      return result.begin() + static_cast<std::ptrdiff_t>((2 * rows * level + whole_row) * columns);
    };
    std::copy_n(from, columns, to(j));
    std::copy_n(from, columns, to(2 * rows - 1 - j));
  }
  return result;
}

void MidWidthMirror::complete(WallCharges& charges) const {
  if (halved_) {
    charges.bottom = whole(charges.bottom);
    charges.top = whole(charges.top);
    charges.total_bottom *= 2.0;
    charges.total_top *= 2.0;
  }
}

} // namespace ionskin::electrochemistry
