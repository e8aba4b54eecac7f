// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/fit/data_adjustment.hpp"

#include "ionskin/base/error.hpp"

#include <algorithm>

namespace ionskin::study {
namespace {

constexpr const char* time_shift_key = "data.time_shift";
constexpr const char* baseline_key = "data.baseline";
constexpr const char* drift_key = "data.drift";
constexpr const char* gain_key = "data.gain";

} // namespace

double& DataAdjustment::of(std::string_view key) {
  if (key == time_shift_key) {
    return time_shift;
  }
  if (key == baseline_key) {
    return baseline;
  }
  if (key == drift_key) {
    return drift;
  }
  if (key == gain_key) {
    return gain;
  }
  throw InternalError("no key of the data: " + std::string(key));
}

const std::vector<std::string>& data_keys() {
  static const std::vector<std::string> keys = {time_shift_key, baseline_key, drift_key, gain_key};
  return keys;
}

bool is_data_key(std::string_view key) {
  return std::ranges::find(data_keys(), key) != data_keys().end();
}

std::string data_key_unit(std::string_view key, const std::string& unit) {
  if (key == time_shift_key) {
    return "s";
  }
  if (key == gain_key) {
    return "1";
  }
  return key == drift_key ? unit + "/s" : unit;
}

FitData without_shift(FitData data, double time_shift) {
  for (double& time : data.time) {
    time -= time_shift;
  }
  return data;
}

std::vector<double> predict(const FitData& data, const electrochemistry::IonSolution& ions,
                            const DataAdjustment& adjustment) {
  std::vector<double> result = adjustment.time_shift == 0
                                   ? predict(data, ions)
                                   : predict(without_shift(data, adjustment.time_shift), ions);
  for (std::size_t row = 0; row < result.size(); ++row) {
    result[row] = adjustment.gain * result[row] + adjustment.baseline +
                  adjustment.drift * (data.time[row] - data.time.front());
  }
  return result;
}

std::vector<double> predict_shifted(const FitData& data, const electrochemistry::IonSolution& ions,
                                    double time_shift) {
  DataAdjustment adjustment;
  adjustment.time_shift = time_shift;
  return predict(data, ions, adjustment);
}

} // namespace ionskin::study
