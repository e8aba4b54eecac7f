// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/thin_layers.hpp"

#include "ionskin/base/constants.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/largest.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/circuits/circuit.hpp"
#include "ionskin/electrochemistry/circuit/electrode_segments.hpp"
#include "ionskin/electrochemistry/circuit/layer_circuit.hpp"
#include "ionskin/electrochemistry/coupling/driving_channel.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/electrochemistry/grid/mid_width_mirror.hpp"
#include "ionskin/electrochemistry/grid/transport_grid.hpp"
#include "ionskin/electrochemistry/time/solution_rows.hpp"
#include "ionskin/electrochemistry/time/step_control.hpp"
#include "ionskin/poroelasticity/line_modes.hpp"
#include "ionskin/poroelasticity/streaming_drive.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <utility>
#include <vector>

namespace ionskin::electrochemistry {
namespace {

/// Least charge that the steps resolve, over the charge by the largest drive, as for the full
/// equations.
constexpr double least_charge = 1e-3;

/// Amplitudes of cosine waves along the skin, [y][x]: half of the difference (odd) and half of the
/// sum (even) of top and bottom.
struct Waves {
  std::vector<double> odd, even;
};

/// Multiplies a square matrix along the middle index of a field [outer][size][inner].
std::vector<double> along(const std::vector<double>& matrix, std::size_t size, std::size_t inner,
                          const std::vector<double>& field) {
  std::vector<double> result(field.size(), 0.0);
  for (std::size_t block = 0; block < field.size(); block += size * inner) {
    for (std::size_t m = 0; m < size; ++m) {
      for (std::size_t i = 0; i < size; ++i) {
        const double weight = matrix[m * size + i];
        for (std::size_t k = 0; k < inner; ++k) {
          result[block + m * inner + k] += weight * field[block + i * inner + k];
        }
      }
    }
  }
  return result;
}

double width_of(const std::vector<double>& edges) {
  return (edges.back() - edges.front()) / static_cast<double>(edges.size() - 1);
}

/// Number of rejected steps, plus a number per accepted step, after which a run is given up; a few
/// per cent are usual.
constexpr std::size_t tries_in_vain = 1000, tries_in_vain_per_step = 10;

class ThinLayerRun {
public:
  ThinLayerRun(const Case& input, const history::CoreHistory& history, const IonOptions& options)
      : options_(options), grid_(make_transport_grid(input, history)), mirror_(grid_, history),
        scales_(derive_scales(input.electrochemistry, history.core_thickness())),
        control_(make_step_landings(history, {}),
                 step_rule(input.numerics, input.readout, scales_)),
        drive_(input, history, driving_channel(input.coupling.law, history), solved().x_edges,
               solved().y_edges, {0.0, history.core_thickness()}),
        x_(poroelasticity::cosine_modes(solved().x_edges.size() - 1, width_of(solved().x_edges))),
        y_(poroelasticity::cosine_modes(solved().y_edges.size() - 1, width_of(solved().y_edges))),
        columns_(x_.size * y_.size), area_(input.skin.length * input.skin.width),
        layer_(scales_.area_ratio * input.electrochemistry.permittivity / scales_.debye_length),
        valence_(input.electrochemistry.valence),
        resting_(input.electrochemistry.resting_concentration()),
        circuit_(0.5 * layer_ * area_, history.core_thickness() / (scales_.conductivity * area_),
                 circuits::circuit(input.readout.circuit, input.readout.parameters).admittance),
        segments_(make_electrode_segments(input.readout.taxels, grid_)),
        column_share_(control_.column_share(history.time.front())) {
    find_rates(0.5 * history.core_thickness());
  }

  IonSolution run() {
    begin();
    while (!control_.finished(time())) {
      base::check_interrupt();
      advance();
    }
    solution_.column_charge_top = column_charges().top;
    return std::move(solution_);
  }

private:
  const TransportGrid& solved() const { return mirror_.solved_grid(); }
  double time() const { return solution_.time.back(); }

  /// Charges per area of the walls as waves, and the state of the circuit.
  struct Charges {
    Waves wave; ///< [C/m2]
    LayerCircuit::State mean;
  };

  void find_rates(double half) {
    const double relaxation = scales_.conductivity / layer_;
    for (const double y : y_.curvature) {
      for (const double x : x_.curvature) {
        const double wave = std::sqrt(x + y), tanh = std::tanh(wave * half);
        odd_rate_.push_back(wave > 0 ? relaxation * wave / tanh : relaxation / half);
        even_rate_.push_back(relaxation * wave * tanh);
      }
    }
  }

