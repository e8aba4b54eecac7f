// SPDX-License-Identifier: Apache-2.0
#include "study_verbs/python_verbs.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/schema/schema.hpp"
#include "ionskin/study/run/python_module.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace ionskin::apps {
namespace {

int run_module(const std::string& module, const std::vector<std::string>& arguments) {
  const int code =
      study::run_python_module(module, arguments, study::PythonErrors::shown).exit_code;
  if (code < 0) {
    throw UserError(study::python_interpreter() +
                    " cannot be started\n  = ionskin doctor says what is missing");
  }
  return code;
}

} // namespace

int report(const ReportOptions& options) {
  std::vector<std::string> arguments{options.folder, "--all"};
  if (options.claims) {
    arguments.emplace_back("--claims");
  }
  for (const std::string& figure : options.figures) {
    arguments.insert(arguments.end(), {"--figure", figure});
  }
  return run_module("ionskin.report", arguments);
}

int compare(const CompareOptions& options) {
  // A case may leave out what it then takes from the schema.
  nlohmann::json defaults = nlohmann::json::object();
  for (const SchemaRow& row : schema()) {
    if (!row.default_value.empty()) {
      defaults[row.key] = row.default_value;
    }
  }
  return run_module("ionskin.compare",
                    {options.first, options.second, "--tolerance",
                     fmt::format("{}", options.tolerance), "--defaults", defaults.dump()});
}

} // namespace ionskin::apps
