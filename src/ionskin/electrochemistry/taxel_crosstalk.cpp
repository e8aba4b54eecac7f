// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/taxel_crosstalk.hpp"

#include "ionskin/electrochemistry/equations/steric_excess.hpp"
#include "ionskin/electrochemistry/output/ion_state.hpp"
#include "ionskin/electrochemistry/solver/preconditioner.hpp"
#include "ionskin/parallel/worker_team.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ionskin::electrochemistry {

std::optional<double> taxel_crosstalk(const Case& input, const history::CoreHistory& history) {
  const TransportGrid grid = make_transport_grid(input, history);
  const DerivedScales scales = derive_scales(input.electrochemistry, history.core_thickness());
  const std::optional<CutElectrode> cut =
      cut_electrode(input, scales, grid, MidWidthMirror(grid, history, false));
  std::vector<Eigen::Index> own;
  for (std::size_t i = 0; cut && i < input.readout.taxels.size(); ++i) {
    if (input.readout.has_own_circuit(i)) {
      own.push_back(static_cast<Eigen::Index>(cut->conductor_of_segment[i]));
    }
  }
  if (own.size() < 2) {
    return std::nullopt;
  }
  const ScaledGrid scaled = scale_grid(grid, scales.debye_length, scales.area_ratio);
  parallel::WorkerTeam team(1);
  FastDiagonalisation cell(scaled, team, steric_excess(input.electrochemistry), &cut->conductors);
  IonState rest(scaled.nodes());
  std::ranges::fill(rest.concentration(), 1.0);
  const double step = input.readout.sample_interval / scales.relaxation_time;
  cell.factorise(rest, step);
  const auto count = static_cast<Eigen::Index>(cut->conductors.size());
  const Eigen::MatrixXd admittance =
      Eigen::Map<const Eigen::MatrixXd>(cell.electrode_admittance().data(), count, count);

  // The circuits of a scan are those while the first row is read.
  const std::vector<std::optional<ScaledAdmittance>> circuits =
      cut->circuits(input.readout.scan, 0);
  Eigen::MatrixXd system = admittance;
  for (Eigen::Index e = 0; e < count; ++e) {
    const auto& circuit = circuits[static_cast<std::size_t>(e)];
    if (circuit) {
      system(e, e) += step * circuit->conductance + circuit->capacitance;
    } else {
      system.row(e).setZero();
      system.col(e).setZero();
      system(e, e) = 1.0;
    }
  }
  const Eigen::MatrixXd voltage = system.ldlt().solve(Eigen::MatrixXd::Identity(count, count));
  double largest = 0.0;
  for (const Eigen::Index i : own) {
    if (cut->row_of_conductor[static_cast<std::size_t>(i)].value_or(0) != 0) {
      continue;
    }
    for (const Eigen::Index j : own) {
      const bool held =
          !circuits[static_cast<std::size_t>(i)] || !circuits[static_cast<std::size_t>(j)];
      const double share =
          held ? admittance(j, i) / admittance(i, i) : voltage(j, i) / voltage(i, i);
      largest = i == j ? largest : std::max(largest, std::abs(share));
    }
  }
  return largest;
}

} // namespace ionskin::electrochemistry