  /// Charges per area that balance the drive of the instant evaluated last, as waves [C/m2].
  Waves sources(const std::vector<double>& drive) const {
    Waves wave;
    for (std::size_t i = 0; i < columns_; ++i) {
      const double bottom = drive[i], top = drive[columns_ + i];
      const double unit = 0.5 * layer_ * scales_.potential_scale;
      wave.odd.push_back(unit * (top - bottom));
      wave.even.push_back(unit * (top + bottom));
    }
    for (std::vector<double>* part : {&wave.odd, &wave.even}) {
      *part = along(y_.to_modes, y_.size, x_.size, along(x_.to_modes, x_.size, 1, *part));
    }
    return wave;
  }

  std::vector<double> columns_of(const std::vector<double>& wave) const {
    return along(y_.from_modes, y_.size, x_.size, along(x_.from_modes, x_.size, 1, wave));
  }

  /// Amplitude of the first wave, a uniform field, over its value.
  double mean_wave() const { return std::sqrt(static_cast<double>(columns_)); }
  /// Electromotive force S of the circuit [V].
  double force(const Waves& source) const {
    return 2.0 * source.odd.front() / (mean_wave() * layer_);
  }

  Charges step(const Charges& from, double duration, const Waves& begin, const Waves& end) const {
    Charges to = from;
    for (std::size_t m = 0; m < columns_; ++m) {
      to.wave.odd[m] = relaxed(from.wave.odd[m], odd_rate_[m], duration, begin.odd[m], end.odd[m]);
      to.wave.even[m] =
          relaxed(from.wave.even[m], even_rate_[m], duration, begin.even[m], end.even[m]);
    }
    to.mean = circuit_.step(from.mean, duration, force(begin), force(end));
    to.wave.odd.front() = to.mean.charge / area_ * mean_wave();
    return to;
  }

  /// Norm of charges per area [C/m2]: the larger of the mean and of the root mean square over the
  /// columns times `column_share_`.
  double size_of(double mean, const Waves& wave) const {
    const auto squares = [](const std::vector<double>& part) {
      return std::inner_product(part.begin(), part.end(), part.begin(), 0.0);
    };
    const double columns =
        std::sqrt((squares(wave.odd) + squares(wave.even)) / static_cast<double>(columns_));
    return base::nan_max(std::abs(mean), column_share_ * columns);
  }

  double difference(const Charges& a, const Charges& b) const {
    Waves wave = a.wave;
    for (std::size_t m = 0; m < columns_; ++m) {
      wave.odd[m] -= b.wave.odd[m];
      wave.even[m] -= b.wave.even[m];
    }
    return size_of((a.mean.charge - b.mean.charge) / area_, wave);
  }

  /// Moves the drive to an instant, with the water that the ions have dragged until then; returns
  /// `sources` there.
  Waves move(double time, const Charges& charges) {
    Waves source = sources(drive_.evaluate(time));
    const double unit = 1 / (valence_ * constants::faraday * mean_wave());
    const double odd = charges.wave.odd.front(), even = charges.wave.even.front();
    const std::vector<double> cations{-unit * (even - odd), -unit * (even + odd)};
    drive_.accept(cations);
    return source;
  }

  void begin() {
    solution_.grid = grid_;
    const double first = control_.landings().time.front();
    drive_.start(first);
    source_ = sources(drive_.evaluate(first));
    charges_ = {{std::vector<double>(columns_, 0.0), std::vector<double>(columns_, 0.0)},
                circuit_.start(force(source_))};
    scale_ = least_charge * drive_.largest() * layer_ * scales_.potential_scale;
    next_step_ = control_.first_step();
    append_row(first);
  }

