// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/metrics.hpp"

#include "ionskin/base/value_at.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ionskin::readout {
namespace {

// Mean over the run of a quantity whose mean over the step that ends at a row is `of_step(row)`; 0
// for fewer than two rows.
template <class StepMean>
double mean_over_steps(const std::vector<double>& time, const StepMean& of_step) {
  if (time.size() < 2) {
    return 0;
  }
  double integral = 0;
  for (std::size_t row = 1; row < time.size(); ++row) {
    integral += of_step(row) * (time[row] - time[row - 1]);
  }
  return integral / (time.back() - time.front());
}

class MetricList {
public:
  explicit MetricList(const SignalTable& signals) : signals_(signals) {}

  void at(const std::string& signal, const std::string& suffix, double instant) {
    const Signal& column = signals_.column(signal);
    add(signal + "_" + suffix, base::value_at(time(), column.values, instant), column.unit);
  }
  void peak(const std::string& prefix, const SignalTable& table, const std::string& signal) {
    const Signal& column = table.column(signal);
    add(prefix + signal, peak_magnitude(column.values), column.unit);
  }
  void add(const std::string& name, double value, const std::string& unit) {
    metrics_.push_back({name, value, unit});
  }
  const std::vector<double>& time() const { return signals_.column("time").values; }
  std::vector<Metric> take() { return std::move(metrics_); }

private:
  const SignalTable& signals_;
  std::vector<Metric> metrics_;
};

void add_motion_metrics(MetricList& list, const NamedInstants& instants) {
  const auto [touchdown, slide] = instants;
  list.at("normal_force", "touchdown", touchdown);
  list.at("normal_force", "slide", slide);
  list.at("tangential_force", "slide", slide);
  list.at("mean_shear", "touchdown", touchdown);
  list.at("mean_shear", "slide", slide);
  list.at("p99_shear", "slide", slide);
  list.at("shear_first_moment", "touchdown", touchdown);
  list.at("shear_first_moment", "slide", slide);
}

} // namespace

double peak_magnitude(const std::vector<double>& values) {
  double peak = 0;
  for (double value : values) {
    peak = std::fmax(peak, std::abs(value));
  }
  return peak;
}

double rms_linear(const std::vector<double>& time, const std::vector<double>& values) {
  return std::sqrt(mean_over_steps(time, [&](std::size_t row) {
    const double a = values[row - 1];
    const double b = values[row];
    return (a * a + a * b + b * b) / 3;
  }));
}

double rms_of_step_means(const std::vector<double>& time, const std::vector<double>& means) {
  return std::sqrt(mean_over_steps(time, [&](std::size_t row) { return means[row] * means[row]; }));
}

double time_mean(const std::vector<double>& time, const std::vector<double>& values) {
  return mean_over_steps(time,
                         [&](std::size_t row) { return 0.5 * (values[row - 1] + values[row]); });
}

std::vector<Metric> signal_metrics(const SignalTable& signals, const SignalTable& sampled,
                                   const std::optional<NamedInstants>& instants) {
  MetricList list(signals);
  if (instants) {
    add_motion_metrics(list, *instants);
  }
  const std::vector<double>& shear = signals.column("mean_shear").values;
  // A history of pressure alone has no shear, and a 0 would say that nothing is sheared.
  if (!std::ranges::all_of(shear, [](double value) { return std::isnan(value); })) {
    list.peak("peak_", signals, "mean_shear");
    list.add("time_mean_shear", time_mean(list.time(), shear), "1");
    list.add("rms_mean_shear", rms_linear(list.time(), shear), "1");
  }
  for (const char* electrode : {"top", "bottom", "difference", "common"}) {
    const std::string current = std::string("current_") + electrode;
    list.peak("peak_", signals, current);
    list.add("rms_" + current, rms_of_step_means(list.time(), signals.column(current).values), "A");
    list.peak("peak_sampled_", sampled, current);
  }
  list.add("initial_charge_top", signals.column("charge_top").values.front(), "C");
  list.add("initial_charge_bottom", signals.column("charge_bottom").values.front(), "C");
  return list.take();
}

double charge_identity_error(const std::vector<double>& charge_top,
                             const std::vector<double>& charge_bottom,
                             const std::vector<double>& expected, double scale) {
  double worst = 0;
  for (std::size_t row = 0; row < charge_top.size(); ++row) {
    const double violation = std::abs(charge_top[row] + charge_bottom[row] - expected[row]);
    // A NaN must fail the identity rather than vanish in a comparison.
    worst = std::isnan(violation) ? std::numeric_limits<double>::infinity()
                                  : std::max(worst, violation);
  }
  return worst == 0 ? 0 : worst / scale;
}

} // namespace ionskin::readout
