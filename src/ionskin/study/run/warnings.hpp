// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/readout/signals.hpp"
#include "ionskin/study/errors/error_parts.hpp"
#include "ionskin/study/store/mechanics_record.hpp"

#include <string>
#include <vector>

namespace ionskin::study {

/// Warnings that a reader of the results must know: sentences, each with its number.
std::vector<std::string> collect_warnings(const Case& input, const MechanicsRecord& mechanics,
                                          const electrochemistry::IonSolution& ions,
                                          const readout::SignalTable& signals);

/// The part of them that Study 1 alone allows.
std::vector<std::string> mechanics_warnings(const Case& input, const MechanicsRecord& mechanics);

/// Sentences where the stated error of what an instrument reads is large, or an error is missing
/// for another reason than rounding.
std::vector<std::string> error_warnings(const Case& input, const ErrorEstimate& errors);

} // namespace ionskin::study
