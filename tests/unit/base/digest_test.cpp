// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/digest.hpp"

#include "ionskin/base/system/own_build.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdlib.h>
#include <string>
#include <string_view>
#include <vector>

namespace ionskin::base {
namespace {

TEST(Digest, DependsOnEveryValueAndOnWhereTextsEnd) {
  const auto of = [](const auto&... values) {
    DigestBuilder builder;
    (builder.add(values), ...);
    return builder.finish();
  };
  EXPECT_EQ(of(1.0, 2.0), of(1.0, 2.0));
  EXPECT_NE(of(1.0, 2.0), of(2.0, 1.0));
  EXPECT_NE(of(0.0), of(-0.0));
  EXPECT_NE(of(std::string_view("ab"), std::string_view("c")),
            of(std::string_view("a"), std::string_view("bc")));
  EXPECT_NE(of(std::vector<double>{1.0}), of(std::vector<double>{1.0, 0.0}));
  EXPECT_EQ(of(1.0).hex().size(), 32u);
}

TEST(OwnBuild, IsIdentifiedByTheProgramsOwnCode) {
  std::string name = (std::filesystem::temp_directory_path() / "ionskin-build-XXXXXX").string();
  const std::filesystem::path folder = mkdtemp(name.data());
  const std::filesystem::path program = folder / "program";
  EXPECT_FALSE(build_digest(program));
  std::ofstream(program) << "one build";
  const auto one = build_digest(program);
  std::ofstream(program) << "another build";
  const auto another = build_digest(program);
  std::filesystem::remove_all(folder);
  ASSERT_TRUE(one && another && own_build());
  EXPECT_NE(*one, *another);
}

} // namespace
} // namespace ionskin::base
