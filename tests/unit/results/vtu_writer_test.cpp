// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/vtu_writer.hpp"

#include "ionskin/base/error.hpp"
#include "scratch_folder.hpp"

#include <gtest/gtest.h>

namespace ionskin::results {
namespace {

electrochemistry::TransportGrid grid() {
  return {{0, 1e-3, 2e-3}, {0, 1e-3}, {0, 1e-5, 2e-5}};
}

electrochemistry::IonSnapshot snapshot(double time) {
  electrochemistry::IonSnapshot result;
  result.time = time;
  result.concentration = {1200, 1201, 1202, 1203, 1204, 1205};
  result.potential = result.shear = {0, 0.1, 0.2, 0.3, 0.4, 0.5};
  return result;
}

TEST(VtuWriter, WritesOneFilePerInstantAndTheCollection) {
  const ScratchFolder folder;
  OutputFolder results(folder.path(), ExistingFolder::refuse);
  write_fields(results, grid(), 1e-5, {snapshot(0), snapshot(1.5)});
  const std::string vtu = read_all(folder / "fields/fields_0001.vtu");
  // Two columns of two elements, four points at each of three levels.
  EXPECT_NE(vtu.find("NumberOfPoints=\"24\" NumberOfCells=\"4\""), std::string::npos);
  for (const char* name : {"concentration", "potential", "shear"}) {
    EXPECT_NE(vtu.find(std::string("Name=\"") + name + "\""), std::string::npos) << name;
  }
  EXPECT_NE(vtu.find("</VTKFile>"), std::string::npos);
  const std::string collection = read_all(folder / "fields/fields.pvd");
  EXPECT_NE(collection.find("timestep=\"1.5\""), std::string::npos) << collection;
  EXPECT_NE(collection.find("fields_0001.vtu"), std::string::npos);
}

TEST(VtuWriter, NamesAFolderThatCannotBeMade) {
  const ScratchFolder folder;
  OutputFolder results(folder.path(), ExistingFolder::refuse);
  write_all(folder / "fields", "a file in the way");
  const std::string message =
      message_of<UserError>([&] { write_fields(results, grid(), 0, {snapshot(0)}); });
  EXPECT_NE(message.find("fields"), std::string::npos);
}

} // namespace
} // namespace ionskin::results
