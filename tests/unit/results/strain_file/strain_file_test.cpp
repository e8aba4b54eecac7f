// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/strain_file/strain_file.hpp"

#include "ionskin/results/results_file.hpp"
#include "scratch_folder.hpp"
#include "strain_example.hpp"

#include <gtest/gtest.h>

namespace ionskin::results {
namespace {

using history::CoreHistory;
using history::Frame;

void expect_equal(const CoreHistory& actual, const CoreHistory& expected) {
  EXPECT_EQ(actual.frame, expected.frame);
  EXPECT_EQ(actual.measure, expected.measure);
  EXPECT_EQ(actual.length, expected.length);
  EXPECT_EQ(actual.width, expected.width);
  EXPECT_EQ(actual.grid.x_edges, expected.grid.x_edges);
  EXPECT_EQ(actual.grid.y_edges, expected.grid.y_edges);
  EXPECT_EQ(actual.grid.z_nodes, expected.grid.z_nodes);
  EXPECT_EQ(actual.time, expected.time);
  EXPECT_EQ(actual.slider_x, expected.slider_x);
  EXPECT_EQ(actual.slider_y, expected.slider_y);
  EXPECT_EQ(actual.event_time, expected.event_time);
  ASSERT_EQ(actual.shear().size(), expected.shear().size());
  for (std::size_t i = 0; i < expected.shear().size(); ++i) {
    EXPECT_EQ(*actual.shear()[i], *expected.shear()[i]) << "sample " << i;
  }
}

TEST(StrainFile, ReadsBackEitherFrameExactly) {
  const ScratchFolder folder;
  for (Frame frame : {Frame::skin, Frame::slider}) {
    const CoreHistory written = example_history(frame);
    write_strain_file(folder / "strain.h5", written);
    expect_equal(read_strain_file(folder / "strain.h5", example_skin()), written);
  }
}

TEST(StrainFile, KeepsASliderThatMovesAcross) {
  const ScratchFolder folder;
  CoreHistory written = example_history(Frame::slider);
  written.grid.y_edges = {-2e-3, 2e-3};
  written.slider_y = {1e-3, 1e-3, 1.2e-3, 2e-3};
  write_strain_file(folder / "strain.h5", written);
  expect_equal(read_strain_file(folder / "strain.h5", example_skin()), written);
}

TEST(StrainFile, ReadsTheStrainOfAResultsFile) {
  const ScratchFolder folder;
  const CoreHistory written = example_history(Frame::slider);
  ResultsFile results(folder / "results.h5", ResultsFile::Start::empty);
  results.write_text("case", "title");
  results.write_strain(written);
  results.commit();
  expect_equal(read_strain_file(folder / "results.h5", example_skin()), written);
}

TEST(StrainFile, SharesEqualFields) {
  const ScratchFolder folder;
  write_strain_file(folder / "strain.h5", example_history(Frame::skin));
  const CoreHistory read = read_strain_file(folder / "strain.h5", example_skin());
  EXPECT_EQ(read.shear()[0], read.shear()[3]);
  EXPECT_NE(read.shear()[0], read.shear()[1]);
}

TEST(StrainFile, FindsEventsThatItDoesNotName) {
  const ScratchFolder folder;
  write_strain_file(folder / "strain.h5", example_history(Frame::skin));
  {
    Hdf5File file(folder / "strain.h5", Hdf5File::Access::modify);
    file.remove("/event_time");
  }
  const CoreHistory read = read_strain_file(folder / "strain.h5", example_skin());
  EXPECT_EQ(read.event_time, (std::vector<double>{0, 0.5, 0.75}));
}

TEST(StrainFile, AcceptsRoundedExtentsAndClosesTheSliver) {
  const ScratchFolder folder;
  CoreHistory written = example_history(Frame::skin);
  written.grid.z_nodes = {0, 2e-4 * (1 - 1e-12)};
  written.grid.x_edges.back() *= 1 - 1e-12;
  write_strain_file(folder / "strain.h5", written);
  EXPECT_EQ(read_strain_file(folder / "strain.h5", example_skin()).grid.z_nodes.back(), 2e-4);
}

} // namespace
} // namespace ionskin::results
