// SPDX-License-Identifier: Apache-2.0
#include "temporary_case.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/reading/read_case.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace ionskin {

namespace {

const char* const text_of_valid_case = R"(title = "A touch"

[skin]
length = "15 mm"
width = "2 mm"

[[skin.layers]]
name = "bottom electrode"
role = "electrode"
material = "platinum"
thickness = "10 um"

[[skin.layers]]
name = "ionomer"
role = "core"
material = "nafion"
thickness = "180 um"

[[skin.layers]]
name = "top electrode"
role = "electrode"
material = "platinum"
thickness = "10 um"

[slider]
size = ["3 mm", "1.5 mm"]
start = ["4.5 mm", "1 mm"]

[motion]
gap = "1 mm"
preload = "1 um"
stroke = "6 mm"
touchdown = "0.5 s"
slide = "2 s"
lift = "0.5 s"
return = "1 s"

[contact]
friction = 0.3 # a comment

[electrochemistry]
diffusivity = "7e-11 m2/s"
permittivity = "2e-3 F/m"
fixed_charge_concentration = "1200 mol/m3"

[coupling]
coefficient = 0.1
)";

} // namespace

TemporaryCase::TemporaryCase(const std::string& text) {
  std::string pattern = (std::filesystem::temp_directory_path() / "ionskin-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr)
    throw std::runtime_error("no temporary folder");
  folder_ = pattern;
  std::ofstream(path()) << text;
}

TemporaryCase::~TemporaryCase() {
  std::filesystem::remove_all(folder_);
}

std::string valid_case(const std::string& replace, const std::string& with) {
  std::string text = text_of_valid_case;
  const std::size_t position = text.find(replace);
  if (position == std::string::npos)
    throw std::runtime_error("the valid case has no text \"" + replace + "\"");
  return text.replace(position, replace.size(), with);
}

std::string error_of(const std::string& text) {
  const TemporaryCase file(text);
  try {
    read_case(file.path());
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

} // namespace ionskin