  void advance() {
    const double begin = time();
    const poroelasticity::WaterState water = drive_.state();
    while (true) {
      const double end = control_.step_end(begin, next_step_), middle = 0.5 * (begin + end);
      // Water is dragged by the charges at the begin of each half of the step.
      const Waves between = move(middle, charges_);
      const Charges half = step(charges_, middle - begin, source_, between);
      Waves last = move(end, half);
      Charges whole = step(half, end - middle, between, last);
      const double size = size_of(whole.mean.charge / area_, whole.wave);
      const double scale = base::nan_max(scale_, size);
      const double error =
          scale > 0 ? difference(whole, step(charges_, end - begin, source_, last)) / scale : 0.0;
      const double share = error / control_.tolerance();
      if (share <= 1.0) {
        charges_ = std::move(whole);
        source_ = std::move(last);
        scale_ = scale;
        next_step_ = control_.after_success(begin, end, next_step_, share);
        ++solution_.steps;
        append_row(end);
        const auto [from, to] = control_.span();
        options_.progress("ion transport", (end - from) / (to - from));
        return;
      }
      ++solution_.rejected_steps;
      if (solution_.rejected_steps > tries_in_vain + tries_in_vain_per_step * solution_.steps) {
        throw SolverError(fmt::format("the charge of thin double layers makes no progress: {} "
                                      "steps and {} failed attempts reached t = {:.9g} s",
                                      solution_.steps, solution_.rejected_steps, begin),
                          "raise numerics.time_tolerance, or make the motion slower");
      }
      drive_.restore(water);
      next_step_ = control_.after_rejection(begin, end, share);
      if (control_.too_short(next_step_)) {
        throw SolverError(fmt::format("the charge of thin double layers found no step that is "
                                      "short enough at t = {:.9g} s",
                                      begin),
                          "raise numerics.time_tolerance");
      }
    }
  }

  /// Charges of the columns of the whole grid [C].
  WallCharges column_charges() const {
    const double column = area_ / (mirror_.copies() * static_cast<double>(columns_));
    const std::vector<double> odd = columns_of(charges_.wave.odd),
                              even = columns_of(charges_.wave.even);
    WallCharges charges;
    for (std::size_t i = 0; i < columns_; ++i) {
      charges.top.push_back(column * (even[i] + odd[i]));
      charges.bottom.push_back(column * (even[i] - odd[i]));
    }
    charges.total_top = std::accumulate(charges.top.begin(), charges.top.end(), 0.0);
    charges.total_bottom = std::accumulate(charges.bottom.begin(), charges.bottom.end(), 0.0);
    mirror_.complete(charges);
    return charges;
  }

  void append_row(double time) {
    const WallCharges charges = column_charges();
    solution_.time.push_back(time);
    solution_.charge_top.push_back(charges.total_top);
    solution_.charge_bottom.push_back(charges.total_bottom);
    solution_.ramo_charge_top.push_back(charges.total_top);
    append_segments(segments_, charges, 1.0, solution_);
    append_water(drive_, area_, solution_.water);
    solution_.relaxation_charge.push_back(charges_.mean.charge);
    solution_.relaxation_current.push_back(charges_.mean.rate);
    solution_.voltage.push_back(charges_.mean.voltage);
    solution_.ion_amount.push_back(resting_ * area_ * grid_.z_nodes.back());
    append_extremes(charges);
    solution_.shear_integral.push_back(0.0);
  }

  /// Appends the extremes of concentration and potential: at a wall of charge q per area the layer
  /// lacks q/(v F lambda) of cations, and the potential falls by q lambda/eps across it.
  void append_extremes(const WallCharges& charges) {
    double lowest = 0, largest = 0;
    for (const auto* wall : {&charges.top, &charges.bottom}) {
      const auto [low, high] = std::ranges::minmax(*wall);
      lowest = std::max(lowest, high);
      largest = std::max({largest, high, -low});
    }
    const double per_area = static_cast<double>(charges.top.size()) / area_;
    solution_.min_concentration.push_back(
        resting_ * (1.0 - lowest * per_area / scales_.area_ratio / scales_.charge_density));
    solution_.max_potential.push_back(
        base::nan_max(largest * per_area / layer_, std::abs(charges_.mean.voltage)));
  }

  const IonOptions& options_;
  TransportGrid grid_;
  MidWidthMirror mirror_;
  DerivedScales scales_;
  StepControl control_;
  poroelasticity::StreamingDrive drive_;
  poroelasticity::LineModes x_, y_;
  std::size_t columns_;
  double area_;  ///< of the skin [m2]
  double layer_; ///< capacitance of a double layer per area, eps/lambda [F/m2]
  double valence_, resting_;
  LayerCircuit circuit_;
  ElectrodeSegments segments_;
  double column_share_;
  std::vector<double> odd_rate_, even_rate_; ///< of each wave [1/s]
  Waves source_;
  Charges charges_;
  double scale_ = 0, next_step_ = 0;
  IonSolution solution_;
};

} // namespace

IonSolution solve_thin_layers(const Case& input, const history::CoreHistory& history,
                              const IonOptions& options) {
  return ThinLayerRun(input, history, options).run();
}

double thin_layer_error(const Electrochemistry& electrochemistry, double core_thickness) {
  return 2 * derive_scales(electrochemistry, core_thickness).debye_length / core_thickness;
}

} // namespace ionskin::electrochemistry
