// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/digest.hpp"
#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"

namespace ionskin::study {

/// Strain history of the core that is given, read from a file or made from a prescribed load,
/// rather than solved by Study 1.
struct GivenStrain {
  history::CoreHistory history;
  /// Digest of the bytes of the strain file as they were read; default for a prescribed load.
  base::Digest digest;
};

/// Reads the strain history of a case with strain.source = "file", and checks it before any work,
/// as it is part of the user's input.
/// Throws UserError when the file cannot be read, is wrong, lacks the channel that the coupling law
/// needs, leaves a negative fixed charge, or asks for a run that memory cannot hold.
GivenStrain read_given_strain(const Case& input);

/// Checks that the strain file of a case has not changed since it was read.
/// Throws UserError when its bytes differ.
void require_unchanged(const Case& input, const GivenStrain& given);

} // namespace ionskin::study
