// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/equations/steric_excess.hpp"
#include "ionskin/electrochemistry/grid/scaled_grid.hpp"
#include "ionskin/electrochemistry/output/ion_state.hpp"
#include "ionskin/electrochemistry/solver/contact_coupling.hpp"
#include "ionskin/electrochemistry/solver/cosine_transform.hpp"
#include "ionskin/electrochemistry/solver/electrode_coupling.hpp"
#include "ionskin/parallel/worker_team.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Nearly exact inverse of the Jacobian: the equations are linearised about the laterally averaged
/// state, which a cosine transform along x and y turns into one block-tridiagonal system of 2x2
/// blocks through the thickness per lateral mode (fast diagonalisation: Lynch, Rice and Thomas
/// 1964, doi 10.1007/BF01386067). Single precision suffices inside a Krylov method in double
/// precision.
class FastDiagonalisation {
public:
  /// @param excess nothing for dilute ions
  /// @param electrodes of the faces where they are cut; must outlive this, nullptr otherwise
  /// @param sheets electrodes with sheet resistances; must outlive this, nullptr for none. The
  ///   residual then has the charges of both walls in the place of their potentials.
  FastDiagonalisation(const ScaledGrid& grid, parallel::WorkerTeam& team,
                      std::optional<StericExcess> excess = std::nullopt,
                      const WallElectrodes* electrodes = nullptr,
                      const SheetElectrodes* sheets = nullptr);

  /// Factorises for the lateral average of a state and the implicit part of a step.
  void factorise(const IonState& state, double step);

  /// Product out = (approximate Jacobian)^-1 residual; both [2 nodes].
  void apply(std::span<const double> residual, std::span<double> out);

  /// Product out = (approximate Jacobian)^-1 residual, both [2 nodes], where the conductors of cut
  /// faces stand behind circuits: in the place of the potential of a cut wall the residual has its
  /// charge, see `StageProblem`.
  void apply(const ElectrodeStage& stage, std::span<const double> residual, std::span<double> out);

  /// B^T Y B of the conductors, see ElectrodeCoupling; of the state and step factorised last.
  const std::vector<double>& electrode_admittance() const { return coupling_->admittance(); }

  /// Sums over the levels of the concentrations that answer to an amount of ions in every cell,
  /// with weights [levels] each. Transforms little more than half of what `apply` does.
  /// @param concentration of the amounts, [nodes]
  /// @returns one sum per column for each of the weights
  std::array<std::vector<double>, 2> damped_sums(std::span<const double> concentration,
                                                 const std::array<std::vector<double>, 2>& weights);

private:
  /// Row k of the system of one mode: `lower` x[k-1] + diagonal x[k] + `upper` x[k+1]. The
  /// off-diagonal blocks are the same for every mode.
  struct OffDiagonal {
    float balance_concentration = 0, balance_potential = 0;
    float poisson_concentration = 0, poisson_potential = 0;
  };

  void average(const IonState& state);
  void factorise_modes(double step, std::size_t begin, std::size_t end, bool keep_off_diagonals);
  template <class Body> void for_tiles(const Body& body);
  template <class Body> void for_modes(const Body& body);
  void solve_modes(std::size_t begin, std::size_t end);
  void backward(std::span<double> out);
  void eliminate_level(std::size_t level, std::size_t begin, std::size_t end);
  void substitute(std::size_t begin, std::size_t end);
  void forward(std::span<const double> residual);
  /// Finds the response of each mode to a unit on either wall: of its potential where that is
  /// given, else of its charge.
  void find_answers();
  /// Adds to the modes their response to amounts on the walls, by mode; none of a wall whose
  /// amounts are empty.
  void add_answers(const std::array<std::vector<float>, 2>& amounts);
  /// Charge of a wall at a potential of 0, by mode.
  std::vector<float> wall_charge(std::size_t wall) const;
  void sum_levels(std::span<const double> weights, std::size_t row, std::size_t begin,
                  std::size_t end);

  const ScaledGrid& grid_;
  parallel::WorkerTeam& team_;
  std::optional<StericExcess> excess_;
  CosineTransform transform_;
  std::vector<double> mean_concentration_, mean_drive_; ///< per level; of the fluxes
  /// Slope of the excess by the concentration per level; 0 for dilute ions.
  std::vector<double> slope_;
  /// Change of each concentration over the mean of its level, for the same change of the excess:
  /// its room over the mean room, which differ by decades where ions crowd in some columns; empty
  /// for dilute ions. [level][column]
  std::vector<double> share_;
  std::vector<OffDiagonal> lower_, upper_; ///< per level
  /// Inverse of the eliminated diagonal block, row-major entries, each [level][mode].
  std::vector<float> inverse_00_, inverse_01_, inverse_10_, inverse_11_;
  std::vector<float> balance_, poisson_;    ///< right-hand side and solution, [level][mode]
  std::vector<float> sums_;                 ///< of `damped_sums`, two rows of modes
  std::vector<std::vector<float>> scratch_; ///< of a tile, per thread
  const WallElectrodes* electrodes_;
  std::optional<ElectrodeCoupling> coupling_;
  /// Y of every mode: charge of wall a by the potential of wall b. In double precision: it is a
  /// small difference where the core is many Debye lengths thick.
  std::array<std::array<std::vector<double>, 2>, 2> wall_admittance_;
  const SheetElectrodes* sheets_;
  std::optional<ContactCoupling> contact_;
  /// Answers of the modes to a unit on the bottom and on the top wall, see `find_answers`, as
  /// `balance_` and `poisson_` have them.
  std::array<std::vector<float>, 2> balance_answer_, poisson_answer_;
};

} // namespace ionskin::electrochemistry
