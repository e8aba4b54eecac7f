// SPDX-License-Identifier: Apache-2.0
#include "ionskin/poroelasticity/pore_pressure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ionskin::poroelasticity {
namespace {

constexpr double sealed = sealed_wall, open = open_wall;

/// One column of unit thickness and unit consolidation coefficient.
class Layer {
public:
  Layer(std::size_t elements, const WaterWalls& walls)
      : water_({1, 1}, {1.0, 1.0}, wall_clustered_nodes(1.0, elements), walls, 1.0) {}

  /// P a time after a step of p_u that is then held.
  template <class Load> std::vector<double> after_step(const Load& load, double time) {
    std::vector<double> undrained, pressure;
    for (const double z : water_.nodes()) {
      undrained.push_back(load(z));
    }
    PressureState begin, end;
    water_.start(undrained, begin);
    water_.step(begin, time, undrained, end);
    water_.pressure(end, pressure);
    return pressure;
  }
  double mean(const std::vector<double>& values) const {
    const auto lengths = node_lengths(water_.nodes());
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      sum += lengths[i] * values[i];
    }
    return sum;
  }
  PorePressure& water() { return water_; }

private:
  PorePressure water_;
};

double uniform(double) {
  return 1.0;
}
double bending(double z) {
  return z - 0.5;
}

// Terzaghi's degree of consolidation of a layer drained at one face.
TEST(PorePressure, ConsolidatesAsTerzaghiFound) {
  Layer layer(16, {sealed, open});
  EXPECT_NEAR(1 - layer.mean(layer.after_step(uniform, 0.19673074)), 0.5, 1e-5);
  EXPECT_NEAR(1 - layer.mean(layer.after_step(uniform, 0.84808541)), 0.9, 1e-5);
}

TEST(PorePressure, ConvergesWithFourthOrder) {
  const auto error = [](std::size_t elements) {
    Layer layer(elements, {sealed, open});
    return std::abs(1 - layer.mean(layer.after_step(uniform, 0.19673074)) - 0.5);
  };
  EXPECT_NEAR(std::log2(error(4) / error(8)), 4.0, 0.3);
}

// P_top - P_bottom after a linear p_u between sealed walls, by its Fourier series.
TEST(PorePressure, LetsADifferenceOfTheWallsDecay) {
  Layer layer(16, {sealed, sealed});
  for (const auto& [time, expected] :
       {std::pair{0.01, 0.774324}, {0.1, 0.302118}, {0.3, 0.0419658}, {1.0, 4.19252e-05}}) {
    const auto pressure = layer.after_step(bending, time);
    EXPECT_NEAR(pressure.back() - pressure.front(), expected, 2e-5) << time;
  }
}

TEST(PorePressure, KeepsTheWaterBetweenSealedWalls) {
  Layer layer(12, {sealed, sealed});
  const auto load = [](double z) { return std::exp(3 * z); };
  const auto pressure = layer.after_step(load, 0.05);
  std::vector<double> undrained;
  for (const double z : layer.water().nodes()) {
    undrained.push_back(load(z));
  }
  EXPECT_NEAR(layer.mean(pressure), layer.mean(undrained), 1e-13 * layer.mean(undrained));
}

TEST(PorePressure, TakesAnyStepOfALinearLoadExactly) {
  PorePressure water({6, 4}, {0.3, 0.2}, wall_clustered_nodes(1.0, 4), {open, sealed}, 1.0);
  std::vector<double> low(water.values()), high(water.values()), middle(water.values());
  for (std::size_t i = 0; i < low.size(); ++i) {
    low[i] = std::sin(0.7 * static_cast<double>(i));
    high[i] = std::cos(0.3 * static_cast<double>(i));
    middle[i] = 0.5 * (low[i] + high[i]);
  }
  PressureState begin, half, twice, once;
  water.start(low, begin);
  water.step(begin, 0.02, middle, half);
  water.step(half, 0.02, high, twice);
  water.step(begin, 0.04, high, once);
  std::vector<double> a, b;
  water.pressure(twice, a);
  water.pressure(once, b);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(a[i], b[i], 1e-12);
  }
}

// A wave along x with no change through the thickness decays with its own wave number.
TEST(PorePressure, FlowsAlongTheSkin) {
  constexpr std::size_t columns = 60;
  PorePressure water({columns, 1}, {1.0 / columns, 1.0}, wall_clustered_nodes(1.0, 2),
                     {sealed, sealed}, 1.0);
  std::vector<double> undrained(water.values()), pressure;
  const auto wave = [](std::size_t i) {
    return std::cos(std::numbers::pi * (static_cast<double>(i % columns) + 0.5) / columns);
  };
  for (std::size_t i = 0; i < undrained.size(); ++i) {
    undrained[i] = wave(i);
  }
  PressureState begin, end;
  water.start(undrained, begin);
  water.step(begin, 0.1, undrained, end);
  water.pressure(end, pressure);
  const double decayed = std::exp(-0.1 * std::numbers::pi * std::numbers::pi);
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    EXPECT_NEAR(pressure[i], wave(i) * decayed, 1e-4);
  }
}

} // namespace
} // namespace ionskin::poroelasticity
