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
  write_collection(results, {0, 1.5}, {"", "_2"});
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

/// One cell in one layer, under a ball.
SkinSnapshot pressed() {
  SkinSnapshot result;
  result.time = 1.5;
  result.skin = {{0, 2e-3}, {0, 1e-3}, {0, 1e-4}, {0}, {}, {}};
  result.skin.displacement.fill(std::vector<double>(8, 1e-6));
  result.skin.stress.fill({2e5});
  result.centre = {1e-3, 0.5e-3};
  result.height = -1e-6;
  result.cell_x = {0.9e-3, 1.1e-3};
  result.cell_y = {0.4e-3, 0.6e-3};
  result.traction = {std::vector<double>{1e4}, {0}, {-1e5}};
  result.surface.fill({1e-6});
  return result;
}

TEST(VtuWriter, OpensSkinAndSliderBesideTheCore) {
  const ScratchFolder folder;
  OutputFolder results(folder.path(), ExistingFolder::refuse);
  Slider ball;
  ball.shape = "sphere";
  ball.parameters = {{"radius", 1e-3}};
  ball.size = {2e-3, 2e-3};
  write_fields(results, grid(), 1e-5, {snapshot(0), snapshot(1.5)});
  write_skin(results, ball, "", 1, pressed());
  write_skin(results, ball, "_2", 1, pressed());
  write_collection(results, {0, 1.5}, {"", "_2"});
  const std::string layers = read_all(folder / "fields/layers_0001.vtu");
  EXPECT_NE(layers.find("Name=\"stress\" NumberOfComponents=\"6\" ComponentName0=\"XX\""),
            std::string::npos);
  EXPECT_NE(read_all(folder / "fields/contact_0001.vtu").find("Name=\"traction\""),
            std::string::npos);
  // The circle holds a part of some 60 x 60 cells.
  const std::string slider = read_all(folder / "fields/slider_0001.vtu");
  const auto at = slider.find("NumberOfCells=\"") + 15;
  const int cells = std::stoi(slider.substr(at));
  EXPECT_GT(cells, 1500);
  EXPECT_NE(slider.find("NumberOfPoints=\"3969\""), std::string::npos)
      << "lines of the contact, too";
  EXPECT_LT(cells, 3500);
  const std::string collection = read_all(folder / "fields/fields.pvd");
  for (const char* file :
       {"fields_0000", "fields_0001", "layers_0001", "contact_0001", "slider_0001"}) {
    EXPECT_NE(collection.find(file), std::string::npos) << file;
  }
  EXPECT_EQ(collection.find("layers_0000"), std::string::npos)
      << "the mechanics was not solved here";
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
