// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/metrics/sample_noise.hpp"

#include "ionskin/base/constants.hpp"
#include "ionskin/circuits/noise_of_mean.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "synthetic_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::study {
namespace {

constexpr double sample_time = 1e-5, record_time = 1e-4; // [s]

/// One whose double layers hardly charge within the record and whose bulk relaxes far faster than
/// the interval: a resistor.
Case resistive_case(const std::string& instrument) {
  Case input = handover::small_case();
  input.electrochemistry = {293.15, 7e-11, 1e-8, 1200, 1};
  input.readout.sample_interval = sample_time;
  input.readout.instrument = instrument;
  return input;
}

double resistance(const Case& input) {
  const double thickness = input.skin.core_thickness();
  const auto scales = electrochemistry::derive_scales(input.electrochemistry, thickness);
  return thickness / (scales.conductivity * input.skin.length * input.skin.width);
}

double mean_of_white(double density) {
  return circuits::noise_of_mean([&](double) { return density * density; },
                                 {sample_time, 10 / sample_time, record_time});
}

TEST(SampleNoise, OfAResistorIsNyquists) {
  const Case input = resistive_case("ideal");
  const double power = 4 * constants::boltzmann * input.electrochemistry.temperature;
  const SampleNoise noise = sample_noise(input, 1e-6, record_time);
  EXPECT_NEAR(noise.thermal / mean_of_white(std::sqrt(power / resistance(input))), 1, 0.02);
  EXPECT_EQ(noise.amplifier, 0);
  EXPECT_EQ(noise.quantisation, 0);
  EXPECT_EQ(noise.total(), noise.thermal);
}

TEST(SampleNoise, OfAnAmplifierIsItsVoltageOverTheResistance) {
  const Case input = resistive_case("ad8605");
  const SampleNoise noise = sample_noise(input, 1e-6, record_time);
  EXPECT_NEAR(noise.amplifier / mean_of_white(8e-9 / resistance(input)), 1, 0.02);
  EXPECT_GT(noise.quantisation, 0);
  EXPECT_NEAR(noise.total(), std::hypot(noise.thermal, noise.amplifier, noise.quantisation),
              1e-12 * noise.total());
}

TEST(SampleNoise, OfAnAmplifierCircuitHasTheVoltageNoiseOfItsInstrument) {
  Case input = resistive_case("ad8605");
  const double through_cell = sample_noise(input, 1e-6, record_time).amplifier;
  input.readout.circuit = "amplifier";
  input.readout.parameters = {{"amplifier_bandwidth", 10 / sample_time},
                              {"amplifier_noise_density", 0},
                              {"amplifier_range", 0},
                              {"noise_seed", 1}};
  EXPECT_NEAR(sample_noise(input, 1e-6, record_time).amplifier / through_cell, 1, 1e-9);
  input.readout.parameters["amplifier_noise_density"] = 1e-9;
  EXPECT_NEAR(sample_noise(input, 1e-6, record_time).amplifier /
                  std::hypot(through_cell, mean_of_white(1e-9)),
              1, 1e-3);
  input.readout.instrument = "ideal";
  EXPECT_NEAR(sample_noise(input, 1e-6, record_time).amplifier / mean_of_white(1e-9), 1, 1e-9);
}

TEST(SampleNoise, TakesTheInstrumentsNumbersOfTheCase) {
  Case input = resistive_case("ad8605");
  input.readout.instrument_voltage_noise = 40e-9;
  input.readout.instrument_current_noise = 0;
  input.readout.instrument_bits = 12;
  const SampleNoise noise = sample_noise(input, 1e-6, record_time),
                    named = sample_noise(resistive_case("ad8605"), 1e-6, record_time);
  EXPECT_NEAR(noise.amplifier / mean_of_white(40e-9 / resistance(input)), 1, 0.02);
  EXPECT_NEAR(noise.quantisation / named.quantisation, 16, 1e-9);
  input.readout.instrument_bits = 0;
  EXPECT_EQ(sample_noise(input, 1e-6, record_time).quantisation, 0);
}

TEST(SampleNoise, OfAVoltageIsACurrentThroughTheResistorAndCapacitor) {
  Case input = resistive_case("ad8605");
  const SampleNoise noise{3e-9, 4e-9, 0};
  EXPECT_EQ(current_noise(input, noise), noise.total());
  input.readout.circuit = "open";
  EXPECT_EQ(current_noise(input, noise), 0);
  input.readout.circuit = "parallel-rc";
  input.readout.parameters = {{"load_resistance", 1e3}, {"load_capacitance", 1e-8}};
  EXPECT_NEAR(current_noise(input, noise), 5e-9 * (1e-3 + 1e-8 / sample_time), 1e-17);
}

TEST(SampleNoise, OfAnOpenCellIsAVoltage) {
  Case input = resistive_case("ad8605");
  input.readout.circuit = "open";
  const double power = 4 * constants::boltzmann * input.electrochemistry.temperature;
  const SampleNoise noise = sample_noise(input, 0, record_time);
  EXPECT_NEAR(noise.thermal / mean_of_white(std::sqrt(power * resistance(input))), 1, 0.02);
  EXPECT_NEAR(noise.amplifier / mean_of_white(8e-9), 1, 0.02);
  const auto metrics = noise_metrics(noise, 2 * noise.total(), "V");
  EXPECT_EQ(metrics.back().name, "signal_to_noise");
  EXPECT_NEAR(metrics.back().value, 2, 1e-12);
}

} // namespace
} // namespace ionskin::study
