// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/solver/preconditioner.hpp"

#include "ionskin/electrochemistry/equations/ion_flux.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::electrochemistry {
namespace {

/// Number of modes that one thread works on in a row; a multiple of the vector length.
constexpr std::size_t mode_granularity = 16;

/// Number of modes whose systems are solved together, so that the values that elimination wrote are
/// in the cache during substitution.
constexpr std::size_t modes_at_once = 128;

/// Number of z levels that are transformed together.
constexpr std::size_t tile_levels = 8;

/// Derivatives of the flux between two levels of the averaged state.
struct FluxDerivatives {
  double by_lower = 0, by_upper = 0, by_difference = 0;
};

FluxDerivatives flux_derivatives(double c_lower, double c_upper, double u, double spacing) {
  const Bernoulli b = bernoulli(u);
  return {b.value / spacing, (b.value + u) / spacing,
          (b.derivative * c_lower - (b.derivative + 1.0) * c_upper) / spacing};
}

/// Adds to the derivatives the contribution of the excess, which makes the difference depend on the
/// concentrations.
FluxDerivatives with_excess(const FluxDerivatives& flux, double slope_lower, double slope_upper) {
  return {flux.by_lower - flux.by_difference * slope_lower,
          flux.by_upper - flux.by_difference * slope_upper, flux.by_difference};
}

} // namespace

FastDiagonalisation::FastDiagonalisation(const ScaledGrid& grid, parallel::WorkerTeam& team,
                                         std::optional<StericExcess> excess,
                                         const WallElectrodes* electrodes,
                                         const SheetElectrodes* sheets)
    : grid_(grid), team_(team), excess_(excess), transform_(grid), mean_concentration_(grid.levels),
      mean_drive_(grid.levels), slope_(grid.levels, 0.0), share_(excess ? grid.nodes() : 0),
      lower_(grid.levels), upper_(grid.levels), inverse_00_(grid.nodes()),
      inverse_01_(grid.nodes()), inverse_10_(grid.nodes()), inverse_11_(grid.nodes()),
      balance_(grid.nodes()), poisson_(grid.nodes()), sums_(2 * grid.columns()),
      scratch_(team.size(), std::vector<float>(tile_levels * grid.columns())),
      electrodes_(electrodes), sheets_(sheets) {
  if (electrodes_ != nullptr) {
    coupling_.emplace(*electrodes_, transform_);
    for (const std::size_t a : {bottom_wall, top_wall}) {
      for (const std::size_t b : {bottom_wall, top_wall}) {
        if (electrodes_->on_bottom() || (a == top_wall && b == top_wall)) {
          wall_admittance_[a][b].resize(grid.columns());
        }
      }
    }
  }
  if (sheets_ != nullptr) {
    contact_.emplace(grid, *sheets_);
  }
}

void FastDiagonalisation::average(const IonState& state) {
  const std::size_t columns = grid_.columns();
  const auto mean = [columns](std::span<const double> field, std::size_t k) {
    const double* values = field.data() + k * columns;
    double sum = 0.0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t i = 0; i < columns; ++i) {
      sum += values[i];
    }
    return sum / static_cast<double>(columns);
  };
  team_.for_blocks(grid_.levels, 1, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t k = begin; k < end; ++k) {
      mean_concentration_[k] = mean(state.concentration(), k);
      mean_drive_[k] = mean(state.potential(), k);
      if (excess_) {
        mean_drive_[k] += excess_->excess(mean_concentration_[k]);
        slope_[k] = excess_->slope(mean_concentration_[k]);
        const double mean_room = excess_->room(mean_concentration_[k]);
        for (std::size_t i = k * columns; i < (k + 1) * columns; ++i) {
          share_[i] = excess_->room(state.concentration()[i]) / mean_room;
        }
      }
    }
  });
}

void FastDiagonalisation::factorise(const IonState& state, double step) {
  average(state);
  team_.for_blocks(grid_.columns(), mode_granularity,
                   [&](std::size_t begin, std::size_t end, std::size_t) {
                     factorise_modes(step, begin, end, begin == 0);
                   });
  if (coupling_) {
    coupling_->set_admittance(wall_admittance_);
    find_answers();
  }
  if (contact_) {
    find_answers();
    const std::size_t columns = grid_.columns();
    std::array<std::array<std::span<const float>, 2>, 2> answers;
    for (const std::size_t wall : {bottom_wall, top_wall}) {
      answers[bottom_wall][wall] = std::span(poisson_answer_[wall]).first(columns);
      answers[top_wall][wall] = std::span(poisson_answer_[wall]).last(columns);
    }
    contact_->invert(answers, SheetElectrodes::implicit_step(step));
  }
}

