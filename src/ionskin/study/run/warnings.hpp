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

/// Warnings for the reader of the results of both studies, one sentence each, with the number that
/// gives rise to it.
/// @param signals resolved table of the run, one row per time step
std::vector<std::string> collect_warnings(const Case& input, const MechanicsRecord& mechanics,
                                          const electrochemistry::IonSolution& ions,
                                          const readout::SignalTable& signals);

/// Warnings that follow from Study 1 without the ion transport, one sentence each.
std::vector<std::string> mechanics_warnings(const Case& input, const MechanicsRecord& mechanics);

/// Warnings where the reported error estimate of a quantity that an instrument reads is large, or
/// where an estimate is missing because it is not a number; one sentence each.
std::vector<std::string> error_warnings(const Case& input, const ErrorEstimate& errors);

} // namespace ionskin::study
