// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/sweep/sweep_points.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/files/read_text_file.hpp"
#include "ionskin/base/text.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/case/text/toml_limits.hpp"
#include "ionskin/mesh/skin_mesh.hpp"
#include "ionskin/study/run/run_folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

namespace ionskin::study {
namespace {

constexpr std::size_t longest_name = 100;
constexpr std::size_t most_keys = 1000; ///< largest number of keys that vary
/// Largest number of edits of the base case; each reads the case again.
constexpr std::size_t most_edits = 1000;

std::vector<SweepAxis> parse_axes(const std::vector<std::string>& over) {
  if (over.empty() || over.size() > most_keys) {
    throw UserError(
        fmt::format("the sweep varies {} keys\n  = give --over KEY=VALUES 1 to {} times",
                    over.size(), most_keys));
  }
  std::vector<SweepAxis> axes;
  for (const std::string& argument : over) {
    SweepAxis axis = parse_axis(argument);
    for (const SweepAxis& other : axes) {
      if (other.key == axis.key) {
        throw UserError(fmt::format("--over names {} twice\n  = give all its values at once: "
                                    "--over {}=value,value,...",
                                    axis.key, axis.key));
      }
    }
    axes.push_back(std::move(axis));
  }
  return axes;
}

/// Text without characters that may not be in the name of a folder.
/// @param others characters to keep beside letters and digits
std::string name_letters(std::string_view text, std::string_view others) {
  std::string result;
  for (const char letter : text) {
    if (std::isalnum(static_cast<unsigned char>(letter)) ||
        others.find(letter) != std::string_view::npos) {
      result += letter;
    } else if (letter == ',' || letter == '/') {
      result += '_';
    }
  }
  return result;
}

/// Part of a folder's name: the last part of a key with its value.
std::string name_part(const std::string& key, const std::string& value) {
  return fmt::format("_{}={}", name_letters(key.substr(key.rfind('.') + 1), "_-[]"),
                     name_letters(value, "+-."));
}

SweptValue swept_value(const CaseDocument& document, const std::string& key,
                       const std::string& written) {
  if (const auto number = document.number(key)) {
    return {key, written, fmt::format("{:.12g}", number->value),
            units::dimension_info(number->dimension).si_unit};
  }
  const ValueRecord* record = document.find(key);
  return {key, written, record != nullptr ? record->si : written, ""};
}

SweepPoint designed_point(const std::vector<SweepAxis>& axes,
                          const std::vector<std::string>& values, std::size_t number) {
  SweepPoint point;
  point.name = fmt::format("{:04}", number);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    point.edits.push_back(axes[i].key + "=" + values[i]);
    point.values.push_back({axes[i].key, values[i], "", ""});
    point.name += name_part(axes[i].key, values[i]);
  }
  point.name = point.name.substr(0, longest_name);
  return point;
}

void read_point(const SweepRequest& request, std::size_t number, SweepPoint& point) {
  try {
    CaseDocument document = read_point_case(request, point.edits);
    if (document.input.strain.kind == StrainSourceKind::contact) {
      if (!document.input.slider.sharp()) {
        mesh::require_load(document.input);
      }
      mesh::SkinMesh{document.input};
      point.mechanics_hash = mechanics_hash(document.input);
    }
    point.input_hash = input_hash(document.input);
    for (SweptValue& value : point.values) {
      value = swept_value(document, value.key, value.written);
    }
    point.input = std::move(document.input);
  } catch (const UserError& error) {
    throw UserError(fmt::format("point {} of the sweep ({}): {}", number,
                                base::shown(fmt::format("{}", fmt::join(point.edits, ", "))),
                                error.what()));
  }
}

/// Makes a key a text at all points if its values have different units, such as an indentation here
/// and a force there.
void unify_units(std::vector<SweepPoint>& points) {
  for (std::size_t k = 0; k < points.front().values.size(); ++k) {
    const std::string unit = points.front().values[k].unit;
    const bool same = std::all_of(points.begin(), points.end(), [&](const SweepPoint& point) {
      return point.values[k].unit == unit;
    });
    for (SweepPoint& point : points) {
      SweptValue& value = point.values[k];
      value = same ? value : SweptValue{value.key, value.written, value.written, ""};
    }
  }
}

/// Axes and sampling of a sweep as comments for the end of the base case, so that its text tells
/// one sweep from another.
std::string design_comment(const SweepRequest& request) {
  std::string text = "\n# Swept:\n";
  for (const std::string& argument : request.over) {
    text += fmt::format("#   --over {}\n", base::shown(argument, argument.size()));
  }
  if (request.samples > 0) {
    text += fmt::format("#   --samples {} --sampling {} --seed {}\n", request.samples,
                        request.sampling == Sampling::sobol ? "sobol" : "latin", request.seed);
  }
  return text;
}

} // namespace

CaseDocument read_point_case(const SweepRequest& request, const std::vector<std::string>& edits) {
  std::vector<std::string> all = request.set_edits;
  all.insert(all.end(), edits.begin(), edits.end());
  return request.case_text ? read_case_text(*request.case_text, request.case_path, all)
                           : read_case_document(request.case_path, all);
}

Case base_case(const SweepRequest& request, Case first) {
  // The swept keys may be missing in the case file, so the first point gives them their values.
  first.text += design_comment(request);
  return first;
}

std::vector<SweepPoint> designed_points(const SweepRequest& request) {
  if (request.set_edits.size() > most_edits) {
    throw UserError(fmt::format("{} edits of the case are more than {}\n  = write them into the "
                                "case file",
                                request.set_edits.size(), most_edits));
  }
  const std::vector<SweepAxis> axes = parse_axes(request.over);
  const auto design = request.samples > 0
                          ? sampled_design(axes, request.sampling, request.samples, request.seed)
                          : grid_design(axes);
  std::vector<SweepPoint> points;
  for (const auto& values : design) {
    points.push_back(designed_point(axes, values, points.size() + 1));
  }
  return points;
}

SweepPlan plan_sweep(const SweepRequest& request) {
  SweepPlan plan;
  plan.points = designed_points(request);
  plan.request = request;
  if (!request.case_text) {
    plan.request.case_text = base::read_text_file(request.case_path, "case", toml_limits::bytes);
  }
  for (std::size_t i = 0; i < plan.points.size(); ++i) {
    read_point(plan.request, i + 1, plan.points[i]);
  }
  unify_units(plan.points);
  plan.base = base_case(plan.request, plan.points.front().input);
  return plan;
}

} // namespace ionskin::study
