// SPDX-License-Identifier: Apache-2.0
#include "ionskin/circuits/circuit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::circuits {
namespace {

/// A value for every parameter of every circuit.
laws::LawValues some_values() {
  laws::LawValues result{{"load_resistance", 1e3}, {"load_capacitance", 2e-9}};
  for (const CircuitRow& row : circuits()) {
    for (const laws::LawParameter& parameter : row.parameters) {
      result.try_emplace(std::string(parameter.name), parameter.highest);
    }
  }
  return result;
}

const laws::LawValues values = some_values();

TEST(Circuit, RowSaysWhatItsCircuitIs) {
  ASSERT_EQ(circuits().front().name, "short");
  for (const CircuitRow& row : circuits()) {
    const Circuit made = circuit(row.name, values);
    EXPECT_EQ(made.name, row.name);
    EXPECT_FALSE(made.words.empty());
    EXPECT_FALSE(row.meaning.empty());
    EXPECT_EQ(row.holds_potential, !made.admittance.has_value()) << row.name;
    // An instrument reads the current between electrodes at one potential.
    EXPECT_FALSE(made.read && made.admittance) << row.name;
    EXPECT_TRUE(row.noise.empty() || laws::has_parameter(circuits(), row.name, row.noise));
  }
}

TEST(Circuit, SharedParametersAreDeclaredAlike) {
  for (const CircuitRow& row : circuits()) {
    for (const laws::LawParameter& parameter : row.parameters) {
      EXPECT_LT(parameter.lowest, parameter.highest) << parameter.name;
      EXPECT_FALSE(parameter.help.empty()) << parameter.name;
      for (const CircuitRow& other : circuits()) {
        for (const laws::LawParameter& same : other.parameters) {
          if (same.name == parameter.name) {
            EXPECT_EQ(same.help, parameter.help) << same.name;
            EXPECT_EQ(same.lowest, parameter.lowest) << same.name;
            EXPECT_EQ(same.highest, parameter.highest) << same.name;
            EXPECT_EQ(same.default_value, parameter.default_value) << same.name;
          }
        }
      }
    }
  }
}

TEST(Circuit, AdmittanceFollowsTheParameters) {
  EXPECT_FALSE(circuit("short", values).admittance);
  EXPECT_FALSE(circuit("open", values).admittance->passes_charge());
  EXPECT_EQ(circuit("load", values).admittance->resistance, 1e3);
  EXPECT_EQ(circuit("load", values).admittance->capacitance, 0);
  const Circuit both = circuit("parallel-rc", values);
  EXPECT_EQ(both.admittance->resistance, 1e3);
  EXPECT_EQ(both.admittance->capacitance, 2e-9);
  EXPECT_EQ(both.words, "resistor of 1000 ohm and capacitor of 2e-09 F in parallel");
  EXPECT_TRUE((Admittance{.capacitance = 1e-9}.passes_charge()));
}

TEST(Circuit, TellsThePotentialOfTheTopElectrode) {
  EXPECT_EQ(top_potential(circuit("short", values)), "φ = 0");
  EXPECT_EQ(top_potential(circuit("amplifier", values)), "φ = 0");
  EXPECT_EQ(top_potential(circuit("open", values)), "φ = U, no current");
  EXPECT_EQ(top_potential(circuit("load", values)), "φ = U = R I");
  EXPECT_EQ(top_potential(circuit("parallel-rc", values)), "φ = U, I = U/R + C dU/dt");
}

} // namespace
} // namespace ionskin::circuits
