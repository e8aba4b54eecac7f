// SPDX-License-Identifier: Apache-2.0
#include "studio/data/gallery.hpp"

#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/base/files/read_text_file.hpp"
#include "ionskin/base/system/installation.hpp"
#include "ionskin/case/text/data_folder.hpp"
#include "studio/jobs/process.hpp"
#include "studio/server/limits.hpp"

#include <array>

namespace ionskin::apps::studio {

namespace fs = std::filesystem;

namespace {

struct Starter {
  const char* id; ///< file in the folder of cases, without .toml
  const char* name;
  const char* summary;
};

constexpr std::array<Starter, 11> starters{{
    {"quick", "A first look", "A block with rounded edges presses with 2 N and slides: coarse."},
    {"finger", "A fingertip", "A sphere presses with 1 N and strokes the skin."},
    {"taxels", "Taxels", "The same touch with 2 N; the top electrode in four named parts."},
    {"reciprocating", "Back and forth",
     "A fingertip rubs with 2 N: four strokes, a rest at each turn."},
    {"waypoints", "A path", "A fingertip draws an arc through waypoints, with 1 N to 2 N."},
    {"rolling", "A rolling ball", "A rubber ball lands with 5 N, rolls 3.5 mm and lifts."},
    {"pinch", "Two fingers",
     "Two fingertips press with 1 N and 1.5 N and draw towards each other."},
    {"poroelastic", "Moving water",
     "A wet skin is touched with 2 N: pressure moves water, which drags the ions."},
    {"bending", "A bent strip", "A wet strip under a curvature, without a slider: water and ions."},
    {"strain_file", "A strain file", "Ion transport alone, driven by shear from a file."},
    {"paper", "The paper's case", "A block presses with 65 N: three cycles at standard accuracy."},
}};

} // namespace

Json gallery() {
  Json all = Json::array();
  for (const Starter& starter : starters) {
    const fs::path file = data_folder() / "cases" / (std::string(starter.id) + ".toml");
    all.push_back({{"id", starter.id},
                   {"name", starter.name},
                   {"summary", starter.summary},
                   {"text", base::read_text_file(file.string(), "case", limits::body)}});
  }
  return all;
}

void prepare(const Workspace& workspace, const std::string& id) {
  std::error_code error;
  const fs::path target = workspace.root() / "strain.h5";
  if (id != "strain_file" || fs::exists(fs::symlink_status(target, error))) {
    return;
  }
  base::PendingFile file(target);
  const Outcome outcome =
      run_to_end({base::python_interpreter(), (data_folder() / "cases" / "make_strain.py").string(),
                  file.path().string()},
                 workspace.folder(), limits::check_time, 0);
  if (outcome.exit_code != 0) {
    throw HttpError(500, "the strain file cannot be written; ionskin doctor says what is missing");
  }
  file.commit();
}

} // namespace ionskin::apps::studio