void FastDiagonalisation::find_answers() {
  const std::size_t columns = grid_.columns(), top = grid_.nodes() - columns;
  for (const std::size_t wall : {bottom_wall, top_wall}) {
    if (wall == bottom_wall && electrodes_ != nullptr && !electrodes_->on_bottom()) {
      continue;
    }
    std::ranges::fill(balance_, 0.0F);
    std::ranges::fill(poisson_, 0.0F);
    std::ranges::fill(std::span(poisson_).subspan(wall == bottom_wall ? 0 : top, columns), 1.0F);
    for_modes([&](std::size_t begin, std::size_t end) { solve_modes(begin, end); });
    balance_answer_[wall] = balance_;
    poisson_answer_[wall] = poisson_;
  }
}

void FastDiagonalisation::add_answers(const std::array<std::vector<float>, 2>& amounts) {
  const std::size_t columns = grid_.columns();
  team_.for_blocks(grid_.levels, tile_levels, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (const std::size_t wall : {bottom_wall, top_wall}) {
      if (amounts[wall].empty()) {
        continue;
      }
      const float* amount = amounts[wall].data();
      for (std::size_t k = begin; k < end; ++k) {
        float* x = balance_.data() + k * columns;
        float* y = poisson_.data() + k * columns;
        const float* balance = balance_answer_[wall].data() + k * columns;
        const float* poisson = poisson_answer_[wall].data() + k * columns;
#pragma omp simd
        for (std::size_t i = 0; i < columns; ++i) {
          x[i] += amount[i] * balance[i];
          y[i] += amount[i] * poisson[i];
        }
      }
    }
  });
}

std::vector<float> FastDiagonalisation::wall_charge(std::size_t wall) const {
  const std::size_t columns = grid_.columns();
  const bool bottom = wall == bottom_wall;
  const ChargeWeights weights = charge_weights(grid_, bottom ? 0 : grid_.levels - 1);
  const std::size_t here = bottom ? 0 : grid_.nodes() - columns,
                    next = bottom ? columns : here - columns;
  const auto of_ions = static_cast<float>(weights.here),
             of_next_ions = static_cast<float>(bottom ? weights.above : weights.below),
             of_potential =
                 static_cast<float>(1.0 / (bottom ? grid_.spacing.front() : grid_.spacing.back()));
  std::vector<float> charge(columns);
  for (std::size_t i = 0; i < columns; ++i) {
    charge[i] = -of_potential * poisson_[next + i] - of_ions * balance_[here + i] -
                of_next_ions * balance_[next + i];
  }
  return charge;
}

