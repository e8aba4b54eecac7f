// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/coupling/coupling_law.hpp"

#include "ionskin/laws/coupling/column_neutral.hpp"
#include "ionskin/laws/coupling/fixed_charge.hpp"
#include "ionskin/laws/coupling/pair_generation.hpp"
#include "ionskin/laws/coupling/poroelastic.hpp"
#include "ionskin/laws/coupling/volume_neutral.hpp"
#include "ionskin/laws/named_row.hpp"

#include <array>
#include <string>

namespace ionskin::laws {
namespace {

/// Function of a law that has either `ratio` (cf / c0 at one node) or `apply` (cf / c0 of the whole
/// core); an empty function if it has neither.
template <class Law> Coupling coupling_with(double coefficient, const LawValues& values) {
  const Law law = law_with<Law>(coefficient, values);
  if constexpr (requires { law.ratio(0.0); }) {
    return [law](const CoreLayout&, std::span<const double> shear, std::span<double> ratio) {
      for (std::size_t i = 0; i < shear.size(); ++i) {
        ratio[i] = law.ratio(shear[i]);
      }
    };
  } else if constexpr (requires { &Law::apply; }) {
    return [law](const CoreLayout& core, std::span<const double> shear, std::span<double> ratio) {
      law.apply(core, shear, ratio);
    };
  } else {
    return {};
  }
}

template <class Law> CouplingLaw coupling_row(std::string_view name) {
  return {name, Law::traits, declared_parameters<Law>(), coupling_with<Law>};
}

} // namespace

std::span<const CouplingLaw> coupling_laws() {
  static const std::array laws{
      coupling_row<FixedCharge>("fixed-charge"),
      coupling_row<VolumeNeutral>("volume-neutral"),
      coupling_row<ColumnNeutral>("column-neutral"),
      coupling_row<PairGeneration>("pair-generation"),
      coupling_row<Poroelastic>("poroelastic"),
  };
  return laws;
}

const CouplingLaw& coupling_law(std::string_view name) {
  return named_row(coupling_laws(), name, "coupling law");
}

} // namespace ionskin::laws
