// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/taxel_crosstalk.hpp"

#include "ionskin/electrochemistry/equations/steric_excess.hpp"
#include "ionskin/electrochemistry/output/ion_state.hpp"
#include "ionskin/electrochemistry/solver/preconditioner.hpp"
#include "ionskin/parallel/worker_team.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ionskin::electrochemistry {

namespace {

using Circuits = std::vector<std::optional<ScaledAdmittance>>;

/// Response of the cell at rest with its conductors, within one implicit Euler step of a readout
/// interval.
class RestingCell {
public:
  RestingCell(const Case& input, const DerivedScales& scales, const TransportGrid& grid,
              const CutElectrode& cut)
      : step_(input.readout.sample_interval / scales.relaxation_time) {
    const ScaledGrid scaled = scale_grid(grid, scales.debye_length, scales.area_ratio);
    parallel::WorkerTeam team(1);
    FastDiagonalisation cell(scaled, team, steric_excess(input.electrochemistry), &cut.conductors);
    IonState rest(scaled.nodes());
    std::ranges::fill(rest.concentration(), 1.0);
    cell.factorise(rest, step_);
    const auto count = static_cast<Eigen::Index>(cut.conductors.size());
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    admittance_ = Eigen::Map<const Matrix>(cell.electrode_admittance().data(), count, count);
  }

  /// Charge of one conductor (row) by the potential of another (column).
  const Eigen::MatrixXd& admittance() const { return admittance_; }

  /// Potentials of the conductors (rows) by a unit charge that is put on one of them (columns); 0
  /// for conductors that the ground holds.
  Eigen::MatrixXd potentials(const Circuits& circuits) const {
    Eigen::MatrixXd system = admittance_;
    Eigen::MatrixXd sources = Eigen::MatrixXd::Identity(system.rows(), system.cols());
    for (Eigen::Index e = 0; e < system.rows(); ++e) {
      const auto& circuit = circuits[static_cast<std::size_t>(e)];
      if (circuit) {
        system(e, e) += step_ * circuit->conductance + circuit->capacitance;
      } else {
        system.row(e).setZero();
        system.col(e).setZero();
        system(e, e) = 1.0;
        sources(e, e) = 0.0;
      }
    }
    return system.partialPivLu().solve(sources);
  }

private:
  double step_;
  Eigen::MatrixXd admittance_;
};

/// Crosstalk between the conductors `own` with circuits of their own, all on one face.
double of_conductors(const Scan& scan, const CutElectrode& cut, const RestingCell& cell,
                     const std::vector<Eigen::Index>& own) {
  // With a scan, the circuits are those while the first row is read.
  const Circuits circuits = cut.circuits(scan, 0);
  const Eigen::MatrixXd &admittance = cell.admittance(), voltage = cell.potentials(circuits);
  double largest = 0.0;
  for (const Eigen::Index i : own) {
    if (cut.row_of_conductor[static_cast<std::size_t>(i)].value_or(0) != 0) {
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

/// Reading of every line by a unit charge that is put on one of the lines: its potential where the
/// circuits leave it free, else the charge that passes. One column of the matrix for each line that
/// carries the charge.
Eigen::MatrixXd shown(const RestingCell& cell, const Circuits& circuits) {
  const Eigen::MatrixXd free = cell.potentials(circuits);
  // The charge that the core drives onto a free line leaves it by its potential.
  Eigen::MatrixXd result =
      Eigen::MatrixXd::Identity(free.rows(), free.cols()) - cell.admittance() * free;
  for (Eigen::Index e = 0; e < free.rows(); ++e) {
    if (circuits[static_cast<std::size_t>(e)]) {
      result.row(e) = -free.row(e);
    }
  }
  return result;
}

/// Crosstalk of a crossbar with a scan: each crossing is read by its column, in the turn of its
/// row.
double of_crossings(const Scan& scan, const CutElectrode& cut, const RestingCell& cell) {
  const std::size_t crossings = cut.row_of_segment.size(), rows = cut.row_of_segment.back() + 1,
                    columns = cut.row_of_segment.front();
  std::vector<Eigen::MatrixXd> turns;
  for (std::size_t row = 0; row < rows - columns; ++row) {
    turns.push_back(shown(cell, cut.circuits(scan, row)));
  }
  const auto reading = [&](std::size_t of, std::size_t source) {
    const Eigen::MatrixXd& turn = turns[cut.row_of_segment[of] - columns];
    const auto column = static_cast<Eigen::Index>(cut.conductor_of_segment[of]);
    return turn(column, static_cast<Eigen::Index>(cut.conductor_of_segment[source])) -
           turn(column, static_cast<Eigen::Index>(cut.row_of_segment[source]));
  };
  double largest = 0.0;
  for (std::size_t source = 0; source < crossings; ++source) {
    const double own = reading(source, source);
    for (std::size_t other = 0; other < crossings; ++other) {
      largest =
          other == source ? largest : std::max(largest, std::abs(reading(other, source) / own));
    }
  }
  return largest;
}

/// Crosstalk of a crossbar without a scan, between the lines of one face.
double of_lines(const Case& input, const CutElectrode& cut, const RestingCell& cell) {
  std::array<std::vector<Eigen::Index>, 2> of_face;
  for (std::size_t e = 0; e < cut.conductors.size(); ++e) {
    of_face[cut.conductors.conductors()[e].wall].push_back(static_cast<Eigen::Index>(e));
  }
  return std::max(of_conductors(input.readout.scan, cut, cell, of_face[bottom_wall]),
                  of_conductors(input.readout.scan, cut, cell, of_face[top_wall]));
}

} // namespace

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
  const RestingCell cell(input, scales, grid, *cut);
  if (!cut->row_of_segment.empty()) {
    return input.readout.scan.dwell > 0 ? of_crossings(input.readout.scan, *cut, cell)
                                        : of_lines(input, *cut, cell);
  }
  return of_conductors(input.readout.scan, *cut, cell, own);
}

} // namespace ionskin::electrochemistry
