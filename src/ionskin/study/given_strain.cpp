// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/given_strain.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/electrochemistry/space_charge.hpp"
#include "ionskin/results/strain_file.hpp"

#include <string>

namespace ionskin::study {

strain::StrainHistory read_given_strain(const Case& input) {
  strain::StrainHistory history = results::read_strain_file(input.strain.file, input.skin);
  try {
    electrochemistry::check_fixed_charge(input, history);
  } catch (const SolverError& error) {
    throw UserError(std::string(error.what()) + "\n  in the strain file " + input.strain.file +
                    "\n  = " + error.remedy());
  }
  return history;
}

} // namespace ionskin::study
