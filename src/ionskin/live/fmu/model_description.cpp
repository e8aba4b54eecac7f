// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/fmu/model_description.hpp"

#include "ionskin/base/text.hpp"
#include "ionskin/live/data/skin_archive.hpp"
#include "ionskin/live/fmu/variables.hpp"

#include <fmt/format.h>

#include <iterator>

namespace ionskin::live::fmu {
namespace {

constexpr std::string_view units = R"(  <UnitDefinitions>
    <Unit name="m"><BaseUnit m="1"/></Unit>
    <Unit name="m2"><BaseUnit m="2"/></Unit>
    <Unit name="N"><BaseUnit kg="1" m="1" s="-2"/></Unit>
    <Unit name="N.m"><BaseUnit kg="1" m="2" s="-2"/></Unit>
    <Unit name="rad"><BaseUnit rad="1"/></Unit>
    <Unit name="C"><BaseUnit A="1" s="1"/></Unit>
    <Unit name="A"><BaseUnit A="1"/></Unit>
  </UnitDefinitions>
)";

/// Text as the value of an attribute; control characters, which XML cannot hold, become spaces.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : base::printable(text)) {
    switch (letter) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += static_cast<unsigned char>(letter) < ' ' ? ' ' : letter;
    }
  }
  return result;
}

/// XML attributes of a variable: causality, variability and, except for inputs, `initial`.
std::string_view role(const Variable& variable) {
  switch (variable.causality) {
  case Causality::input:
    return R"(causality="input" variability="continuous")";
  case Causality::parameter:
    return R"(causality="parameter" variability="tunable" initial="exact")";
  default:
    return variable.kind == Kind::real
               ? R"(causality="output" variability="continuous" initial="calculated")"
               : R"(causality="output" variability="discrete" initial="calculated")";
  }
}

/// XML element of a variable's type, with unit and start value where it has them.
std::string value(const Variable& variable) {
  const bool starts = variable.causality != Causality::output;
  switch (variable.kind) {
  case Kind::boolean:
    return fmt::format("<Boolean{}/>", !starts               ? ""
                                       : variable.start != 0 ? " start=\"true\""
                                                             : " start=\"false\"");
  case Kind::integer:
    return "<Integer/>";
  default:
    return fmt::format("<Real{}{}/>",
                       variable.unit.empty() ? "" : fmt::format(" unit=\"{}\"", variable.unit),
                       starts ? fmt::format(" start=\"{}\"", variable.start) : "");
  }
}

} // namespace

std::string guid(const SkinData& data) {
  const std::string bytes = skin_bytes(data);
  return "{" + bytes.substr(bytes.size() - digest_digits) + "}";
}

std::string model_description(const SkinData& data, const std::string& name) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  const auto out = std::back_inserter(text);
  fmt::format_to(
      out,
      "<fmiModelDescription fmiVersion=\"2.0\" modelName=\"{}\" guid=\"{}\"\n"
      "    description=\"Ionic skin, trained by: {}\"\n"
      "    license=\"Apache-2.0; the library holds fmt (MIT), xxHash (BSD-2-Clause) and GCC's "
      "C++ library (GPL-3.0 with the runtime library exception)\"\n"
      "    generationTool=\"ionskin {}\" variableNamingConvention=\"flat\" "
      "numberOfEventIndicators=\"0\">\n"
      "  <CoSimulation modelIdentifier=\"{}\" canHandleVariableCommunicationStepSize=\"true\"\n"
      "      canNotUseMemoryManagementFunctions=\"true\" canGetAndSetFMUstate=\"true\" "
      "canSerializeFMUstate=\"true\"/>\n"
      "{}"
      "  <LogCategories>\n"
      "    <Category name=\"logStatusDiscard\"/>\n"
      "    <Category name=\"logStatusError\"/>\n"
      "    <Category name=\"logStatusWarning\"/>\n"
      "  </LogCategories>\n"
      "  <DefaultExperiment startTime=\"0\" stopTime=\"1\" stepSize=\"0.001\"/>\n"
      "  <ModelVariables>\n",
      escaped(name), guid(data), escaped(data.command), escaped(data.version), model_identifier,
      units);
  const std::vector<Variable> list = variables(data);
  std::string outputs;
  for (std::size_t i = 0; i < list.size(); ++i) {
    fmt::format_to(out,
                   "    <ScalarVariable name=\"{}\" valueReference=\"{}\" {}\n"
                   "        description=\"{}\">{}</ScalarVariable>\n",
                   escaped(list[i].name), i, role(list[i]), escaped(list[i].description),
                   value(list[i]));
    if (list[i].causality == Causality::output) {
      fmt::format_to(std::back_inserter(outputs), "      <Unknown index=\"{}\"/>\n", i + 1);
    }
  }
  fmt::format_to(out,
                 "  </ModelVariables>\n"
                 "  <ModelStructure>\n"
                 "    <Outputs>\n{0}    </Outputs>\n"
                 "    <InitialUnknowns>\n{0}    </InitialUnknowns>\n"
                 "  </ModelStructure>\n"
                 "</fmiModelDescription>\n",
                 outputs);
  return text;
}

} // namespace ionskin::live::fmu
