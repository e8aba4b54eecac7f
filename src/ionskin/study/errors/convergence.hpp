// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/study/stations/read_out.hpp"

#include <map>
#include <string>

namespace ionskin::study {

/// Metrics that finer meshes or steps change on and on, each with the reason: extremes at
/// a sharp edge, and the peak of a current whose spike is shorter than one time step.
std::map<std::string, std::string> not_converging(const Case& input, const Signals& signals);

} // namespace ionskin::study
