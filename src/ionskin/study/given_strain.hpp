// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/strain/strain_history.hpp"

namespace ionskin::study {

/// The history of a case with strain.source = "file". It is part of the user's input: its mistakes
/// are found before any work. Throws UserError when the file cannot be read, is wrong, or leaves a
/// negative fixed charge.
strain::StrainHistory read_given_strain(const Case& input);

} // namespace ionskin::study
