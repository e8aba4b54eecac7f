// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/store/fit_data.hpp"

#include "ionskin/base/error.hpp"
#include "scratch_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace ionskin::study {
namespace {

class FitDataFile : public testing::Test {
protected:
  std::filesystem::path write(const std::string& text) {
    const auto path = folder_.path() / "data.csv";
    std::ofstream(path) << text;
    return path;
  }
  std::string refusal(const std::string& text, const std::string& column = "") {
    try {
      read_fit_data(write(text), known_, column);
    } catch (const UserError& error) {
      return error.what();
    }
    return "accepted";
  }

  FitColumns known_ = fit_columns({});

private:
  results::ScratchFolder folder_;
};

TEST_F(FitDataFile, UnitsConvertAndEmptyEntriesArePassedOver) {
  const FitData data = read_fit_data(
      write("time [ms],note,current_difference [uA]\r\n1,a,2\r\n2,b,\r\n3,c,-4e-1\r\n\r\n"),
      known_);
  EXPECT_EQ(data.column, "current_difference");
  EXPECT_EQ(data.unit, "A");
  ASSERT_EQ(data.time.size(), 2u);
  EXPECT_NEAR(data.time[1], 3e-3, 1e-15);
  EXPECT_NEAR(data.values[0], 2e-6, 1e-18);
  EXPECT_NEAR(data.values[1], -0.4e-6, 1e-18);
}

TEST_F(FitDataFile, MistakesAreNamedWithTheirLine) {
  EXPECT_NE(refusal("t,current_top [A]\n1,2\n").find("no column time"), std::string::npos);
  EXPECT_NE(refusal("time [s],force [N]\n1,2\n").find("known:"), std::string::npos);
  EXPECT_NE(refusal("time [s],current_top\n1,2\n").find("unit [] of current_top"),
            std::string::npos);
  EXPECT_NE(refusal("time [s],current_top [V]\n1,2\n").find("convert to A"), std::string::npos);
  EXPECT_NE(refusal("time [s],current_top [A]\n1,2\n2,x\n").find("\"x\" in column"),
            std::string::npos);
  EXPECT_NE(refusal("time [s],current_top [A]\n2,2\n1,2\n").find("sort the rows by time"),
            std::string::npos);
  EXPECT_NE(refusal("time [s],current_top [A]\n1\n").find("1 entries under 2 columns"),
            std::string::npos);
  const std::string two = "time [s],current_top [A],charge_top [C]\n1,2,3\n";
  EXPECT_NE(refusal(two).find("--column"), std::string::npos);
  EXPECT_NE(refusal(two, "charge_tip").find("charge_top"), std::string::npos);
  EXPECT_EQ(refusal(two, "charge_top"), "accepted");
  EXPECT_THROW(read_fit_data("no/such/file.csv", known_), UserError);
}

TEST_F(FitDataFile, AsProgramsLeaveThem) {
  for (const char* text :
       {"time [s],current_top [A]\n1,2\n1,2\n3,4\n",
        "\xEF\xBB\xBFTime [s];current_top [A]\r1,0;2\r3,0;4\r",
        ",time [s],current_top [A]\n0,1,2\n1,3,4\n", "time [s],current_top [A],\n+1,2,\n3,4,\n",
        "\"time [s]\",\"current_top [A]\"\n\"1\",\"2\"\n\"3\",\"4\"\n",
        "Time (s)\tcurrent_top (A)\n1\t2\n3\t4\n",
        "time [s],current_top [A]\n1,2\n2,NaN\n3,4\n5,nan\n"}) {
    const FitData data = read_fit_data(write(text), known_);
    EXPECT_EQ(data.time, (std::vector<double>{1, 3})) << text;
    EXPECT_EQ(data.values, (std::vector<double>{2, 4})) << text;
  }
  const std::string twice = refusal("time [s],current_top [A]\n1,2\n1,3\n");
  EXPECT_NE(twice.find("1 s appears twice, with 2 and now with 3"), std::string::npos) << twice;
  EXPECT_NE(twice.find("data.csv:3"), std::string::npos) << twice;
  EXPECT_NE(twice.find("average"), std::string::npos) << twice;
  EXPECT_NE(refusal("time [s],current_top [A],current_top [A]\n1,2,3\n").find("appears twice"),
            std::string::npos);
}

/// Two taxels, of which the left one has a circuit of its own.
Case cut_case() {
  Case input;
  input.readout.taxels = {{"left", {0, 0}, {1e-3, 1e-3}, "load", {}},
                          {"right", {1e-3, 0}, {2e-3, 1e-3}, "", {}}};
  return input;
}

TEST_F(FitDataFile, ColumnsOfTaxelsAreThoseOfTheCase) {
  const std::string text = "time [s],voltage_left [mV],voltage_supply [V]\n1,2,3\n2,4,3\n";
  EXPECT_NE(refusal(text).find("known: charge_bottom"), std::string::npos);
  known_ = fit_columns(cut_case());
  const FitData data = read_fit_data(write(text), known_);
  EXPECT_EQ(data.column, "voltage_left");
  EXPECT_EQ(data.values, (std::vector<double>{2e-3, 4e-3}));
  EXPECT_EQ(taxel_of(data.column), "left");
  EXPECT_EQ(taxel_of("current_top"), "");
  EXPECT_NE(refusal(text, "voltage_lefft").find("did you mean voltage_left?"), std::string::npos);
  EXPECT_EQ(known_.count("current_top_right"), 1u);
  EXPECT_EQ(known_.count("voltage_right"), 0u); // it shares that of the electrode
  EXPECT_EQ(known_.count("charge_odd_right"), 0u);
  Case wet = cut_case();
  wet.coupling.law = "poroelastic";
  EXPECT_EQ(fit_columns(wet).count("charge_odd_right"), 1u);
}

electrochemistry::IonSolution solution() {
  electrochemistry::IonSolution ions;
  ions.time = {0, 1, 3};
  ions.charge_top = {5, 7, 3};
  ions.charge_bottom = {1, 1, 5};
  return ions;
}

TEST(FitPrediction, CurrentsAreMeansSinceTheRowBefore) {
  const auto ions = solution();
  EXPECT_EQ(predict({"current_top", "A", {1, 2, 3}, {}}, ions), (std::vector<double>{2, -2, -2}));
  EXPECT_EQ(predict({"current_bottom", "A", {1, 3}, {}}, ions), (std::vector<double>{0, 2}));
  EXPECT_EQ(predict({"current_difference", "A", {1, 3}, {}}, ions), (std::vector<double>{1, -2}));
  EXPECT_EQ(predict({"current_common", "A", {1, 3}, {}}, ions), (std::vector<double>{1, 0}));
  // The first interval is as long as the second: from 1.5 s on.
  EXPECT_EQ(predict({"current_top", "A", {2, 2.5}, {}}, ions), (std::vector<double>{-2, -2}));
  EXPECT_EQ(predict({"charge_top", "C", {0, 2}, {}}, ions), (std::vector<double>{5, 5}));
}

TEST(FitPrediction, TaxelsHaveWhatTheirColumnsSay) {
  auto ions = solution();
  ions.top_segments = {{"left", {0, 2, 6}, {0, -4, 2}, {1, 2, 0}, {0, -1, -3}, {}}};
  EXPECT_EQ(predict({"voltage_left", "V", {0.5, 3}, {}}, ions), (std::vector<double>{1.5, 0}));
  EXPECT_EQ(predict({"current_top_left", "A", {1, 3}, {}}, ions), (std::vector<double>{2, 2}));
  EXPECT_EQ(predict({"current_circuit_left", "A", {1, 3}, {}}, ions),
            (std::vector<double>{-1, -1}));
  EXPECT_EQ(predict({"charge_circuit_left", "C", {3}, {}}, ions), (std::vector<double>{-3}));
  EXPECT_EQ(predict({"charge_odd_left", "C", {1, 3}, {}}, ions), (std::vector<double>{3, 2}));
  EXPECT_EQ(predict({"current_even_left", "A", {1, 3}, {}}, ions), (std::vector<double>{-1, 2.5}));
}

TEST(FitPrediction, VoltagesAtOneRateAreMeansOverTheInterval) {
  auto ions = solution();
  ions.voltage = {0, 2, 0};
  FitData data{"voltage", "V", {1, 2, 3}, {}, true};
  EXPECT_TRUE(is_mean(data));
  EXPECT_EQ(predict(data, ions), (std::vector<double>{1, 1.5, 0.5}));
  data.time = {0.5, 1.5}; // over the kink at 1 s
  EXPECT_EQ(predict(data, ions), (std::vector<double>{0.5, 1.625}));
  data.at_one_rate = false;
  EXPECT_EQ(predict(data, ions), (std::vector<double>{1, 1.5}));
  data.column = "charge_top";
  data.at_one_rate = true;
  EXPECT_FALSE(is_mean(data));
}

TEST(FitPrediction, ARowBehindAGapStandsForOneInterval) {
  FitData record{"current_top", "A", {}, {}};
  for (const double row : {1, 2, 3, 4, 5, 9, 10, 11, 12, 13}) {
    record.time.push_back(0.1 * row);
  }
  EXPECT_NEAR(interval_starts(record, 0)[5], 0.8, 1e-12);
  EXPECT_EQ(interval_starts(record, 0)[6], record.time[5]);
  // Where steps differ as a solver chooses them, a row stands for all since the row before.
  record.time = {0.1, 0.2, 0.4, 0.8, 1.6, 3.0};
  EXPECT_EQ(interval_starts(record, 0).back(), 1.6);
}

TEST(FitPrediction, BeforeAndBehindTheRunNothingFlows) {
  EXPECT_EQ(predict({"current_top", "A", {-2, -1, 0}, {}}, solution()),
            (std::vector<double>{0, 0, 0}));
  EXPECT_EQ(predict({"current_top", "A", {3, 4, 5}, {}}, solution()),
            (std::vector<double>{-2, 0, 0}));
}

TEST(FitPrediction, RowsOutsideTheRun) {
  FitData data{"current_top", "A", {0, 1, 2}, {7, 8, 9}};
  restrict_to_run(data, 0, 2);
  EXPECT_EQ(data.values, (std::vector<double>{8, 9}));
  EXPECT_THROW(restrict_to_run(data, 0, 1.5), UserError);
  EXPECT_THROW(restrict_to_run(data, 2, 3), UserError);
}

} // namespace
} // namespace ionskin::study