/// Eliminates blocks from the bottom up; only the call with `keep_off_diagonals` stores the blocks
/// off the diagonal, which all modes share.
void FastDiagonalisation::factorise_modes(double step, std::size_t begin, std::size_t end,
                                          bool keep_off_diagonals) {
  const std::size_t columns = grid_.columns(), top = grid_.levels - 1;
  std::vector<double> w00(end - begin, 0.0), w01(w00), w10(w00), w11(w00), metal(w00);
  // Response c, phi to a unit potential of the bottom wall, eliminated so far; the charge of the
  // bottom wall is the sum of `own`, by that response, and of the products of `by_0` and `by_1`
  // with c, phi of the level.
  const bool cuts_bottom = electrodes_ != nullptr && electrodes_->on_bottom();
  std::vector<double> answer_0, answer_1, own, by_0, by_1;
  FluxDerivatives below;
  double u00 = 0.0, u01 = 0.0, u10 = 0.0, u11 = 0.0; // upper block of the level below
  for (std::size_t k = 0; k <= top; ++k) {
    FluxDerivatives above;
    if (k < top) {
      above = flux_derivatives(mean_concentration_[k], mean_concentration_[k + 1],
                               mean_drive_[k + 1] - mean_drive_[k], grid_.spacing[k]);
      if (excess_) {
        above = with_excess(above, slope_[k], slope_[k + 1]);
      }
    }
    const bool wall = (k == 0 || k == top) && sheets_ == nullptr;
    const double height = grid_.height[k], concentration = mean_concentration_[k];
    const double up = k < top ? 1.0 / grid_.spacing[k] : 0.0;
    const double down = k > 0 ? 1.0 / grid_.spacing[k - 1] : 0.0;
    const double l00 = -step * below.by_lower, l01 = step * below.by_difference;
    const ChargeWeights charge = wall ? ChargeWeights{} : charge_weights(grid_, k);
    const double l10 = -charge.below, l11 = wall ? 0.0 : -down;
    const double flux_diagonal = above.by_lower + below.by_upper;
    // Lateral diffusion is enhanced by the thermodynamic factor 1 + c dmu/dc.
    const double diffusion = 1.0 + concentration * slope_[k];
    const double flux_potential = -above.by_difference - below.by_difference;
    const double* lambda = transform_.eigenvalues().data() + begin;
    const std::size_t offset = k * columns + begin;
    std::fill(metal.begin(), metal.end(), 0.0); // what charge moves along the walls
    if (sheets_ != nullptr && (k == 0 || k == top)) {
      const double sheet_step = SheetElectrodes::implicit_step(step);
      for (std::size_t i = 0; i < end - begin; ++i) {
        metal[i] = sheet_step * sheets_->conductance(k == 0 ? bottom_wall : top_wall) * lambda[i];
      }
      metal[0] += k == 0 && begin == 0 ? contact_->hold(sheet_step) : 0.0;
    }
    std::vector<double> by_ions, by_wall, from_bottom; // the charge of the top wall
    if (electrodes_ != nullptr && k == top) {
      const ChargeWeights ions = charge_weights(grid_, k);
      for (std::size_t i = 0; i < end - begin; ++i) {
        const double x0 = -ions.below * w00[i] - down * w10[i];
        const double x1 = -ions.below * w01[i] - down * w11[i];
        by_ions.push_back(-ions.here - x0 * u00 - x1 * u10);
        by_wall.push_back(down + height * lambda[i] - x0 * u01 - x1 * u11);
        if (cuts_bottom) {
          from_bottom.push_back(-ions.below * answer_0[i] - down * answer_1[i]);
        }
      }
    }
#pragma omp simd
    for (std::size_t i = 0; i < end - begin; ++i) {
      const double x00 = l00 * w00[i] + l01 * w10[i], x01 = l00 * w01[i] + l01 * w11[i];
      const double x10 = l10 * w00[i] + l11 * w10[i], x11 = l10 * w01[i] + l11 * w11[i];
      const double lateral = height * lambda[i];
      const double d00 =
          height + step * (flux_diagonal + lateral * diffusion) - x00 * u00 - x01 * u10;
      const double d01 = step * (flux_potential + lateral * concentration) - x00 * u01 - x01 * u11;
      const double d10 = -charge.here - x10 * u00 - x11 * u10;
      const double d11 = (wall ? 1.0 : up + down + lateral + metal[i]) - x10 * u01 - x11 * u11;
      const double inverse_determinant = 1.0 / (d00 * d11 - d01 * d10);
      w00[i] = d11 * inverse_determinant;
      w01[i] = -d01 * inverse_determinant;
      w10[i] = -d10 * inverse_determinant;
      w11[i] = d00 * inverse_determinant;
      inverse_00_[offset + i] = static_cast<float>(w00[i]);
      inverse_01_[offset + i] = static_cast<float>(w01[i]);
      inverse_10_[offset + i] = static_cast<float>(w10[i]);
      inverse_11_[offset + i] = static_cast<float>(w11[i]);
    }
    for (std::size_t i = 0; i < by_ions.size(); ++i) {
      wall_admittance_[top_wall][top_wall][begin + i] = by_wall[i] + by_ions[i] * w01[i];
    }
    if (cuts_bottom) {
      const ChargeWeights ions = charge_weights(grid_, k);
      if (k == 0) {
        answer_0 = w01;
        answer_1 = w11;
        own.assign(end - begin, 0.0);
        by_0.assign(end - begin, -ions.here);
        by_1.resize(end - begin);
        for (std::size_t i = 0; i < end - begin; ++i) {
          by_1[i] = up + height * lambda[i];
        }
      } else {
        for (std::size_t i = 0; i < end - begin; ++i) {
          const double balance = -l00 * answer_0[i] - l01 * answer_1[i];
          const double poisson = -l10 * answer_0[i] - l11 * answer_1[i];
          answer_0[i] = w00[i] * balance + w01[i] * poisson;
          answer_1[i] = w10[i] * balance + w11[i] * poisson;
        }
      }
      for (std::size_t i = 0; i < end - begin; ++i) {
        own[i] += by_0[i] * answer_0[i] + by_1[i] * answer_1[i];
      }
      for (std::size_t i = 0; i < from_bottom.size(); ++i) {
        wall_admittance_[bottom_wall][bottom_wall][begin + i] = own[i];
        wall_admittance_[bottom_wall][top_wall][begin + i] = by_0[i] * w01[i] + by_1[i] * w11[i];
        wall_admittance_[top_wall][bottom_wall][begin + i] =
            from_bottom[i] + by_ions[i] * answer_0[i];
      }
    }
    u00 = -step * above.by_upper;
    u01 = step * above.by_difference;
    u10 = -charge.above;
    u11 = wall ? 0.0 : -up;
    if (cuts_bottom && k < top) {
      const ChargeWeights ions = charge_weights(grid_, 0);
      for (std::size_t i = 0; i < end - begin; ++i) {
        const double x0 = by_0[i] * w00[i] + by_1[i] * w10[i];
        const double x1 = by_0[i] * w01[i] + by_1[i] * w11[i];
        by_0[i] = -x0 * u00 - x1 * u10 - (k == 0 ? ions.above : 0.0);
        by_1[i] = -x0 * u01 - x1 * u11 - (k == 0 ? up : 0.0);
      }
    }
    if (keep_off_diagonals) {
      lower_[k] = {static_cast<float>(l00), static_cast<float>(l01), static_cast<float>(l10),
                   static_cast<float>(l11)};
      upper_[k] = {static_cast<float>(u00), static_cast<float>(u01), static_cast<float>(u10),
                   static_cast<float>(u11)};
    }
    below = above;
  }
}

