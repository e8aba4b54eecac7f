// SPDX-License-Identifier: Apache-2.0

// Any `--set` argument, or several parted by line ends, changes a valid case or is refused.

#include "ionskin/base/error.hpp"
#include "ionskin/base/files/read_text_file.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/case/text/data_folder.hpp"

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string path =
      (ionskin::data_folder() / "cases" / "paper" / "coarse.toml").string();
  static const std::string original = ionskin::base::read_text_file(path, "case");
  std::istringstream arguments(std::string(reinterpret_cast<const char*>(data), size));
  std::vector<std::string> edits;
  for (std::string edit; edits.size() < 4 && std::getline(arguments, edit);)
    edits.push_back(edit);
  try {
    ionskin::read_case_text(original, path, edits);
  } catch (const ionskin::UserError&) {
  }
  return 0;
}
