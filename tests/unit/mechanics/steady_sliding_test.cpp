// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/solve_contact.hpp"
#include "small_case.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::mechanics {
namespace {

TEST(SteadySliding, FoundByItselfIsWhatAPathPassesThrough) {
  const Case input = small_case();
  base::Timers timers;
  ContactOptions options;
  options.threads = 2;
  for (const double fraction : {0.13, 0.5, 1.0}) {
    Case asked = input;
    asked.output.fields = {0.5 + fraction * input.motion.slide};
    const ContactState direct =
        solve_steady_sliding(input, {fraction * input.motion.stroke}, options, timers).front();
    const ContactSolution solution = solve_contact(asked, options, timers);
    const SteppedInstant& passed = nearest(solution, asked.output.fields.front());
    EXPECT_NEAR(passed.time, asked.output.fields.front(), 1e-12);
    // Cells slip against what the surface itself moves too: 4e-7 of the force.
    EXPECT_NEAR(passed.state->normal_force, direct.normal_force, 1e-6 * direct.normal_force);
    const CoreStrain strain = core_strain(*passed.state);
    double difference = 0, size = 0;
    for (std::size_t c = 0; c < 6; ++c) {
      for (std::size_t i = 0; i < strain.component[c].size(); ++i) {
        difference += std::pow(strain.component[c][i] - direct.strain.component[c][i], 2);
        size += std::pow(direct.strain.component[c][i], 2);
      }
    }
    EXPECT_LT(std::sqrt(difference / size), 1e-5) << fraction;
  }
}

} // namespace
} // namespace ionskin::mechanics