/// Calls `body(first node, number of nodes, scratch)` on tiles of levels. The tiles do not depend
/// on the number of threads, because the rounding of a matrix product depends on its size.
template <class Body> void FastDiagonalisation::for_tiles(const Body& body) {
  const std::size_t columns = grid_.columns();
  team_.for_blocks(grid_.levels, tile_levels,
                   [&](std::size_t begin, std::size_t end, std::size_t worker) {
                     for (std::size_t k = begin; k < end; k += tile_levels) {
                       const std::size_t levels = std::min(tile_levels, end - k);
                       body(k * columns, levels * columns, std::span(scratch_[worker]));
                     }
                   });
}

/// Calls `body(begin, end)` on groups of modes.
template <class Body> void FastDiagonalisation::for_modes(const Body& body) {
  team_.for_blocks(grid_.columns(), mode_granularity,
                   [&](std::size_t begin, std::size_t end, std::size_t) {
                     for (std::size_t mode = begin; mode < end; mode += modes_at_once) {
                       body(mode, std::min(mode + modes_at_once, end));
                     }
                   });
}

void FastDiagonalisation::forward(std::span<const double> residual) {
  const std::size_t nodes = grid_.nodes();
  const std::span balance(balance_), poisson(poisson_);
  for_tiles([&](std::size_t first, std::size_t count, std::span<float> scratch) {
    transform_.forward(residual.subspan(first, count), balance.subspan(first, count), scratch);
    transform_.forward(residual.subspan(nodes + first, count), poisson.subspan(first, count),
                       scratch);
  });
}

void FastDiagonalisation::apply(std::span<const double> residual, std::span<double> out) {
  const std::size_t columns = grid_.columns();
  forward(residual);
  for_modes([&](std::size_t begin, std::size_t end) { solve_modes(begin, end); });
  if (contact_) {
    add_answers(
        contact_->charges({std::span(poisson_).first(columns), std::span(poisson_).last(columns)}));
  }
  backward(out);
}

void FastDiagonalisation::apply(const ElectrodeStage& stage, std::span<const double> residual,
                                std::span<double> out) {
  const std::size_t columns = grid_.columns(), top = grid_.nodes() - columns;
  forward(residual);
  std::array<std::vector<float>, 2> asked;
  for (const std::size_t wall : {bottom_wall, top_wall}) {
    if (wall == top_wall || electrodes_->on_bottom()) {
      const std::span charge = std::span(poisson_).subspan(wall == bottom_wall ? 0 : top, columns);
      asked[wall].assign(charge.begin(), charge.end());
      std::ranges::fill(charge, 0.0F);
    }
  }
  for_modes([&](std::size_t begin, std::size_t end) { solve_modes(begin, end); });
  for (const std::size_t wall : {bottom_wall, top_wall}) {
    if (!asked[wall].empty()) {
      const std::vector<float> there = wall_charge(wall);
      for (std::size_t i = 0; i < columns; ++i) {
        asked[wall][i] -= there[i];
      }
    }
  }
  const std::vector<double> potentials = coupling_->potentials(stage, asked);
  add_answers(coupling_->spread(potentials));
  backward(out);
  electrodes_->spread(potentials, out.last(grid_.nodes())); // in double precision
}

void FastDiagonalisation::backward(std::span<double> out) {
  const std::size_t nodes = grid_.nodes();
  const std::span balance(balance_), poisson(poisson_);
  for_tiles([&](std::size_t first, std::size_t count, std::span<float> scratch) {
    transform_.backward(balance.subspan(first, count), out.subspan(first, count), scratch);
    transform_.backward(poisson.subspan(first, count), out.subspan(nodes + first, count), scratch);
    if (excess_) {
      for (std::size_t i = first; i < first + count; ++i) {
        out[i] *= share_[i];
      }
    }
  });
}

