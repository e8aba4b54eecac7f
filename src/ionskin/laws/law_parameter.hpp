// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/units/dimension.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace ionskin::laws {

/// A parameter of a law's own, as the law declares it. The schema makes a key of it,
/// `contact.NAME`, `coupling.NAME` or, of a circuit, `readout.NAME`, which is read, checked,
/// explained, documented and hashed by this declaration.
struct LawParameter {
  std::string_view name;
  units::Dimension dimension = units::Dimension::number;
  bool whole = false;             ///< takes whole numbers only
  double lowest = 0, highest = 0; ///< allowed, both included [SI]
  std::string_view help;          ///< one sentence
  std::string_view default_value; ///< TOML, such as "\"4 MPa\""; where empty, a case must give it
  std::string_view source;        ///< of the default
};

/// Values of a law's parameters by their names [SI].
using LawValues = std::map<std::string, double, std::less<>>;

/// A declared parameter and the member of the law that holds it.
template <class Law> struct OwnParameter {
  LawParameter declared;
  double Law::*member = nullptr;
};

/// Parameters of a law without any.
template <class Law> inline constexpr std::array<OwnParameter<Law>, 0> no_parameters{};

/// The declarations of a law's parameters; `Law::parameters()` gives an array of `OwnParameter`.
template <class Law> std::span<const LawParameter> declared_parameters() {
  constexpr std::size_t count = Law::parameters().size();
  static const auto table = [] {
    std::array<LawParameter, count> result;
    for (std::size_t i = 0; i < count; ++i) {
      result[i] = Law::parameters()[i].declared;
    }
    return result;
  }();
  return table;
}

/// True if the law of a name has a parameter of its own of a name.
template <class Law>
bool has_parameter(std::span<const Law> laws, std::string_view law, std::string_view parameter) {
  return std::ranges::any_of(laws, [&](const Law& candidate) {
    return candidate.name == law &&
           std::ranges::find(candidate.parameters, parameter, &LawParameter::name) !=
               candidate.parameters.end();
  });
}

/// A law with the values of its parameters, which must all be there.
template <class Law> Law with_parameters(const LawValues& values) {
  Law law;
  for (const OwnParameter<Law>& own : Law::parameters()) {
    law.*own.member = values.at(std::string(own.declared.name));
  }
  return law;
}

/// A law from the values of its parameters and the coefficient that every law of friction or
/// coupling has.
template <class Law> Law law_with(double coefficient, const LawValues& values) {
  Law law = with_parameters<Law>(values);
  law.coefficient = coefficient;
  return law;
}

} // namespace ionskin::laws
