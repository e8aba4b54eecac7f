// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/checks/check_prescribed.hpp"

#include "ionskin/case/coupling.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <string>
#include <vector>

namespace ionskin {

namespace {

/// Smallest radius of a bend over the thickness of the core. The strain of the core's faces, half
/// the thickness over the radius, must be small.
constexpr double least_radius = 1.0;

/// Largest prescribed compression over the thickness of the core.
constexpr double largest_compression = 0.1;

/// Largest number of periods of a sinusoidal load: each has 64 samples, which take at least one
/// time step each.
constexpr double most_periods = 1000;

std::vector<Pointer> places(const CaseDocument& document, std::initializer_list<const char*> keys) {
  std::vector<Pointer> all;
  for (const char* key : keys)
    for (const Pointer& pointer : document.point_at(key))
      all.push_back(pointer);
  return all;
}

void check_law(const CaseDocument& document, Problems& problems) {
  if (!moves_water(document.input))
    problems.add(fmt::format("a prescribed pressure or curvature gives the law \"{}\" nothing to "
                             "read: it is driven by shear, and neither makes any along the skin",
                             document.input.coupling.law),
                 places(document, {"strain.source", "coupling.law"}),
                 "set coupling.law = \"poroelastic\" with a section [water], or give the shear "
                 "with strain.source = \"file\"");
}

void check_load(const CaseDocument& document, Problems& problems) {
  const StrainSource& strain = document.input.strain;
  const Water& water = document.input.water;
  const int loads = (strain.pressure != 0) + (strain.compression != 0) + (strain.curvature != 0);
  const bool outside = water.bottom_pressure != 0 || water.top_pressure != 0;
  if (loads > 1)
    problems.add("more than one load is prescribed",
                 places(document, {"strain.pressure", "strain.compression", "strain.curvature"}),
                 "give one of strain.pressure, strain.compression and strain.curvature: the first "
                 "two leave the strain along the skin at 0, bending leaves the faces free");
  if (loads == 0 && !outside)
    problems.add("no load is prescribed, or one of 0", places(document, {"strain.source"}),
                 "give strain.pressure, such as \"100 kPa\", strain.compression, such as \"1 um\", "
                 "strain.curvature, such as \"20 1/m\", or the pressure of water outside an open "
                 "wall, water.top_pressure");
  if (strain.compression != 0 && outside)
    problems.add(
        "strain.compression is given beside a pressure of the water outside",
        places(document, {"strain.compression", "water.bottom_pressure", "water.top_pressure"}),
        "press with strain.pressure instead, or leave the water outside at rest");
  const double thickness = document.input.skin.core_thickness();
  if (std::abs(strain.compression) > largest_compression * thickness)
    problems.add(fmt::format("strain.compression = {:.6g} um is more than a tenth of the core, "
                             "{:.6g} um thick",
                             strain.compression * 1e6, thickness * 1e6),
                 places(document, {"strain.compression"}),
                 fmt::format("it must be at most {:.6g} um in magnitude: the law holds for small "
                             "strain",
                             1e6 * largest_compression * thickness));
  if (std::abs(strain.curvature) * thickness > 1 / least_radius)
    problems.add(fmt::format("strain.curvature = {:.6g} 1/m bends the core, {:.6g} mm thick, to a "
                             "radius of {:.6g} mm",
                             strain.curvature, thickness * 1e3, 1e3 / std::abs(strain.curvature)),
                 places(document, {"strain.curvature"}),
                 fmt::format("it must be at most {:.6g} 1/m in magnitude; the strain is small only "
                             "for much less",
                             1 / (least_radius * thickness)));
}

/// Checks that a key of one waveform is given with this waveform and with no other.
void check_key(const CaseDocument& document, const char* key, double value, LoadWaveform waveform,
               const char* name, Problems& problems) {
  const bool used = document.input.strain.waveform == waveform;
  if (used && value == 0)
    problems.add(fmt::format("strain.waveform = \"{}\" without {}", name, key),
                 places(document, {"strain.waveform"}), fmt::format("give {}", key));
  if (!used && value != 0)
    problems.add(fmt::format("{} is given, but strain.waveform is not \"{}\"", key, name),
                 places(document, {key, "strain.waveform"}),
                 fmt::format("remove the key, or set strain.waveform = \"{}\"", name));
}

void check_waveform(const CaseDocument& document, Problems& problems) {
  const StrainSource& strain = document.input.strain;
  check_key(document, "strain.rise", strain.rise, LoadWaveform::ramp, "ramp", problems);
  check_key(document, "strain.frequency", strain.frequency, LoadWaveform::sine, "sine", problems);
  if (strain.waveform == LoadWaveform::ramp && strain.rise > strain.duration)
    problems.add(fmt::format("strain.rise = {:.6g} s is longer than the run of {:.6g} s",
                             strain.rise, strain.duration),
                 places(document, {"strain.rise", "strain.duration"}),
                 fmt::format("it must be at most {:.6g} s", strain.duration));
  const double periods = strain.frequency * strain.duration;
  if (strain.waveform == LoadWaveform::sine && periods > most_periods)
    problems.add(fmt::format("the load swings {:.6g} times in {:.6g} s, more than {:.0f} times",
                             periods, strain.duration, most_periods),
                 places(document, {"strain.frequency", "strain.duration"}),
                 fmt::format("strain.duration may be at most {:.6g} s here: the response repeats "
                             "itself after a few periods",
                             most_periods / strain.frequency));
}

} // namespace

void check_prescribed_keys(const CaseDocument& document, Problems& problems) {
  if (document.input.strain.kind == StrainSourceKind::prescribed) {
    check_law(document, problems);
    return;
  }
  for (const char* key : {"strain.pressure", "strain.compression", "strain.curvature",
                          "strain.waveform", "strain.rise", "strain.frequency", "strain.duration"})
    if (const auto where = places(document, {key}); !where.empty())
      problems.add(fmt::format("{} is given, but strain.source is not \"prescribed\"", key), where,
                   "set strain.source = \"prescribed\", or remove the key");
}

void check_prescribed_load(const CaseDocument& document, Problems& problems) {
  check_load(document, problems);
  check_waveform(document, problems);
}

} // namespace ionskin
