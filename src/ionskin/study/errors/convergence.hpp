// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/metrics/read_out.hpp"
#include "ionskin/study/store/mechanics_record.hpp"

#include <map>
#include <string>

namespace ionskin::study {

/// Finds the metrics that do not converge: finer meshes or time steps keep changing them, so that
/// their reported error is no bound. These are extremes at a sharp edge; other extremes, and
/// metrics of the onset of sliding, whose relative error is above a third; and the peak of a
/// current whose spike is shorter than one time step or whose error is larger than the peak itself.
/// @param stated reported relative errors by metric [1]
/// @returns the reason by name of the metric
std::map<std::string, std::string> not_converging(const MechanicsRecord& mechanics,
                                                  const Signals& signals,
                                                  const std::map<std::string, double>& stated);

} // namespace ionskin::study
