// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/readout/metrics.hpp"

#include <map>
#include <string>
#include <vector>

namespace ionskin::study {

/// The same case on twice the mesh sizes.
Case companion_case(const Case& input);

/// Relative errors of the mechanical figures by the mesh, by name: their difference to those of the
/// companion case. The traction is singular at sharp edges, which makes averages first order in the
/// mesh size (verification M6, which also asserts the effectivity index), so the whole difference
/// is the error; where they converge faster it is a bound. Residuals and errors are no figures of
/// the skin and have no estimate, nor has a figure that is zero.
std::map<std::string, double>
estimate_mechanics_errors(const std::vector<readout::Metric>& metrics,
                          const std::vector<readout::Metric>& companion_metrics);

} // namespace ionskin::study
