// SPDX-License-Identifier: Apache-2.0
#include "study_verbs/trial_verbs.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/installation.hpp"
#include "ionskin/base/system/interrupt.hpp"
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

int run_with(const std::string& module, const nlohmann::json& options) {
  std::string text;
  try {
    text = options.dump();
  } catch (const nlohmann::json::type_error&) {
    throw UserError("an option is not UTF-8 text\n  = write options and names of files in UTF-8");
  }
  // The script handles an interrupt and ends with its code; this process waits for it.
  base::install_interrupt_handler();
  const int code = study::run_python_module(module, {text}, study::PythonErrors::shown).exit_code;
  if (code < 0) {
    throw UserError(base::python_interpreter() +
                    " cannot be started or was killed\n  = ionskin doctor says what is missing");
  }
  return code;
}

template <class Options> int run_trials(const std::string& module, const Options& options) {
  nlohmann::json all = static_cast<const TrialOptions&>(options);
  all.update(nlohmann::json(options));
  return run_with(module, all);
}

} // namespace

int uncertainty(const UncertaintyOptions& options) {
  return run_trials("ionskin.uncertainty", options);
}

int design(const DesignOptions& options) {
  if (options.maximise.empty() == options.minimise.empty()) {
    throw UserError("nothing to optimise\n  = give --maximise METRIC or --minimise METRIC");
  }
  return run_trials("ionskin.design", options);
}

int generate(const GenerateOptions& options) {
  return run_trials("ionskin.generation", options);
}

int motion(const MotionOptions& options) {
  return run_with("ionskin.reading.recording", options);
}

} // namespace ionskin::apps
