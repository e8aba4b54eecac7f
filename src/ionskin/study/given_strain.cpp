// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/given_strain.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/electrochemistry/coupling_law.hpp"
#include "ionskin/electrochemistry/space_charge.hpp"
#include "ionskin/results/strain_file.hpp"

#include <string>
#include <vector>

namespace ionskin::study {
namespace {

std::string listed(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) {
    list += (list.empty() ? "" : ", ") + name;
  }
  return list;
}

void require_channel(const Case& input, const strain::StrainHistory& history) {
  const auto& law = electrochemistry::coupling_law(input.coupling.law);
  std::vector<std::string> present;
  for (const strain::HistoryChannel& channel : history.channels) {
    present.push_back(channel.name);
  }
  for (const std::string& name : law.channels()) {
    if (history.find(name) != nullptr) {
      return;
    }
  }
  throw UserError("the law \"" + input.coupling.law + "\" needs the channel " +
                  listed(law.channels()) + ", and the strain file has only: " + listed(present) +
                  "\n  in the strain file " + input.strain.file +
                  "\n  = write the dataset channels/" + law.channels().front() +
                  ", or choose another coupling.law");
}

} // namespace

strain::StrainHistory read_given_strain(const Case& input) {
  strain::StrainHistory history = results::read_strain_file(input.strain.file, input.skin);
  require_channel(input, history);
  try {
    electrochemistry::check_fixed_charge(input, history);
  } catch (const SolverError& error) {
    throw UserError(std::string(error.what()) + "\n  in the strain file " + input.strain.file +
                    "\n  = " + error.remedy());
  }
  return history;
}

} // namespace ionskin::study
