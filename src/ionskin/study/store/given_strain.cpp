// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/store/given_strain.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/files/file_copy.hpp"
#include "ionskin/base/system/available_memory.hpp"
#include "ionskin/case/checks/check_sizes.hpp"
#include "ionskin/electrochemistry/coupling/driving_channel.hpp"
#include "ionskin/electrochemistry/equations/space_charge.hpp"
#include "ionskin/electrochemistry/time/problem_size.hpp"
#include "ionskin/results/strain_file/strain_file.hpp"

#include <fmt/format.h>

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

[[noreturn]] void fail(const Case& input, const std::string& problem, const std::string& remedy) {
  throw UserError(
      fmt::format("{}\n  in the strain file {}\n  = {}", problem, input.strain.file, remedy));
}

void require_instants(const Case& input, const history::CoreHistory& history) {
  const double interval = input.readout.sample_interval, duration = history.duration();
  if (interval > duration) {
    fail(input,
         fmt::format("readout.sample_interval = {:.6g} s is longer than the run of {:.6g} s",
                     interval, duration),
         fmt::format("it must be at most {:.6g} s", duration));
  }
  require_sampling(input.readout, duration);
}

void require_channel(const Case& input, const history::CoreHistory& history) {
  const std::vector<std::string> needed =
      electrochemistry::channels_for(laws::coupling_law(input.coupling.law));
  std::vector<std::string> present;
  for (const history::HistoryChannel& channel : history.channels) {
    present.push_back(channel.name);
  }
  for (const std::string& name : needed) {
    if (history.find(name) != nullptr) {
      return;
    }
  }
  fail(
      input,
      fmt::format("the law \"{}\" needs the channel {}, and the file has only: {}",
                  input.coupling.law, listed(needed), listed(present)),
      fmt::format("write the dataset channels/{}, or choose another coupling.law", needed.front()));
}

void require_memory(const Case& input, const history::CoreHistory& history) {
  const electrochemistry::ProblemSize size = electrochemistry::problem_size(input, history);
  const double free = base::available_memory().bytes;
  if (size.memory > free) {
    fail(input,
         fmt::format("ion transport on {} x {} columns of {} levels takes about {:.3g} GB of "
                     "memory, and {:.3g} GB are free",
                     size.columns_x, size.columns_y, size.levels, size.memory * 1e-9, free * 1e-9),
         "use a coarser numerics.preset or a smaller skin, or free memory");
  }
}

} // namespace

GivenStrain read_given_strain(const Case& input) {
  const results::ForeignHdf5File file(input.strain.file);
  GivenStrain given{results::read_strain_file(file, input.skin), file.digest()};
  require_instants(input, given.history);
  require_channel(input, given.history);
  require_memory(input, given.history);
  try {
    electrochemistry::check_fixed_charge(input, given.history);
  } catch (const SolverError& error) {
    fail(input, error.what(), error.remedy());
  }
  return given;
}

void require_unchanged(const Case& input, const GivenStrain& given) {
  if (base::file_digest(input.strain.file) != given.digest) {
    throw UserError(fmt::format("the strain file {} was written while the run began\n  = wait "
                                "until it is complete and start again",
                                input.strain.file));
  }
}

} // namespace ionskin::study
