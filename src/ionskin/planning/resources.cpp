// SPDX-License-Identifier: Apache-2.0
#include "ionskin/planning/resources.hpp"

#include "ionskin/base/byte_count.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/system/available_disk.hpp"
#include "ionskin/base/system/available_memory.hpp"
#include "ionskin/planning/cost_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ionskin::planning {
namespace {

/// Largest number of unknowns, as their indices are 32-bit integers.
constexpr double most_unknowns = 2e9;
constexpr double most_steps = 1e7;

constexpr const char* coarser =
    "choose a coarser numerics.preset or a smaller numerics.mesh_refinement, use fewer --threads, "
    "or "
    "make thin layers thicker: small elements follow from them and from small contacts";

void require_countable(const CostEstimate& cost) {
  const auto unknowns = static_cast<double>(cost.ion_unknowns);
  if (!(unknowns <= most_unknowns)) {
    throw UserError(fmt::format("the case has {:.2g} unknowns, more than the {:.2g} that can be "
                                "counted\n  = {}",
                                unknowns, most_unknowns, coarser));
  }
  if (!(static_cast<double>(cost.ion_steps) <= most_steps)) {
    throw UserError(fmt::format(
        "the ion transport would take about {:.2g} time steps, more than {:.0g}\n  = shorten the "
        "run "
        "(motion.cycles and the durations), or lower numerics.time_refinement; steps follow the "
        "charging time of the core, which check --explain shows",
        static_cast<double>(cost.ion_steps), most_steps));
  }
}

} // namespace

std::string shortage(const Case& input, int threads, const std::optional<mesh::Footprint>& found) {
  if (input.strain.kind == StrainSourceKind::file) {
    return "";
  }
  const CostEstimate cost = estimate_cost(input, threads, found);
  require_countable(cost);
  const base::AvailableMemory available = base::available_memory();
  if (cost.memory <= available.bytes) {
    return "";
  }
  return fmt::format("the case needs about {:.2g} GB of memory, and {:.2g} GB are {}\n  = {}; "
                     "IONSKIN_MEMORY_LIMIT=\"{:.0f} GB\" in the environment runs it all the same",
                     cost.memory * 1e-9, available.bytes * 1e-9, available.bound, coarser,
                     std::ceil(cost.memory * 1e-9));
}

void require_disk(double bytes, const std::filesystem::path& folder) {
  const base::AvailableDisk available = base::available_disk(folder);
  if (bytes > available.bytes) {
    throw UserError(fmt::format(
        "the files of the results will take about {}, and {} are {}\n  = keep fewer instants in "
        "output.fields, shorten the run, raise readout.sample_interval, take fewer points, or "
        "choose a folder on another disk; IONSKIN_DISK_LIMIT=\"{:.0f} MB\" in the environment "
        "runs it all the same",
        base::byte_text(bytes), base::byte_text(available.bytes), available.bound,
        std::ceil(bytes * 1e-6)));
  }
}

void require_resources(const Case& input, int threads,
                       const std::optional<mesh::Footprint>& found) {
  if (const std::string problem = shortage(input, threads, found); !problem.empty()) {
    throw UserError(problem);
  }
}

} // namespace ionskin::planning
