// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/model_run.hpp"
#include "ionskin/poroelasticity/prescribed_load.hpp"
#include "ionskin/poroelasticity/water_properties.hpp"
#include "poroelasticity/layer_after.hpp"
#include "poroelasticity/rows.hpp"
#include "poroelasticity/wet_cell.hpp"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

namespace ionskin::verification {
namespace {

using poroelasticity::open_wall;
using poroelasticity::Relaxation;
using poroelasticity::RelaxingLoad;
using poroelasticity::sealed_wall;
using std::numbers::pi;
using Complex = std::complex<double>;

/// Value at a time of the function with a given Laplace transform (Talbot's contour; Abate and
/// Valko 2004, doi 10.1002/nme.995).
double at_time(const std::function<Complex(Complex)>& transform, double time) {
  constexpr int nodes = 24;
  const double scale = 2.0 * nodes / (5 * time);
  double sum = 0.5 * std::exp(scale * time) * transform(scale).real();
  for (int k = 1; k < nodes; ++k) {
    const double angle = k * pi / nodes, cotangent = 1 / std::tan(angle);
    const Complex place = scale * angle * Complex(cotangent, 1);
    const Complex slope(1, angle + (angle * cotangent - 1) * cotangent);
    sum += (std::exp(place * time) * transform(place) * slope).real();
  }
  return scale / nodes * sum;
}

/// Maxwell element beside a spring: half of the shear modulus relaxes, as fast as the water moves.
Relaxation maxwell(RelaxingLoad load) {
  const double shear_share = load == RelaxingLoad::strain ? 1.0 / 3 : 4.0 / 3;
  return {{0.1}, {0.15}, 0.3, shear_share, 9.0, load};
}

/// Moduli of a core in the Laplace domain, over the modulus M of the first instant.
struct Moduli {
  Moduli(const Relaxation& core, Complex s) {
    shear = core.shear;
    for (std::size_t i = 0; i < core.times.size(); ++i) {
      shear -= core.lost[i] / (1.0 + s * core.times[i]);
    }
    swelling = 1.0 + core.shear_share * (shear - core.shear);
    stored = 1.0 / core.storage + 1.0 / swelling;
  }
  /// Moduli of shear and swelling; `stored`: stored water per pressure.
  Complex shear, swelling, stored;
};

/// Undrained pressure in the Laplace domain after a step of the load, over that of the first
/// instant, and the square of the water's wave number.
struct Transform {
  Transform(const Relaxation& core, Complex s) {
    const Moduli now(core, s);
    const double share = core.storage / (1 + core.storage); // c_v is 1: K M is 1/share
    const Complex stress = core.load == RelaxingLoad::strain ? now.shear / core.shear : 1.0;
    undrained = stress / (s * now.swelling * now.stored * share);
    wave = std::sqrt(s * now.stored * share);
  }
  Complex undrained, wave;
};

/// Pressure difference between the sealed walls of a bent layer, over that of the first instant.
double bent_difference(const Relaxation& core, double time) {
  return at_time(
      [&](Complex s) {
        const Transform water(core, s);
        return water.undrained * (1.0 - std::tanh(0.5 * water.wave) / (0.5 * water.wave));
      },
      time);
}

double bent_difference(std::size_t elements, const Relaxation& core, double time) {
  const Layer layer{elements, {sealed_wall, sealed_wall}, 0, core};
  const auto pressure = layer.after_step([](double z) { return z - 0.5; }, time);
  return pressure.back() - pressure.front();
}

/// Mean pressure of a pressed layer with one open face.
double pressed_mean(const Relaxation& core, double time) {
  return at_time(
      [&](Complex s) {
        const Transform water(core, s);
        return water.undrained * (1.0 - std::tanh(water.wave) / water.wave);
      },
      time);
}

double pressed_mean(std::size_t elements, const Relaxation& core, double time) {
  const Layer layer{elements, {sealed_wall, open_wall}, 0, core};
  return layer.integral(layer.after_step([](double) { return 1.0; }, time));
}

/// Case of a narrow strip of a relaxing polymer, bent by 1/m at the first instant, with open
/// terminals.
Case bent_polymer() {
  Case input = wet_case();
  Material& core = input.skin.layers[1].material;
  core.youngs_modulus = 1.95e8; // undrained; with M = 390 MPa the drained ratio is 0.4
  core.relaxation_times = {10};
  core.relaxation_shares = {0.5};
  input.skin.sides = SideCondition::free;
  input.strain.kind = StrainSourceKind::prescribed;
  input.strain.curvature = 1;
  input.readout.circuit = "open";
  return input;
}

} // namespace

std::vector<Row> relaxation_rows(const Options& options) {
  std::vector<Row> rows;
  const Relaxation bent = maxwell(RelaxingLoad::strain), pressed = maxwell(RelaxingLoad::pressure);
  for (const double time : {0.02, 0.1, 0.5}) {
    rows.push_back(compare(
        "P14",
        fmt::format("pressure difference of a bent Maxwell solid with water, c_v t/h2 = {}", time),
        bent_difference(12, bent, time), bent_difference(bent, time), 1e-4));
    rows.push_back(compare(
        "P14",
        fmt::format("mean pressure of a pressed one with an open wall at c_v t/h2 = {}", time),
        pressed_mean(12, pressed, time), pressed_mean(pressed, time), 1e-5));
  }
  rows.push_back(at_least(
      "P14", "observed order of it in the elements", order_in_elements([&](std::size_t elements) {
        return pressed_mean(elements, pressed, 0.1) - pressed_mean(pressed, 0.1);
      }),
      3.8));
  Case dry = bent_polymer();
  dry.water.mobility = 1e-40;
  const double thickness = dry.skin.core_thickness();
  const auto water = poroelasticity::derive_water_properties(dry);
  for (const double time : {1.0, 10.0, 60.0}) {
    const double left = 1 - 0.5 * -std::expm1(-time / 10);
    const double expected =
        left * water.streaming_coefficient * 1.95e8 * thickness / 3 * layer_factor(dry);
    rows.push_back(compare(
        "P14",
        fmt::format("open-circuit voltage of a bent Maxwell solid whose water stands, {} s [V]",
                    time),
        final_voltage(dry, time, options), expected, 2e-3 * expected));
  }
  // In the end the pressure is even, and only the dilution is left.
  const Case wet = bent_polymer();
  const double relaxed = 1.95e8 / 2 / 3;                         // G in the end
  const double drained = water.drained_modulus - 1.95e8 / 3 / 3; // K_d
  const double expected = water.dilution * water.thermal_voltage * relaxed /
                          (drained + relaxed / 3) * thickness * layer_factor(wet);
  const double settled =
      100 + 20 * poroelasticity::derive_water_properties(wet).consolidation_time(thickness);
  rows.push_back(compare("P14", "the same when its water has settled [V]",
                         final_voltage(wet, settled, options), expected, 5e-3 * expected));
  return rows;
}

} // namespace ionskin::verification
