// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/checks/check_case.hpp"

#include "ionskin/case/checks/check_crossbar.hpp"
#include "ionskin/case/checks/check_drive.hpp"
#include "ionskin/case/checks/check_electrochemistry.hpp"
#include "ionskin/case/checks/check_laws.hpp"
#include "ionskin/case/checks/check_metal.hpp"
#include "ionskin/case/checks/check_motion.hpp"
#include "ionskin/case/checks/check_prescribed.hpp"
#include "ionskin/case/checks/check_readout.hpp"
#include "ionskin/case/checks/check_relaxation.hpp"
#include "ionskin/case/checks/check_sizes.hpp"
#include "ionskin/case/checks/check_slider.hpp"
#include "ionskin/case/checks/check_track.hpp"
#include "ionskin/case/checks/check_water.hpp"
#include "ionskin/case/run_duration.hpp"

#include "ionskin/base/text.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

namespace ionskin {

namespace {

std::string layer_key(std::size_t layer, const std::string& property) {
  return fmt::format("skin.layers[{}].{}", layer, property);
}

std::vector<Pointer> joined(std::vector<Pointer> first, const std::vector<Pointer>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

void check_layer_names(const CaseDocument& document, Problems& problems) {
  const std::vector<Layer>& layers = document.input.skin.layers;
  for (std::size_t i = 0; i < layers.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (layers[i].name == layers[j].name)
        problems.add(fmt::format("two layers have the name \"{}\"", base::shown(layers[i].name)),
                     joined(document.point_at(layer_key(j, "name"), "first"),
                            document.point_at(layer_key(i, "name"), "second")),
                     "give every layer a name of its own");
}

void check_core(const CaseDocument& document, Problems& problems) {
  const std::vector<Layer>& layers = document.input.skin.layers;
  std::vector<Pointer> cores, all;
  std::size_t core = 0;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::vector<Pointer> place = document.point_at(layer_key(i, "role"));
    all = joined(all, place);
    if (layers[i].role == LayerRole::core) {
      cores = joined(cores, place);
      core = i;
    }
  }
  const std::string remedy =
      "a skin has exactly one core: electrode, core, electrode from bottom to top";
  if (cores.size() != 1) {
    problems.add(fmt::format("the skin has {} layers with role = \"core\"", cores.size()),
                 cores.empty() ? all : cores, remedy);
    return;
  }
  if (core == 0)
    problems.add("the core is the lowest layer: the bottom electrode is missing", cores,
                 "add a layer with role = \"electrode\" before it");
  if (core + 1 == layers.size())
    problems.add("the core is the highest layer: the top electrode is missing", cores,
                 "add a layer with role = \"electrode\" behind it");
}

void check_preload(const CaseDocument& document, Problems& problems) {
  const double preload = document.input.motion.preload;
  const double thickness = document.input.skin.thickness();
  if (preload < thickness)
    return;
  problems.add(
      fmt::format("motion.preload = {:.6g} mm reaches through the skin, which is {:.6g} mm thick",
                  preload * 1e3, thickness * 1e3),
      document.point_at("motion.preload"),
      fmt::format("it must be below {:.6g} mm; the strain is small only for much less",
                  thickness * 1e3));
}

void check_instants(const CaseDocument& document, Problems& problems) {
  const double duration = run_duration(document.input).value();
  const double interval = document.input.readout.sample_interval;
  if (interval > duration)
    problems.add(
        fmt::format("readout.sample_interval = {:.6g} s is longer than the run of {:.6g} s",
                    interval, duration),
        joined(document.point_at("readout.sample_interval"),
               joined(document.point_at("motion.cycles",
                                        "cycles of touchdown, slide, lift and return"),
                      document.point_at("strain.duration"))),
        fmt::format("it must be at most {:.6g} s", duration));
  for (const double instant : document.input.output.fields)
    if (instant > duration) {
      problems.add(fmt::format("output.fields: {:.6g} s lies behind the end of the run at {:.6g} s",
                               instant, duration),
                   document.point_at("output.fields"),
                   fmt::format("choose instants from 0 s to {:.6g} s", duration));
      return;
    }
}

void check_strain_file(const CaseDocument& document, Problems& problems) {
  const std::string& file = document.input.strain.file;
  std::error_code ignored;
  // Only regular files are opened, because opening a pipe would wait for its writer.
  if (!std::filesystem::is_regular_file(file, ignored) || !std::ifstream(file))
    problems.add(
        fmt::format("the strain file {} cannot be read", base::shown(file)),
        document.point_at("strain.file"),
        "strain.file is relative to the folder of the case file; check its name and permissions, "
        "and that it is a regular file");
}

} // namespace

void check_case(const CaseDocument& document) {
  Problems problems;
  check_layer_names(document, problems);
  check_core(document, problems);
  check_electrochemistry(document, problems);
  check_laws(document, problems);
  check_water(document, problems);
  check_relaxation(document, problems);
  check_readout(document, problems);
  check_crossbar(document, problems);
  check_metal(document, problems);
  if (document.input.strain.kind == StrainSourceKind::contact) {
    check_slider(document, problems);
    if (check_motion(document, problems)) {
      check_track(document, problems);
      check_friction_of_speed(document, problems);
      check_adhesion(document, problems);
      check_drive(document, problems);
      check_instants(document, problems);
      check_sizes(document, problems);
    }
    check_preload(document, problems);
  } else if (document.input.strain.kind == StrainSourceKind::file) {
    check_strain_file(document, problems);
  } else {
    check_prescribed_load(document, problems);
    check_instants(document, problems);
    check_sizes(document, problems);
  }
  problems.throw_if_any(document.file);
}

} // namespace ionskin
