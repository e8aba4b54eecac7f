// SPDX-License-Identifier: Apache-2.0
#include "ionskin/circuits/circuit.hpp"

#include "ionskin/circuits/amplifier.hpp"
#include "ionskin/circuits/load.hpp"
#include "ionskin/circuits/open_circuit.hpp"
#include "ionskin/circuits/parallel_rc.hpp"
#include "ionskin/circuits/short_circuit.hpp"
#include "ionskin/laws/named_row.hpp"

#include <array>
#include <cmath>

namespace ionskin::circuits {
namespace {

template <class Kind>
concept HasAdmittance = requires(const Kind kind) {
  kind.admittance();
};

template <class Kind> Circuit circuit_with(const laws::LawValues& values) {
  const Kind kind = laws::with_parameters<Kind>(values);
  Circuit result{.words = kind.words()};
  if constexpr (HasAdmittance<Kind>) {
    result.admittance = kind.admittance();
  }
  if constexpr (requires { &Kind::read; }) {
    result.read = [kind](const std::vector<double>& time, const std::vector<double>& charge) {
      return kind.read(time, charge);
    };
  }
  if constexpr (requires { &Kind::input_noise; }) {
    result.input_noise = kind.input_noise();
  }
  return result;
}

template <class Kind> CircuitRow row(std::string_view name) {
  std::string_view noise;
  if constexpr (requires { Kind::noise; }) {
    noise = Kind::noise;
  }
  return {name,
          Kind::meaning,
          !HasAdmittance<Kind>,
          noise,
          laws::declared_parameters<Kind>(),
          circuit_with<Kind>};
}

} // namespace

bool Admittance::passes_charge() const {
  return std::isfinite(resistance) || capacitance > 0;
}

std::span<const CircuitRow> circuits() {
  static const std::array rows{
      row<ShortCircuit>("short"),     row<OpenCircuit>("open"),    row<Load>("load"),
      row<ParallelRc>("parallel-rc"), row<Amplifier>("amplifier"),
  };
  return rows;
}

const CircuitRow& circuit_row(std::string_view name) {
  return laws::named_row(circuits(), name, "circuit");
}

Circuit circuit(std::string_view name, const laws::LawValues& values) {
  const CircuitRow& row = circuit_row(name);
  Circuit result = row.with(values);
  result.name = row.name;
  return result;
}

std::string_view top_potential(const Circuit& circuit) {
  if (!circuit.admittance) {
    return "φ = 0";
  }
  if (!circuit.admittance->passes_charge()) {
    return "φ = U, no current";
  }
  return circuit.admittance->capacitance > 0 ? "φ = U, I = U/R + C dU/dt" : "φ = U = R I";
}

} // namespace ionskin::circuits
