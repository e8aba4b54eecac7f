// SPDX-License-Identifier: Apache-2.0
#include "chain/rows.hpp"
#include "electrochemistry/model_run.hpp"
#include "ionskin/base/constants.hpp"
#include "ionskin/electrochemistry/ion_transport.hpp"
#include "ionskin/history/shear_statistics.hpp"

#include <cmath>

namespace ionskin::verification {

std::vector<Row> spike_rows(const Chain& chain, const Options& options) {
  const Case& input = chain.input;
  electrochemistry::IonOptions ion_options;
  ion_options.threads = options.threads;
  ion_options.progress = options.progress;
  base::Timers timers;
  const auto ions =
      electrochemistry::solve_ion_transport(input, chain.history, ion_options, timers);
  const double factor = constants::faraday * input.electrochemistry.fixed_charge_concentration *
                        input.coupling.coefficient * input.skin.core_volume();
  std::vector<Row> rows;
  const auto add = [&](const std::string& event, double begin, double end) {
    const std::size_t before = row_at(ions, begin);
    const std::size_t after = row_at(ions, end);
    const auto charge = [&](std::size_t row, double sign) {
      return 0.5 * (ions.charge_top[row] + sign * ions.charge_bottom[row]);
    };
    const auto shear_before = history::shear_statistics(chain.history, begin);
    const auto shear_after = history::shear_statistics(chain.history, end);
    // Events much shorter than the relaxation time, docs/model.md (29).
    const double common = factor * (shear_after.mean - shear_before.mean) / 2;
    rows.push_back(compare("C4", "common charge over " + event + " [uC]",
                           1e6 * (charge(after, 1) - charge(before, 1)), 1e6 * common,
                           1e6 * std::abs(common) * 1e-6));
    // The event of half a millisecond relaxes by its length over the relaxation time, 6 ms, at
    // most.
    const double difference = factor * (shear_after.first_moment - shear_before.first_moment);
    rows.push_back(compare("C4", "difference charge over " + event + " [uC]",
                           1e6 * (charge(after, -1) - charge(before, -1)), 1e6 * difference,
                           1e6 * std::abs(difference) * 0.1));
  };
  const auto& events = chain.history.event_time;
  add("touchdown", events[0], events[1]);
  add("lift-off", events[2], events[3]);
  return rows;
}

} // namespace ionskin::verification
