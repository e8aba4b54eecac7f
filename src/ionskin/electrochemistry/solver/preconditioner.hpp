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

/// Nearly exact inverse of the Jacobian of a stage, for preconditioning. The equations are
/// linearised about the laterally averaged state; a cosine transform along x and y turns them into
/// one block-tridiagonal system of 2x2 blocks through the thickness for each lateral mode (fast
/// diagonalisation: Lynch, Rice and Thomas 1964, doi 10.1007/BF01386067). Single precision suffices
/// inside a Krylov method in double precision.
class FastDiagonalisation {
public:
  /// @param grid must outlive this, as must `team`
  /// @param excess steric excess; nothing for dilute ions
  /// @param electrodes conductors of cut faces; must outlive this; nullptr where no face is cut
  /// @param sheets electrodes with sheet resistances; must outlive this; nullptr for none. The
  ///   residual then has the charges of both walls in the place of their potentials.
  FastDiagonalisation(const ScaledGrid& grid, parallel::WorkerTeam& team,
                      std::optional<StericExcess> excess = std::nullopt,
                      const WallElectrodes* electrodes = nullptr,
                      const SheetElectrodes* sheets = nullptr);

  /// Factorises the Jacobian for the lateral average of a state.
  /// @param step implicit part of the time step [relaxation times]
  void factorise(const IonState& state, double step);

  /// Computes out = (approximate Jacobian)^-1 residual; both [2 nodes].
  void apply(std::span<const double> residual, std::span<double> out);

  /// Computes out = (approximate Jacobian)^-1 residual, both [2 nodes], for conductors of cut faces
  /// behind circuits: in the place of the potential of a cut wall the residual has its charge, see
  /// `StageProblem`.
  void apply(const ElectrodeStage& stage, std::span<const double> residual, std::span<double> out);

  /// Matrix B^T Y B of the conductors for the state and step factorised last, see
  /// `ElectrodeCoupling::admittance`.
  const std::vector<double>& electrode_admittance() const { return coupling_->admittance(); }

  /// Solves for the concentrations that answer to amounts of ions in every cell, and returns their
  /// sums over the levels, with two sets of weights, [weight][y][x]. It transforms little more than
  /// half as much as `apply`.
  /// @param concentration of the amounts, whose product with the cell's height counts [nodes]
  /// @param weights of the levels, [weight][level]
  std::array<std::vector<double>, 2> damped_sums(std::span<const double> concentration,
                                                 const std::array<std::vector<double>, 2>& weights);

private:
  /// Off-diagonal 2x2 block of row k of the system of a mode, `lower` x[k-1] + diagonal x[k] +
  /// `upper` x[k+1]. These blocks are the same for every mode.
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
  /// Finds the response of each mode to a unit on either wall: of the potential where it is given,
  /// else of the charge.
  void find_answers();
  /// Adds to the modes their response to amounts on the walls, [bottom, top][mode]; empty for none.
  void add_answers(const std::array<std::vector<float>, 2>& amounts);
  /// Charge of a wall at a potential of 0, for each mode.
  std::vector<float> wall_charge(std::size_t wall) const;
  void sum_levels(std::span<const double> weights, std::size_t row, std::size_t begin,
                  std::size_t end);

  const ScaledGrid& grid_;
  parallel::WorkerTeam& team_;
  std::optional<StericExcess> excess_;
  CosineTransform transform_;
  /// Lateral means of c and of the potential that drives fluxes, per level.
  std::vector<double> mean_concentration_, mean_drive_;
  /// Derivative of the excess by the concentration, per level; 0 for dilute ions.
  std::vector<double> slope_;
  /// Change of each concentration over the mean change of its level, for the same change of the
  /// excess: its free share of the sites over their mean, which differ by decades where ions crowd
  /// in some columns; empty for dilute ions. [level][column]
  std::vector<double> share_;
  std::vector<OffDiagonal> lower_, upper_; ///< per level
  /// Inverse of the eliminated diagonal block, row-major entries, each [level][mode].
  std::vector<float> inverse_00_, inverse_01_, inverse_10_, inverse_11_;
  std::vector<float> balance_, poisson_;    ///< right-hand side and solution, [level][mode]
  std::vector<float> sums_;                 ///< scratch of `damped_sums`, two rows of modes
  std::vector<std::vector<float>> scratch_; ///< scratch for a tile of levels, per thread
  const WallElectrodes* electrodes_;
  std::optional<ElectrodeCoupling> coupling_;
  /// Admittance Y of every mode: charge of wall a by the potential of wall b, [a][b][mode]. In
  /// double precision: it is a small difference where the core is many Debye lengths thick.
  std::array<std::array<std::vector<double>, 2>, 2> wall_admittance_;
  const SheetElectrodes* sheets_;
  std::optional<ContactCoupling> contact_;
  /// Responses of the modes to a unit on the bottom and on the top wall, see `find_answers`, in the
  /// layout of `balance_` and `poisson_`.
  std::array<std::vector<float>, 2> balance_answer_, poisson_answer_;
};

} // namespace ionskin::electrochemistry
