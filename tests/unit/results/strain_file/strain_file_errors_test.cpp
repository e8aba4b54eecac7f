// SPDX-License-Identifier: Apache-2.0
// Every mistake in a strain file is a UserError that says what, where and what to do.
#include "ionskin/base/error.hpp"
#include "ionskin/results/strain_file/strain_file.hpp"
#include "scratch_folder.hpp"
#include "strain_example.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace ionskin::results {
namespace {

using history::CoreHistory;
using history::Frame;

struct Mistake {
  const char* name;
  Frame frame;
  std::function<void(CoreHistory&)> in_history;
  std::function<void(Hdf5File&)> in_file;
  std::vector<std::string> words; ///< words that the message must hold
};

void keep(CoreHistory&) {}
void leave(Hdf5File&) {}

// Replaces one dataset by numbers of another shape.
std::function<void(Hdf5File&)> replace(const std::string& dataset, std::vector<double> values,
                                       Hdf5File::Shape shape = {}) {
  return [=](Hdf5File& file) {
    file.remove(dataset);
    file.write(dataset, values, shape);
    file.set_attribute(dataset, "unit", std::string(dataset == "/gamma" ? "1" : "m"));
  };
}

void set_value(CoreHistory& history, std::size_t sample, std::size_t index, double value) {
  auto field = std::make_shared<history::StrainField>(*history.shear()[sample]);
  (*field)[index] = value;
  history.shear()[sample] = field;
}

const double infinity = std::numeric_limits<double>::infinity();

const std::vector<Mistake> mistakes{
    {"endless",
     Frame::skin,
     [](CoreHistory& history) { history.time.back() = 1e300; },
     leave,
     {"time is 1e+300 s at index 3", "to 10000000 s"}},
    {"times too close",
     Frame::skin,
     [](CoreHistory& history) {
       history.time = {0, 5e-324, 1, 2};
     },
     leave,
     {"time ascends by", "leave at least 1e-15 s"}},
    {"endless skin",
     Frame::skin,
     [](CoreHistory& history) { history.grid.x_edges.back() = 1e300; },
     leave,
     {"grid/x is 1e+300 m at index 3", "100 m"}},
    {"absurd shear",
     Frame::skin,
     [](CoreHistory& history) { set_value(history, 1, 2, 1e300); },
     leave,
     {"gamma is 1e+300 at", "from -1000 to 1000"}},
    {"no format",
     Frame::skin,
     keep,
     [](Hdf5File& file) { file.set_attribute("/", "format", 3); },
     {"attribute format is missing", "ionskin-strain"}},
    {"other format",
     Frame::skin,
     keep,
     [](Hdf5File& file) { file.set_attribute("/", "format", std::string("other")); },
     {"format is \"other\"", "ionskin-strain"}},
    {"other version",
     Frame::skin,
     keep,
     [](Hdf5File& file) { file.set_attribute("/", "version", 3); },
     {"version is 3", "reads versions 1 and 2"}},
    {"version as text",
     Frame::skin,
     keep,
     [](Hdf5File& file) { file.set_attribute("/", "version", std::string("1")); },
     {"number attribute version is missing"}},
    {"no measure",
     Frame::skin,
     keep,
     [](Hdf5File& file) { file.set_attribute("/", "measure", 1.0); },
     {"attribute measure is missing"}},
    {"unknown frame",
     Frame::skin,
     keep,
     [](Hdf5File& file) { file.set_attribute("/", "frame", std::string("lab")); },
     {"frame is \"lab\"", "slider_x"}},
    {"no gamma",
     Frame::skin,
     keep,
     [](Hdf5File& file) { file.remove("/gamma"); },
     {"dataset /gamma is missing"}},
    {"no z",
     Frame::skin,
     keep,
     [](Hdf5File& file) { file.remove("/grid/z"); },
     {"dataset /grid/z is missing"}},
    {"no slider_x",
     Frame::slider,
     keep,
     [](Hdf5File& file) { file.remove("/slider_x"); },
     {"/slider_x is missing"}},
    {"text for numbers",
     Frame::skin,
     keep,
     [](Hdf5File& file) {
       file.remove("/time");
       file.write_text("/time", "now");
     },
     {"/time is not a dataset of numbers"}},
    {"time in two dimensions",
     Frame::skin,
     keep,
     replace("/grid/x", {0, 1, 2, 3}, {2, 2}),
     {"grid/x has 2 dimensions"}},
    {"other unit of length",
     Frame::skin,
     keep,
     [](Hdf5File& file) { file.set_attribute("/grid/x", "unit", std::string("mm")); },
     {"grid/x has the unit \"mm\"", "\"m\""}},
    {"no unit of gamma",
     Frame::skin,
     keep,
     [](Hdf5File& file) {
       file.remove("/gamma");
       file.write("/gamma", std::vector<double>(24, 0.0), {4, 2, 1, 3});
     },
     {"gamma has no attribute unit", "attrs"}},
    {"percent",
     Frame::skin,
     keep,
     [](Hdf5File& file) { file.set_attribute("/gamma", "unit", std::string("%")); },
     {"gamma has the unit \"%\""}},
    {"wrong shape",
     Frame::skin,
     keep,
     replace("/gamma", std::vector<double>(36, 0.0), {4, 3, 1, 3}),
     {"gamma has the shape [4, 3, 1, 3]", "[4, 2, 1, 3]"}},
    {"gamma in one dimension",
     Frame::skin,
     keep,
     replace("/gamma", std::vector<double>(24, 0.0)),
     {"gamma has the shape [24]"}},
    {"NaN",
     Frame::skin,
     [](CoreHistory& history) { set_value(history, 1, 4, NAN); },
     leave,
     {"gamma is NaN at [time, z, y, x] = [1, 1, 0, 1]", "0.5 s"}},
    {"infinite",
     Frame::skin,
     [](CoreHistory& history) { set_value(history, 2, 0, infinity); },
     leave,
     {"gamma is infinite at [time, z, y, x] = [2, 0, 0, 0]"}},
    {"NaN in time",
     Frame::skin,
     [](CoreHistory& history) { history.time[2] = NAN; },
     leave,
     {"time is NaN at index 2"}},
    {"time not ascending",
     Frame::skin,
     [](CoreHistory& history) { history.time[2] = 0.5; },
     leave,
     {"time does not ascend at index 2: 0.5 follows 0.5"}},
    {"edges not ascending",
     Frame::skin,
     [](CoreHistory& history) { history.grid.x_edges[1] = -1; },
     leave,
     {"grid/x does not ascend at index 1: -1 follows 0"}},
    {"one node", Frame::skin, keep, replace("/grid/z", {0.0}), {"grid/z has 1 entries"}},
    {"slider_x too short",
     Frame::slider,
     keep,
     replace("/slider_x", {1e-3, 1e-3}),
     {"slider_x has 2 entries, time has 4"}},
    {"slider_x is NaN",
     Frame::slider,
     [](CoreHistory& history) { history.slider_x[3] = NAN; },
     leave,
     {"slider_x is NaN at index 3"}},
    {"x too short",
     Frame::skin,
     [](CoreHistory& history) {
       history.grid.x_edges = {0, 1e-3, 2e-3, 2.5e-3};
     },
     leave,
     {"does not cover the core along x", "0.0025 m", "0.003 m"}},
    {"y too short",
     Frame::skin,
     [](CoreHistory& history) {
       history.grid.y_edges = {1e-3, 2e-3};
     },
     leave,
     {"does not cover the core along y", "0.001 to 0.002 m"}},
    {"z too short",
     Frame::skin,
     [](CoreHistory& history) {
       history.grid.z_nodes = {0, 1.8e-4};
     },
     leave,
     {"does not cover the core along z", "0.00018 m", "0.0002 m"}},
    {"millimetres",
     Frame::skin,
     [](CoreHistory& history) {
       history.grid.z_nodes = {0, 0.2};
     },
     leave,
     {"does not cover the core along z", "0.2 m", "metres"}},
    {"slider runs off its grid",
     Frame::slider,
     [](CoreHistory& history) { history.slider_x[3] = 2.5e-3; },
     leave,
     {"does not cover the core along x", "0.0005 to 0.003 m"}},
    {"event between samples",
     Frame::skin,
     [](CoreHistory& history) {
       history.event_time = {0, 0.6};
     },
     leave,
     {"event_time holds 0.6 s"}},
};

TEST(StrainFileErrors, EveryMistakeIsExplained) {
  const ScratchFolder folder;
  for (const Mistake& mistake : mistakes) {
    SCOPED_TRACE(mistake.name);
    CoreHistory history = example_history(mistake.frame);
    mistake.in_history(history);
    write_strain_file(folder / "strain.h5", history);
    {
      Hdf5File file(folder / "strain.h5", Hdf5File::Access::modify);
      mistake.in_file(file);
    }
    const std::string message =
        message_of<UserError>([&] { read_strain_file(folder / "strain.h5", example_skin()); });
    for (const std::string& word : mistake.words) {
      EXPECT_NE(message.find(word), std::string::npos) << "'" << word << "' not in: " << message;
    }
    EXPECT_NE(message.find("strain.h5"), std::string::npos) << message;
    EXPECT_NE(message.find("\n  = "), std::string::npos) << "no remedy: " << message;
  }
}

TEST(StrainFileErrors, FilesThatCannotBeRead) {
  const ScratchFolder folder;
  const auto read = [&](const std::string& name) {
    return message_of<UserError>([&] { read_strain_file(folder / name, example_skin()); });
  };
  EXPECT_NE(read("missing.h5").find("missing.h5 cannot be read"), std::string::npos);
  write_all(folder / "text.h5", "0 1 2");
  EXPECT_NE(read("text.h5").find("text.h5 is not an HDF5 file"), std::string::npos);
}

TEST(StrainFileErrors, TheUnspoiltExampleIsAccepted) {
  const ScratchFolder folder;
  for (Frame frame : {Frame::skin, Frame::slider}) {
    write_strain_file(folder / "strain.h5", example_history(frame));
    EXPECT_NO_THROW(read_strain_file(folder / "strain.h5", example_skin()));
  }
}

} // namespace
} // namespace ionskin::results
