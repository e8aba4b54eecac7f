// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/time/time_integrator.hpp"

#include "ionskin/electrochemistry/grid/transport_grid.hpp"
#include "model_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ionskin::electrochemistry {
namespace {

/// A single column under electrode potentials without shear.
class SingleColumn : public testing::Test {
protected:
  TransportState run(const ElectrodePotentials& potentials, double duration, int steps) {
    TimeIntegrator integrator(grid, scales, fixed_charge, potentials, electrodes, solver, team);
    TransportState state;
    integrator.initialise(0.0, state);
    for (int i = 0; i < steps; ++i) {
      const auto error =
          integrator.try_step(duration * i / steps, duration * (i + 1) / steps, state, 0.01);
      if (!error) {
        ADD_FAILURE() << "no solution";
        break;
      }
      last_error = *error;
      integrator.accept(state);
    }
    return state;
  }

  Case input = verification::model_case();
  history::CoreHistory history = verification::linear_step_history(0.0, 0.0, {0.0, 10.0});
  TransportGrid transport_grid = make_transport_grid(input, history);
  DerivedScales scales = derive_scales(input.electrochemistry, history.core_thickness());
  ScaledGrid grid = scale_grid(transport_grid, scales.debye_length);
  FixedCharge fixed_charge{input, history, transport_grid, grid};
  ElectrodeCharges electrodes{grid, fixed_charge};
  parallel::WorkerTeam team{1};
  NewtonKrylov solver{grid, 1e-7, team};
  double last_error = 0;
};

double largest_difference(const TransportState& a, const TransportState& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.ions.values.size(); ++i) {
    largest = std::max(largest, std::abs(a.ions.values[i] - b.ions.values[i]));
  }
  return largest;
}

TEST_F(SingleColumn, IsOfSecondOrderForASmoothRamp) {
  ElectrodePotentials ramp;
  ramp.top = [](double time) { return 0.5 * time * time; };
  const auto coarse = run(ramp, 0.2, 20), medium = run(ramp, 0.2, 40), fine = run(ramp, 0.2, 80);
  const double order =
      std::log2(largest_difference(coarse, medium) / largest_difference(medium, fine));
  EXPECT_GT(order, 1.8);
  EXPECT_LT(order, 2.3);
}

TEST_F(SingleColumn, LargeStepsDampTheFastLayersAtOnce) {
  ElectrodePotentials jump;
  jump.top = [this](double) { return 0.1 * scales.thermal_voltage; };
  // Steps of 60 charging times: an L-stable method is at rest, others swing.
  const TransportState state = run(jump, 120.0 * scales.slow_time, 2);
  const TransportState later = run(jump, 240.0 * scales.slow_time, 4);
  EXPECT_LT(largest_difference(state, later), 2e-3);
}

TEST_F(SingleColumn, ErrorEstimateIsOfThirdOrder) {
  ElectrodePotentials ramp;
  ramp.top = [](double time) { return 0.5 * time * time; };
  run(ramp, 0.2, 20);
  const double coarse = last_error;
  run(ramp, 0.2, 40);
  EXPECT_NEAR(std::log2(coarse / last_error), 3.0, 0.3);
}

TEST_F(SingleColumn, TellsWhereNewtonFindsNoSolution) {
  ElectrodePotentials nonsense;
  nonsense.top = [](double time) { return time > 0.5 ? std::nan("") : 0.0; };
  TimeIntegrator integrator(grid, scales, fixed_charge, nonsense, electrodes, solver, team);
  TransportState state;
  integrator.initialise(0.0, state);
  EXPECT_FALSE(integrator.try_step(0.0, 1.0, state, 0.01));
  // The state is untouched, so a shorter step can be tried from it.
  EXPECT_TRUE(integrator.try_step(0.0, 0.4, state, 0.01));
}

} // namespace
} // namespace ionskin::electrochemistry
