// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/equations/transport_equations.hpp"

#include <algorithm>

namespace ionskin::electrochemistry {
namespace {

/// Number of nodes in a row whose drive one thread computes.
constexpr std::size_t drive_granularity = 1024;

} // namespace

TransportEquations::Workspace::Workspace(const ScaledGrid& grid)
    : thickness_flux(grid.columns()), lateral_flux(grid), flux_below(grid.columns()),
      flux_above(grid.columns()), lateral_ions(grid.columns()), lateral_field(grid.columns()),
      drive_change(grid.columns()) {}

double top_potential(const StageProblem& problem, const TerminalVoltage& voltage,
                     std::span<const double> concentration) {
  return problem.circuit
             ? problem.potential_bottom +
                   voltage.voltage(*problem.circuit, concentration, problem.fixed_charge)
             : problem.potential_top;
}

TransportEquations::TransportEquations(const ScaledGrid& grid, parallel::WorkerTeam& team,
                                       std::optional<StericExcess> excess,
                                       const WallElectrodes* electrodes,
                                       const SheetElectrodes* sheets)
    : grid_(grid), team_(team), excess_(excess), voltage_(grid), electrodes_(electrodes),
      sheets_(sheets), by_lower_(grid.nodes() - grid.columns()), by_upper_(by_lower_.size()),
      by_difference_(by_lower_.size()) {
  for (std::size_t i = 0; i < team.size(); ++i) {
    workspaces_.emplace_back(grid);
  }
}

std::span<const double> TransportEquations::driving(const StageProblem& problem,
                                                    const IonState& state,
                                                    std::vector<double>& drive) {
  if (!excess_ && problem.drive.empty()) {
    return state.potential();
  }
  drive.resize(grid_.nodes());
  team_.for_blocks(grid_.nodes(), drive_granularity,
                   [&](std::size_t begin, std::size_t end, std::size_t) {
                     const std::size_t count = end - begin;
                     const auto potential = state.potential().subspan(begin, count);
                     const auto sum = std::span(drive).subspan(begin, count);
                     if (excess_) {
                       excess_->drive(state.concentration().subspan(begin, count), potential, sum);
                     } else {
                       std::ranges::copy(potential, sum.begin());
                     }
                     for (std::size_t i = begin; i < end && !problem.drive.empty(); ++i) {
                       drive[i] += problem.drive[i];
                     }
                   });
  return drive;
}

void TransportEquations::residual(const StageProblem& problem, const IonState& state,
                                  std::span<double> out) {
  const double top = top_potential(problem, voltage_, state.concentration());
  const std::span<const double> drive = driving(problem, state, drive_);
  team_.for_blocks(grid_.levels, 1, [&](std::size_t begin, std::size_t end, std::size_t worker) {
    residual_levels(problem, top, state, drive, begin, end, workspaces_[worker], out);
  });
  if (problem.electrodes != nullptr) {
    add_circuits(*problem.electrodes, state.potential(), true, out.last(grid_.nodes()));
  }
  if (problem.sheets != nullptr) {
    const SheetStage& stage = *problem.sheets;
    const std::size_t columns = grid_.columns();
    const double lead = sheets_->lead_potential(
        stage, problem.potential_bottom, problem.potential_top, state.potential().last(columns));
    const std::span<double> charges = out.last(grid_.nodes());
    for (std::size_t i = 0; i < columns; ++i) {
      charges[i] -= stage.start[bottom_wall][i];
      charges[grid_.nodes() - columns + i] -= stage.start[top_wall][i];
    }
    take_inflow(stage, state.potential(), problem.potential_bottom, lead, charges);
  }
}

void TransportEquations::take_inflow(const SheetStage& stage, std::span<const double> potentials,
                                     double lead_bottom, double lead_top,
                                     std::span<double> charges) const {
  const std::size_t columns = grid_.columns();
  sheets_->take_inflow(bottom_wall, stage.step, potentials.first(columns), lead_bottom,
                       charges.first(columns));
  sheets_->take_inflow(top_wall, stage.step, potentials.last(columns), lead_top,
                       charges.last(columns));
}

void TransportEquations::add_circuits(const ElectrodeStage& stage,
                                      std::span<const double> potentials, bool from_start,
                                      std::span<double> charges) const {
  std::vector<double> asked = electrodes_->potentials(potentials);
  for (std::size_t e = 0; e < asked.size(); ++e) {
    asked[e] = stage.holds(e)
                   ? 0.0
                   : stage.conductance[e] * asked[e] - (from_start ? stage.start[e] : 0.0);
  }
  electrodes_->add(asked, charges);
}

bool TransportEquations::varies(std::size_t wall, const ElectrodeStage* electrodes,
                                const SheetStage* sheets) const {
  return sheets != nullptr ||
         (electrodes != nullptr && (wall == top_wall || electrodes_->on_bottom()));
}

void TransportEquations::residual_levels(const StageProblem& problem, double potential_top,
                                         const IonState& state, std::span<const double> drive,
                                         std::size_t begin, std::size_t end, Workspace& work,
                                         std::span<double> out) const {
  const std::size_t columns = grid_.columns(), nodes = grid_.nodes(), top = grid_.levels - 1;
  const auto level = [columns](std::span<const double> field, std::size_t k) {
    return field.subspan(k * columns, columns);
  };
  const auto c = state.concentration(), phi = state.potential();
  const bool bottom_varies = varies(bottom_wall, problem.electrodes, problem.sheets),
             top_varies = varies(top_wall, problem.electrodes, problem.sheets);
  const auto flux = [&](std::size_t k, std::span<double> result) {
    work.thickness_flux.evaluate(level(c, k), level(c, k + 1), level(drive, k), level(drive, k + 1),
                                 grid_.spacing[k], result);
  };
  if (begin == 0) {
    std::fill(work.flux_below.begin(), work.flux_below.end(), 0.0);
  } else {
    flux(begin - 1, work.flux_below);
  }
  for (std::size_t k = begin; k < end; ++k) {
    if (k == top) {
      std::fill(work.flux_above.begin(), work.flux_above.end(), 0.0);
    } else {
      flux(k, work.flux_above);
    }
    work.lateral_flux.inflow(level(c, k), level(drive, k), level(phi, k), work.lateral_ions,
                             work.lateral_field);
    const double height = grid_.height[k], step = problem.step;
    const double* c_k = c.data() + k * columns;
    const double* start = problem.start.data() + k * columns;
    const double* above = work.flux_above.data();
    const double* below = work.flux_below.data();
    const double* inflow = work.lateral_ions.data();
    double* balance = out.data() + k * columns;
#pragma omp simd
    for (std::size_t i = 0; i < columns; ++i) {
      balance[i] = height * (c_k[i] - start[i]) + step * (above[i] - below[i] - height * inflow[i]);
    }
    double* poisson = out.data() + nodes + k * columns;
    const double* phi_k = phi.data() + k * columns;
    if (k == 0 && bottom_varies) {
      const double up = 1.0 / grid_.spacing[k];
      const double* phi_above = phi_k + columns;
      const double* field = work.lateral_field.data();
      const double* fixed = problem.fixed_charge.data() + k * columns;
      const double* c_above = c_k + columns;
      const ChargeWeights weight = charge_weights(grid_, k);
#pragma omp simd
      for (std::size_t i = 0; i < columns; ++i) {
        const double charge = weight.here * (c_k[i] - 1.0) + weight.above * (c_above[i] - 1.0) -
                              height * (fixed[i] - 1.0);
        poisson[i] = up * (phi_k[i] - phi_above[i]) - height * field[i] - charge;
      }
    } else if (k == top && top_varies) {
      const double down = 1.0 / grid_.spacing[k - 1];
      const double* phi_below = phi_k - columns;
      const double* field = work.lateral_field.data();
      const double* fixed = problem.fixed_charge.data() + k * columns;
      const double* c_below = c_k - columns;
      const ChargeWeights weight = charge_weights(grid_, k);
#pragma omp simd
      for (std::size_t i = 0; i < columns; ++i) {
        const double charge = weight.below * (c_below[i] - 1.0) + weight.here * (c_k[i] - 1.0) -
                              height * (fixed[i] - 1.0);
        poisson[i] = down * (phi_k[i] - phi_below[i]) - height * field[i] - charge;
      }
    } else if (k == 0 || k == top) {
      const double wall = k == 0 ? problem.potential_bottom : potential_top;
      for (std::size_t i = 0; i < columns; ++i) {
        poisson[i] = phi_k[i] - wall;
      }
    } else {
      const double up = 1.0 / grid_.spacing[k], down = 1.0 / grid_.spacing[k - 1];
      const double* phi_above = phi_k + columns;
      const double* phi_below = phi_k - columns;
      const double* field = work.lateral_field.data();
      const double* fixed = problem.fixed_charge.data() + k * columns;
      const double* c_above = c_k + columns;
      const double* c_below = c_k - columns;
      const ChargeWeights weight = charge_weights(grid_, k);
#pragma omp simd
      for (std::size_t i = 0; i < columns; ++i) {
        // Departures from 1 are summed, so that a core at rest carries exactly no charge.
        const double charge = weight.below * (c_below[i] - 1.0) + weight.here * (c_k[i] - 1.0) +
                              weight.above * (c_above[i] - 1.0) - height * (fixed[i] - 1.0);
        poisson[i] = up * (phi_k[i] - phi_above[i]) + down * (phi_k[i] - phi_below[i]) -
                     height * field[i] - charge;
      }
    }
    work.flux_below.swap(work.flux_above);
  }
}

void TransportEquations::linearise(const StageProblem& problem, const IonState& state) {
  state_ = &state;
  step_ = problem.step;
  circuit_ = problem.circuit;
  electrode_stage_ = problem.electrodes;
  sheet_stage_ = problem.sheets;
  const std::size_t columns = grid_.columns();
  state_drive_ = driving(problem, state, kept_drive_);
  const auto c = state.concentration(), drive = state_drive_;
  team_.for_blocks(grid_.levels - 1, 1,
                   [&](std::size_t begin, std::size_t end, std::size_t worker) {
                     for (std::size_t k = begin; k < end; ++k) {
                       const std::size_t lower = k * columns, upper = lower + columns;
                       workspaces_[worker].thickness_flux.derivatives(
                           c.subspan(lower, columns), c.subspan(upper, columns),
                           drive.subspan(lower, columns), drive.subspan(upper, columns),
                           grid_.spacing[k], std::span(by_lower_).subspan(lower, columns),
                           std::span(by_upper_).subspan(lower, columns),
                           std::span(by_difference_).subspan(lower, columns));
                       if (excess_) {
                         add_excess(k, c);
                       }
                     }
                   });
}

void TransportEquations::add_excess(std::size_t interface, std::span<const double> concentration) {
  const std::size_t columns = grid_.columns(), offset = interface * columns;
  const double* c = concentration.data() + offset;
  double* lower = by_lower_.data() + offset;
  double* upper = by_upper_.data() + offset;
  const double* difference = by_difference_.data() + offset;
  for (std::size_t i = 0; i < columns; ++i) {
    lower[i] -= difference[i] * excess_->slope(c[i]);
    upper[i] -= difference[i] * excess_->slope(c[columns + i]);
  }
}

void TransportEquations::apply_jacobian(std::span<const double> direction, std::span<double> out) {
  const double potential_change =
      circuit_ ? voltage_.change(*circuit_, direction.first(grid_.nodes())) : 0.0;
  team_.for_blocks(grid_.levels, 1, [&](std::size_t begin, std::size_t end, std::size_t worker) {
    jacobian_levels(direction, potential_change, begin, end, workspaces_[worker], out);
  });
  if (electrode_stage_ != nullptr) {
    add_circuits(*electrode_stage_, direction.last(grid_.nodes()), false, out.last(grid_.nodes()));
  }
  if (sheet_stage_ != nullptr) {
    const double lead = sheets_->lead_change(*sheet_stage_, direction.last(grid_.columns()));
    take_inflow(*sheet_stage_, direction.last(grid_.nodes()), 0.0, lead, out.last(grid_.nodes()));
  }
}

/// Computes the change of the flux between the z levels `interface` and `interface` + 1.
void TransportEquations::flux_change(std::size_t interface, std::span<const double> direction,
                                     std::span<double> flux) const {
  const std::size_t columns = grid_.columns(), offset = interface * columns;
  const double* dc = direction.data() + offset;
  const double* dphi = direction.data() + grid_.nodes() + offset;
  const double* lower = by_lower_.data() + offset;
  const double* upper = by_upper_.data() + offset;
  const double* difference = by_difference_.data() + offset;
#pragma omp simd
  for (std::size_t i = 0; i < columns; ++i) {
    flux[i] = lower[i] * dc[i] - upper[i] * dc[columns + i] +
              difference[i] * (dphi[columns + i] - dphi[i]);
  }
}

void TransportEquations::jacobian_levels(std::span<const double> direction, double potential_change,
                                         std::size_t begin, std::size_t end, Workspace& work,
                                         std::span<double> out) const {
  const std::size_t columns = grid_.columns(), nodes = grid_.nodes(), top = grid_.levels - 1;
  const auto level = [columns](std::span<const double> field, std::size_t k) {
    return field.subspan(k * columns, columns);
  };
  const auto d_concentration = direction.first(nodes), d_potential = direction.last(nodes);
  const bool bottom_varies = varies(bottom_wall, electrode_stage_, sheet_stage_),
             top_varies = varies(top_wall, electrode_stage_, sheet_stage_);
  if (begin == 0) {
    std::fill(work.flux_below.begin(), work.flux_below.end(), 0.0);
  } else {
    flux_change(begin - 1, direction, work.flux_below);
  }
  for (std::size_t k = begin; k < end; ++k) {
    if (k == top) {
      std::fill(work.flux_above.begin(), work.flux_above.end(), 0.0);
    } else {
      flux_change(k, direction, work.flux_above);
    }
    const auto c = level(state_->concentration(), k), drive = level(state_drive_, k);
    const auto d_c = level(d_concentration, k), d_phi = level(d_potential, k);
    std::span<const double> d_drive = d_phi;
    if (excess_) {
      excess_->drive_change(c, d_c, d_phi, work.drive_change);
      d_drive = work.drive_change;
    }
    work.lateral_flux.inflow_change(c, drive, d_c, d_drive, d_phi, work.lateral_ions,
                                    work.lateral_field);
    const double height = grid_.height[k], step = step_;
    const double* dc = direction.data() + k * columns;
    const double* above = work.flux_above.data();
    const double* below = work.flux_below.data();
    const double* inflow = work.lateral_ions.data();
    double* balance = out.data() + k * columns;
#pragma omp simd
    for (std::size_t i = 0; i < columns; ++i) {
      balance[i] = height * dc[i] + step * (above[i] - below[i] - height * inflow[i]);
    }
    double* poisson = out.data() + nodes + k * columns;
    const double* dphi = direction.data() + nodes + k * columns;
    if (k == 0 && bottom_varies) {
      const double up = 1.0 / grid_.spacing[k];
      const double* dphi_above = dphi + columns;
      const double* field = work.lateral_field.data();
      const double* dc_above = dc + columns;
      const ChargeWeights weight = charge_weights(grid_, k);
#pragma omp simd
      for (std::size_t i = 0; i < columns; ++i) {
        poisson[i] = up * (dphi[i] - dphi_above[i]) - height * field[i] - weight.here * dc[i] -
                     weight.above * dc_above[i];
      }
    } else if (k == top && top_varies) {
      const double down = 1.0 / grid_.spacing[k - 1];
      const double* dphi_below = dphi - columns;
      const double* field = work.lateral_field.data();
      const double* dc_below = dc - columns;
      const ChargeWeights weight = charge_weights(grid_, k);
#pragma omp simd
      for (std::size_t i = 0; i < columns; ++i) {
        poisson[i] = down * (dphi[i] - dphi_below[i]) - height * field[i] -
                     weight.below * dc_below[i] - weight.here * dc[i];
      }
    } else if (k == 0 || k == top) {
      const double wall = k == 0 ? 0.0 : potential_change;
      for (std::size_t i = 0; i < columns; ++i) {
        poisson[i] = dphi[i] - wall;
      }
    } else {
      const double up = 1.0 / grid_.spacing[k], down = 1.0 / grid_.spacing[k - 1];
      const double* dphi_above = dphi + columns;
      const double* dphi_below = dphi - columns;
      const double* field = work.lateral_field.data();
      const double* dc_above = dc + columns;
      const double* dc_below = dc - columns;
      const ChargeWeights weight = charge_weights(grid_, k);
#pragma omp simd
      for (std::size_t i = 0; i < columns; ++i) {
        const double charge =
            weight.below * dc_below[i] + weight.here * dc[i] + weight.above * dc_above[i];
        poisson[i] = up * (dphi[i] - dphi_above[i]) + down * (dphi[i] - dphi_below[i]) -
                     height * field[i] - charge;
      }
    }
    work.flux_below.swap(work.flux_above);
  }
}

} // namespace ionskin::electrochemistry
