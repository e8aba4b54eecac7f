// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/output/contact_solution.hpp"
#include "ionskin/results/skin_snapshot.hpp"

#include <vector>

namespace ionskin::study {

/// Instants at which fields are asked for, each once and ascending [s].
std::vector<double> field_instants(const Case& input);

/// Skin and slider at an instant of the run [s].
results::SkinSnapshot skin_snapshot(const Case& input, const mechanics::ContactSolution& contact,
                                    double time);

} // namespace ionskin::study