// The sums over the levels and the transform commute, so that only two levels are transformed back.
std::array<std::vector<double>, 2>
FastDiagonalisation::damped_sums(std::span<const double> concentration,
                                 const std::array<std::vector<double>, 2>& weights) {
  const std::size_t columns = grid_.columns();
  for_tiles([&](std::size_t first, std::size_t count, std::span<float> scratch) {
    const std::span balance = std::span(balance_).subspan(first, count),
                    poisson = std::span(poisson_).subspan(first, count);
    transform_.forward(concentration.subspan(first, count), balance, scratch);
    for (std::size_t level = 0; level < count; level += columns) {
      const auto height = static_cast<float>(grid_.height[(first + level) / columns]);
      for (std::size_t i = level; i < level + columns; ++i) {
        balance[i] *= height;
      }
    }
    std::ranges::fill(poisson, 0.0F);
  });
  for_modes([&](std::size_t begin, std::size_t end) {
    solve_modes(begin, end);
    for (std::size_t w = 0; w < 2; ++w) {
      sum_levels(weights[w], w, begin, end);
    }
  });
  std::array<std::vector<double>, 2> sums;
  for (std::size_t w = 0; w < 2; ++w) {
    sums[w].resize(columns);
    transform_.backward(std::span(sums_).subspan(w * columns, columns), sums[w], scratch_.front());
  }
  return sums;
}

void FastDiagonalisation::sum_levels(std::span<const double> weights, std::size_t row,
                                     std::size_t begin, std::size_t end) {
  const std::size_t columns = grid_.columns();
  float* sum = sums_.data() + row * columns;
  std::fill(sum + begin, sum + end, 0.0F);
  for (std::size_t k = 0; k < grid_.levels; ++k) {
    const auto weight = static_cast<float>(weights[k]);
    const float* level = balance_.data() + k * columns;
#pragma omp simd
    for (std::size_t i = begin; i < end; ++i) {
      sum[i] += weight * level[i];
    }
  }
}

void FastDiagonalisation::solve_modes(std::size_t begin, std::size_t end) {
  for (std::size_t k = 0; k < grid_.levels; ++k) {
    eliminate_level(k, begin, end);
  }
  substitute(begin, end);
}

void FastDiagonalisation::eliminate_level(std::size_t level, std::size_t begin, std::size_t end) {
  const std::size_t columns = grid_.columns(), offset = level * columns;
  float* x = balance_.data() + offset;
  float* y = poisson_.data() + offset;
  const float* w00 = inverse_00_.data() + offset;
  const float* w01 = inverse_01_.data() + offset;
  const float* w10 = inverse_10_.data() + offset;
  const float* w11 = inverse_11_.data() + offset;
  const OffDiagonal l = lower_[level];
  const float* x_below = level > 0 ? x - columns : x;
  const float* y_below = level > 0 ? y - columns : y;
#pragma omp simd
  for (std::size_t i = begin; i < end; ++i) {
    const float r = x[i] - l.balance_concentration * x_below[i] - l.balance_potential * y_below[i];
    const float s = y[i] - l.poisson_concentration * x_below[i] - l.poisson_potential * y_below[i];
    x[i] = w00[i] * r + w01[i] * s;
    y[i] = w10[i] * r + w11[i] * s;
  }
}

void FastDiagonalisation::substitute(std::size_t begin, std::size_t end) {
  const std::size_t columns = grid_.columns();
  for (std::size_t k = grid_.levels - 1; k-- > 0;) {
    const std::size_t offset = k * columns;
    float* x = balance_.data() + offset;
    float* y = poisson_.data() + offset;
    const float* w00 = inverse_00_.data() + offset;
    const float* w01 = inverse_01_.data() + offset;
    const float* w10 = inverse_10_.data() + offset;
    const float* w11 = inverse_11_.data() + offset;
    const OffDiagonal u = upper_[k];
    const float* x_above = x + columns;
    const float* y_above = y + columns;
#pragma omp simd
    for (std::size_t i = begin; i < end; ++i) {
      const float r = u.balance_concentration * x_above[i] + u.balance_potential * y_above[i];
      const float s = u.poisson_concentration * x_above[i] + u.poisson_potential * y_above[i];
      x[i] -= w00[i] * r + w01[i] * s;
      y[i] -= w10[i] * r + w11[i] * s;
    }
  }
}

} // namespace ionskin::electrochemistry
