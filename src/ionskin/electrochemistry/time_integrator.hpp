// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/derived_scales.hpp"
#include "ionskin/electrochemistry/electrode_potentials.hpp"
#include "ionskin/electrochemistry/ion_state.hpp"
#include "ionskin/electrochemistry/newton_krylov.hpp"
#include "ionskin/electrochemistry/space_charge.hpp"

#include <vector>

namespace ionskin::electrochemistry {

/// Two-stage diagonally implicit Runge-Kutta method of order 2 with gamma = 1 - 1/sqrt(2): L-stable
/// and stiffly accurate (Alexander 1977, doi 10.1137/0714068), so that double layers faster than a
/// step stay quiet and Poisson's equation holds at the end of every step.
class TimeIntegrator {
public:
  TimeIntegrator(const ScaledGrid& grid, const DerivedScales& scales, FixedCharge& fixed_charge,
                 ElectrodePotentials potentials, NewtonKrylov& solver);

  /// The response at the first instant: ions where they were, phi from Poisson's equation.
  /// Throws SolverError.
  void initialise(double time, TransportState& state);

  /// Advances from `begin` to `end` [s]; leaves the fixed charge at `end`. A step that Newton's
  /// method cannot take is halved. Throws SolverError when that does not help.
  void advance(double begin, double end, TransportState& state);

private:
  bool try_step(double begin, double end, TransportState& state);
  bool solve_stage(double time, double step, IonState& state);
  /// guess = state + factor * direction, or the state itself where that would deplete a
  /// concentration.
  void extrapolate(const IonState& state, double factor, const std::vector<double>& direction,
                   IonState& guess) const;
  void advance_halved(double begin, double end, TransportState& state, int halvings);

  const ScaledGrid& grid_;
  DerivedScales scales_;
  FixedCharge& fixed_charge_;
  ElectrodePotentials potentials_;
  NewtonKrylov& solver_;
  std::vector<double> start_; ///< concentration a stage starts from
  IonState stage_, end_;
  std::vector<double> slope_;
};

} // namespace ionskin::electrochemistry
