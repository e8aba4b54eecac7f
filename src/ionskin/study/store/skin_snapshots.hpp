// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/output/contact_solution.hpp"
#include "ionskin/results/skin_snapshot.hpp"

#include <vector>

namespace ionskin::study {

/// Instants at which a case asks for fields (`output.fields`), ascending and without repeats [s].
std::vector<double> field_instants(const Case& input);

/// Function that recovers the strains of all layers for any state of a contact; null where the
/// slider never touches.
mechanics::LayerStrainAt layer_strains(const mechanics::ContactSolution& contact);

/// Deformation, tractions and position of skin and slider at one instant, for ParaView.
/// @param strain result of `layer_strains` for this contact, made once for all instants
/// @param time since the start of the run [s]
results::SkinSnapshot skin_snapshot(const Case& input, const mechanics::ContactSolution& contact,
                                    const mechanics::LayerStrainAt& strain, double time);

} // namespace ionskin::study
