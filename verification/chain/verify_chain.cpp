// SPDX-License-Identifier: Apache-2.0
#include "chain/rows.hpp"
#include "electrochemistry/model_cases.hpp"
#include "ionskin/handover/handover.hpp"
#include "ionskin/mechanics/solve_contact.hpp"
#include "mechanics/baseline_case.hpp"

namespace ionskin::verification {

std::vector<Row> verify_chain(const Options& options) {
  Case input = baseline_case();
  input.motion.cycles = 1;
  input.electrochemistry = model_case().electrochemistry;
  input.coupling = {.law = "fixed-charge", .coefficient = 0.1};
  mechanics::ContactOptions contact_options;
  contact_options.threads = options.threads;
  contact_options.progress = options.progress;
  base::Timers timers;
  const auto contact = mechanics::solve_contact(input, contact_options, timers);
  const Chain chain{input, contact, handover::build_strain_history(input, contact)};
  std::vector<Row> rows = smooth_sliding_rows(chain, options);
  const auto spikes = spike_rows(chain, options);
  rows.insert(rows.end(), spikes.begin(), spikes.end());
  return rows;
}

} // namespace ionskin::verification
