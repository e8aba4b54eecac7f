// SPDX-License-Identifier: Apache-2.0
#include "study_verbs/trial_verbs.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/installation.hpp"
#include "ionskin/study/run/python_module.hpp"

#include <nlohmann/json.hpp>
#include <string>

namespace ionskin::apps {

// Python takes the options under these names.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TrialOptions, case_path, output, on, set_edits, threads,
                                   overwrite, resume, quiet)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(UncertaintyOptions, vary, samples, design, seed, metrics,
                                   least_q2)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(DesignOptions, free, subject_to, maximise, minimise, budget,
                                   seed)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(GenerateOptions, vary, touches, balance, seed)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(MotionOptions, recordings, output, columns, origin, x_axis,
                                   y_axis, tool, force_in, level, contact_force, gap, rate, filter,
                                   tare, angles, overwrite, quiet)

namespace {

[[noreturn]] void run_with(const std::string& module, const nlohmann::json& options) {
  std::string text;
  try {
    text = options.dump();
  } catch (const nlohmann::json::type_error&) {
    throw UserError("an option is not UTF-8 text\n  = write options and names of files in UTF-8");
  }
  study::become_python_module(module, {text}); // which then gets the signals itself
  throw UserError(base::python_interpreter() +
                  " cannot be started\n  = ionskin doctor says what is missing");
}

template <class Options>
[[noreturn]] void run_trials(const std::string& module, const Options& options) {
  nlohmann::json all = static_cast<const TrialOptions&>(options);
  all.update(nlohmann::json(options));
  run_with(module, all);
}

} // namespace

int uncertainty(const UncertaintyOptions& options) {
  run_trials("ionskin.uncertainty", options);
}

int design(const DesignOptions& options) {
  if (options.maximise.empty() == options.minimise.empty()) {
    throw UserError("nothing to optimise\n  = give --maximise METRIC or --minimise METRIC");
  }
  run_trials("ionskin.design", options);
}

int generate(const GenerateOptions& options) {
  run_trials("ionskin.generation", options);
}

int motion(const MotionOptions& options) {
  run_with("ionskin.reading.recording", options);
}

} // namespace ionskin::apps
