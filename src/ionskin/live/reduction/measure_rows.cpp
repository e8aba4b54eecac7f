// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/reduction/measure_rows.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/history/core_history.hpp"
#include "ionskin/laws/shear/shear_measure.hpp"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace ionskin::live {
namespace {

/// Combinations of strain components whose norm, or only value, is a shear measure. A measure that
/// is linear in the strain gives its own coefficients; otherwise its square must be a quadratic
/// form, whose eigenvectors times the roots of their eigenvalues are the rows. Throws UserError for
/// a measure that is neither.
MeasureRows rows_of(const laws::ShearMeasure& measure) {
  constexpr std::size_t components = 6;
  const auto unit = [&](std::size_t i, std::size_t j) {
    std::array<double, components> strain{};
    strain[i] += 1;
    strain[j] += 1;
    return measure.at(strain);
  };
  constexpr std::array<double, components> probe{0.3, -0.7, 0.2, 0.5, -0.4, 0.9};
  std::array<double, components> opposite{};
  std::ranges::transform(probe, opposite.begin(), std::negate<>{});
  const double expected = measure.at(probe);
  MeasureRows rows;
  if (measure.at(opposite) == -expected) {
    rows.emplace_back();
    for (std::size_t i = 0; i < components; ++i) {
      rows[0][i] = unit(i, i) / 2;
    }
  } else {
    Eigen::Matrix<double, components, components> form;
    for (std::size_t i = 0; i < components; ++i) {
      for (std::size_t j = 0; j < components; ++j) {
        const double own = std::pow(unit(i, i) / 2, 2), other = std::pow(unit(j, j) / 2, 2);
        form(static_cast<int>(i), static_cast<int>(j)) =
            i == j ? own : (std::pow(unit(i, j), 2) - own - other) / 2;
      }
    }
    const Eigen::SelfAdjointEigenSolver<decltype(form)> modes(form);
    for (int mode = 0; mode < static_cast<int>(components); ++mode) {
      const double value = modes.eigenvalues()[mode];
      if (value > 1e-12 * modes.eigenvalues().maxCoeff()) {
        rows.emplace_back();
        for (std::size_t i = 0; i < components; ++i) {
          rows.back()[i] = std::sqrt(value) * modes.eigenvectors()(static_cast<int>(i), mode);
        }
      }
    }
    if (rows.size() == 1) {
      rows.emplace_back(); // a row of zeros: a single row would keep its sign, a norm has none
    }
  }
  if (!(std::abs(value_of(rows, probe) - expected) <= 1e-9 * std::abs(expected))) {
    throw UserError(fmt::format(
        "coupling.measure = \"{}\": a live skin supports only measures that are linear in the "
        "strain, or the root of a quadratic form of it\n  = choose another measure",
        measure.name));
  }
  return rows;
}

} // namespace

double value_of(const MeasureRows& rows, const std::array<double, 6>& strain) {
  double square = 0, value = 0;
  for (const auto& row : rows) {
    value = std::inner_product(row.begin(), row.end(), strain.begin(), 0.0);
    square += value * value;
  }
  return rows.size() == 1 ? value : std::sqrt(square);
}

std::array<double, 6> strain_at(const mechanics::CoreStrain& strain, std::size_t point) {
  std::array<double, 6> at{};
  for (std::size_t c = 0; c < at.size(); ++c) {
    at[c] = strain.component[c].empty() ? 0.0 : strain.component[c][point]; // empty: not computed
  }
  return at;
}

MeasureRows measure_rows(const Case& input, const std::string& channel) {
  if (channel == history::channel_name::dilation) {
    return {{-1, -1, -1, 0, 0, 0}};
  }
  return rows_of(laws::shear_measure(input.coupling.measure));
}

} // namespace ionskin::live
