// SPDX-License-Identifier: Apache-2.0
#include "study_verbs/trial_verbs.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/study/run/python_module.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ionskin::apps {
namespace {

using Words = std::vector<std::string>;

/// "--name=value", which holds for values that begin with a dash too.
std::string word(const std::string& name, const std::string& value) {
  return fmt::format("--{}={}", name, value);
}

void add_all(Words& words, const std::string& name, const std::vector<std::string>& values) {
  for (const std::string& value : values) {
    words.push_back(word(name, value));
  }
}

Words common(const TrialOptions& options) {
  Words words{word("output", options.output), fmt::format("--threads={}", options.threads)};
  add_all(words, "set", options.set_edits);
  if (!options.on.empty()) {
    words.push_back(word("on", options.on));
  }
  for (const auto& [given, flag] :
       {std::pair{options.overwrite, "--overwrite"}, std::pair{options.resume, "--resume"},
        std::pair{options.quiet, "--quiet"}}) {
    if (given) {
      words.emplace_back(flag);
    }
  }
  return words;
}

int run_words(const std::string& module, const Words& words) {
  // The script handles an interrupt and ends with its code; this process waits for it.
  base::install_interrupt_handler();
  const int code = study::run_python_module(module, words, study::PythonErrors::shown).exit_code;
  if (code < 0) {
    throw UserError(study::python_interpreter() +
                    " cannot be started or was killed\n  = ionskin doctor says what is missing");
  }
  return code;
}

int run_trials(const std::string& module, Words words, const TrialOptions& options) {
  words.insert(words.end(), {"--", options.case_path});
  return run_words(module, words);
}

} // namespace

int uncertainty(const UncertaintyOptions& options) {
  Words words = common(options);
  add_all(words, "vary", options.vary);
  words.insert(words.end(), {fmt::format("--samples={}", options.samples),
                             word("design", options.design), fmt::format("--seed={}", options.seed),
                             word("metrics", fmt::format("{}", fmt::join(options.metrics, ","))),
                             fmt::format("--least-q2={}", options.least_q2)});
  return run_trials("ionskin.uncertainty", words, options);
}

int design(const DesignOptions& options) {
  if (options.maximise.empty() == options.minimise.empty()) {
    throw UserError("nothing to optimise\n  = give --maximise METRIC or --minimise METRIC");
  }
  Words words = common(options);
  add_all(words, "free", options.free);
  add_all(words, "subject-to", options.subject_to);
  words.insert(words.end(), {options.maximise.empty() ? word("minimise", options.minimise)
                                                      : word("maximise", options.maximise),
                             fmt::format("--budget={}", options.budget),
                             fmt::format("--seed={}", options.seed)});
  return run_trials("ionskin.design", words, options);
}

int generate(const GenerateOptions& options) {
  Words words = common(options);
  add_all(words, "vary", options.vary);
  words.insert(words.end(), {fmt::format("--touches={}", options.touches),
                             fmt::format("--seed={}", options.seed)});
  return run_trials("ionskin.generation", words, options);
}

int motion(const MotionOptions& options) {
  Words words{word("output", options.output), word("force-in", options.force_in),
              word("level", options.level)};
  add_all(words, "column", options.columns);
  for (const auto& [name, value] : {std::pair{"origin", options.origin},
                                    {"x-axis", options.x_axis},
                                    {"y-axis", options.y_axis},
                                    {"tool", options.tool},
                                    {"contact-force", options.contact_force},
                                    {"gap", options.gap},
                                    {"rate", options.rate},
                                    {"filter", options.filter}}) {
    if (!value.empty()) {
      words.push_back(word(name, value));
    }
  }
  for (const auto& [given, flag] :
       {std::pair{options.tare, "--tare"}, std::pair{options.overwrite, "--overwrite"},
        std::pair{options.quiet, "--quiet"}}) {
    if (given) {
      words.emplace_back(flag);
    }
  }
  words.emplace_back("--");
  words.insert(words.end(), options.recordings.begin(), options.recordings.end());
  return run_words("ionskin.reading.recording", words);
}

} // namespace ionskin::apps
