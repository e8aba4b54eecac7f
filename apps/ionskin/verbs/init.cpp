// SPDX-License-Identifier: Apache-2.0
#include "verbs/init.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/installation.hpp"
#include "ionskin/case/text/data_folder.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace ionskin::apps {

namespace fs = std::filesystem;

int init(const InitOptions& options) {
  const fs::path source = data_folder() / "cases" / (options.from + ".toml");
  if (!fs::is_regular_file(source))
    throw UserError(
        fmt::format("there is no starter case {}\n  = it comes with ionskin: ionskin doctor says "
                    "where from; the "
                    "environment variable IONSKIN_DATA names the folder that holds cases/",
                    source.string()));
  std::error_code error;
  const fs::path target = options.path;
  if (fs::exists(fs::symlink_status(target, error)))
    throw UserError(
        fmt::format("{} exists already and is not overwritten\n  = choose another name, or remove "
                    "it first",
                    options.path));
  if (!fs::copy_file(source, target, error))
    throw UserError(
        fmt::format("{} cannot be written: {}\n  = check its folder and its permissions",
                    options.path, error.message()));
  std::string first;
  if (options.from == "strain_file") {
    first = fmt::format("First: {} {} {}\n", base::python_interpreter(),
                        (data_folder() / "cases" / "make_strain.py").string(),
                        (target.parent_path() / "strain.h5").string());
  }
  // Results of an earlier case in "out" would be refused.
  const std::string output = fs::exists("out", error) ? target.stem().string() : "out";
  fmt::print("Wrote {0}.\n{1}Next: ionskin check {0} --explain\n      ionskin run {0} -o {2}\n",
             options.path, first, output);
  return 0;
}

} // namespace ionskin::apps
