// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/study/metrics/read_out.hpp"

#include <map>
#include <string>

namespace ionskin::study {

/// Metrics that finer meshes or steps change on and on, each with the reason: extremes at a sharp
/// edge, other extremes while two meshes differ by more than a third of them, likewise what is told
/// of the onset of sliding, and the peak of a current whose spike is shorter than one time step or
/// whose error is larger than itself.
/// @param stated relative errors by metric [1]
std::map<std::string, std::string> not_converging(const Case& input, const Signals& signals,
                                                  const std::map<std::string, double>& stated);

} // namespace ionskin::study
