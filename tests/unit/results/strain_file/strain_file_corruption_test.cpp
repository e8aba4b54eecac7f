// SPDX-License-Identifier: Apache-2.0
// Damaged strain files are refused, or what is read of them is sane; nothing crashes and nothing
// hangs.
#include "corruption.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/timers.hpp"
#include "ionskin/results/strain_file/strain_file.hpp"
#include "scratch_folder.hpp"
#include "strain_example.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numeric>

namespace ionskin::results {
namespace {

void expect_sane(const history::CoreHistory& history) {
  ASSERT_EQ(history.shear().size(), history.time.size());
  for (const auto& field : history.shear()) {
    ASSERT_EQ(field->size(), history.grid.values());
    for (const double value : *field) {
      ASSERT_LE(std::abs(value), 1000);
    }
  }
  EXPECT_LE(std::abs(history.time.back()), 1e7);
}

TEST(StrainFileCorruption, EveryFileIsRefusedOrSane) {
  constexpr double most_seconds = 60; // machines of tests are busy
  const ScratchFolder folder;
  write_strain_file(folder / "whole.h5", example_history(history::Frame::slider));
  const std::string whole = read_all(folder / "whole.h5");
  int accepted = 0, crashes = 0, endless = 0;
  double longest = 0;
  const std::uint32_t count = corruptions(150);
  std::vector<std::uint32_t> seeds(count);
  std::iota(seeds.begin(), seeds.end(), 0u);
  seeds.push_back(266); // has kept the library busy without end
  for (const std::uint32_t seed : seeds) {
    SCOPED_TRACE(seed);
    write_all(folder / "strain.h5", corrupted(whole, seed));
    const double begin = base::wall_time();
    try {
      expect_sane(read_strain_file(folder / "strain.h5", example_skin()));
      ++accepted;
    } catch (const UserError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find("strain.h5"), std::string::npos) << message;
      EXPECT_NE(message.find("\n  = "), std::string::npos) << "no remedy: " << message;
      crashes += message.find("crashes on") != std::string::npos ? 1 : 0;
      if (message.find("without end") != std::string::npos) {
        std::printf("seed %u: endless\n", seed);
        ++endless;
      }
    }
    longest = std::max(longest, base::wall_time() - begin);
  }
  std::printf("%u damaged files: %d accepted, %d crashes and %d endless loops of the library kept "
              "apart, longest %.2f s\n",
              count, accepted, crashes, endless, longest);
  EXPECT_LT(longest, most_seconds);
  EXPECT_LT(accepted, static_cast<int>(count));
  EXPECT_GT(endless + crashes, 0);
}

} // namespace
} // namespace ionskin::results
