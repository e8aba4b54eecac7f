// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <optional>

namespace ionskin {

/// Duration of the run [s]; empty for a case with a strain file, which itself holds the duration.
inline std::optional<double> run_duration(const Case& input) {
  switch (input.strain.kind) {
  case StrainSourceKind::contact:
    return input.motion.cycles * input.motion.cycle_duration();
  case StrainSourceKind::prescribed:
    return input.strain.duration;
  case StrainSourceKind::file:
    break;
  }
  return std::nullopt;
}

} // namespace ionskin
