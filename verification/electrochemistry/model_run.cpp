// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/model_run.hpp"

#include "ionskin/base/error.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::verification {

electrochemistry::IonSolution run_model(const Case& input, const history::CoreHistory& history,
                                        const Options& options) {
  electrochemistry::IonOptions ion_options;
  ion_options.threads = options.threads;
  ion_options.progress = options.progress;
  base::Timers timers;
  return electrochemistry::solve_ion_transport(input, history, ion_options, timers);
}

double charge_difference(const electrochemistry::IonSolution& solution, std::size_t row) {
  return 0.5 * (solution.charge_top[row] - solution.charge_bottom[row]);
}

std::size_t row_at(const electrochemistry::IonSolution& solution, double time) {
  const auto found = std::ranges::find_if(
      solution.time, [time](double value) { return std::abs(value - time) < 1e-9; });
  if (found == solution.time.end()) {
    throw InternalError("no time step ends at the instant of a reference value");
  }
  return static_cast<std::size_t>(found - solution.time.begin());
}

} // namespace ionskin::verification
