// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/digest.hpp"
#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"

namespace ionskin::study {

/// A strain history that is given, not solved.
struct GivenStrain {
  history::CoreHistory history;
  base::Digest digest; ///< of the file's bytes as they were read
};

/// The history of a case with strain.source = "file". It is part of the user's input: its mistakes
/// are found before any work. Throws UserError when the file cannot be read, is wrong, leaves a
/// negative fixed charge, or asks for a run that memory cannot hold.
GivenStrain read_given_strain(const Case& input);

/// Throws UserError when the file no longer holds what was read of it.
void require_unchanged(const Case& input, const GivenStrain& given);

} // namespace ionskin::study
