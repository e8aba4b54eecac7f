// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/output/contact_solution.hpp"
#include "ionskin/results/skin_snapshot.hpp"

#include <vector>

namespace ionskin::study {

/// Instants at which fields are asked for, each once and ascending [s].
std::vector<double> field_instants(const Case& input);

/// Strains of all states of a contact; empty where nothing touches.
mechanics::LayerStrainAt layer_strains(const mechanics::ContactSolution& contact);

/// Skin and slider at an instant of the run [s].
/// @param strain as `layer_strains` gives it, once for all instants
results::SkinSnapshot skin_snapshot(const Case& input, const mechanics::ContactSolution& contact,
                                    const mechanics::LayerStrainAt& strain, double time);

} // namespace ionskin::study
