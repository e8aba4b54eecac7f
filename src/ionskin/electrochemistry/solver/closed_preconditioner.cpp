// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/solver/closed_preconditioner.hpp"

#include <algorithm>

namespace ionskin::electrochemistry {

ClosedPreconditioner::ClosedPreconditioner(const ScaledGrid& grid, parallel::WorkerTeam& team,
                                           std::optional<StericExcess> excess,
                                           const WallElectrodes* electrodes,
                                           const SheetElectrodes* sheets)
    : grid_(grid), open_(grid, team, excess, electrodes, sheets), voltage_(grid) {}

void ClosedPreconditioner::factorise(const IonState& state, double step) {
  open_.factorise(state, step);
  answer_is_known_ = false;
}

void ClosedPreconditioner::apply(const StageProblem& problem, std::span<const double> residual,
                                 std::span<double> out) {
  if (problem.electrodes != nullptr) {
    open_.apply(*problem.electrodes, residual, out);
    return;
  }
  open_.apply(residual, out);
  const std::optional<CircuitStage>& circuit = problem.circuit;
  if (!circuit) {
    return;
  }
  answer_to_unit_voltage();
  const std::size_t nodes = grid_.nodes();
  const double change = voltage_.change(*circuit, out.first(nodes));
  const double feedback = voltage_.change(*circuit, std::span(answer_).first(nodes));
  const double voltage = change / (1.0 - feedback);
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] += voltage * answer_[i];
  }
}

void ClosedPreconditioner::answer_to_unit_voltage() {
  if (answer_is_known_) {
    return;
  }
  source_.assign(2 * grid_.nodes(), 0.0);
  answer_.resize(source_.size());
  std::fill(source_.end() - static_cast<std::ptrdiff_t>(grid_.columns()), source_.end(), 1.0);
  open_.apply(source_, answer_);
  answer_is_known_ = true;
}

} // namespace ionskin::electrochemistry
