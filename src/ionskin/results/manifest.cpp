// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/manifest.hpp"

#include "ionskin/base/digest.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/base/files/read_json.hpp"
#include "ionskin/base/system/own_build.hpp"
#include "ionskin/results/build_info.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <optional>
#include <utility>

namespace ionskin::results {
namespace {

using base::Json;

/// Key of the digest of all other content of the file.
constexpr const char* digest_key = "digest";

/// Formats JSON as text; bytes that are not UTF-8, as in a command line, are replaced.
std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string digest_of(const Json& json) {
  return base::DigestBuilder().add(std::string_view(text_of(json))).finish().hex();
}

Json program_json() {
  Json program;
  program["name"] = "ionskin";
  program["version"] = build_info::version;
  program["commit"] = build_info::commit;
  program["compiler"] = build_info::compiler;
  program["build_type"] = build_info::build_type;
  return program;
}

Json stages_json(const std::map<std::string, StageRecord>& stages) {
  Json json = Json::object();
  for (const auto& [name, stage] : stages) {
    json[name] = {{"state", stage.state},
                  {"wall_time_s", stage.wall_time},
                  {"peak_memory_bytes", stage.peak_memory}};
    if (!stage.source.empty()) {
      json[name]["source"] = stage.source;
    }
  }
  return json;
}

bool is_ours(const Json& json) {
  return json.is_object() && json.contains("program") && json["program"].is_object() &&
         json["program"].contains("name") && json["program"]["name"] == "ionskin";
}

/// Reads a manifest of ionskin as JSON. Nothing (`nullopt`) when the file is missing, cannot be
/// read or is no manifest of ionskin.
std::optional<Json> parse(const std::filesystem::path& path) {
  try {
    auto json = base::read_json(path, "manifest");
    return json && is_ours(*json) ? std::move(json) : std::nullopt;
  } catch (const UserError&) {
    return std::nullopt;
  }
}

std::map<std::string, StageRecord> read_stages(const Json& json) {
  std::map<std::string, StageRecord> stages;
  for (const auto& [name, stage] : json.items()) {
    stages[name] = {stage.at("state").get<std::string>(), stage.at("wall_time_s").get<double>(),
                    stage.at("peak_memory_bytes").get<double>(), stage.value("source", "")};
  }
  return stages;
}

} // namespace

Manifest new_manifest(std::string command, int threads, std::string input_hash) {
  Manifest manifest;
  manifest.command = std::move(command);
  manifest.threads = threads;
  manifest.input_hash = std::move(input_hash);
  const auto now =
      std::chrono::time_point_cast<std::chrono::seconds>(std::chrono::system_clock::now());
  const auto& build = base::own_build();
  manifest.build = build ? build->hex() : "";
  manifest.started = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
  return manifest;
}

std::string manifest_text(const Manifest& manifest) {
  Json json;
  json["program"] = program_json();
  json["state"] = manifest.state;
  if (!manifest.reason.empty()) {
    json["reason"] = manifest.reason;
  }
  json["started"] = manifest.started;
  json["command"] = manifest.command;
  json["threads"] = manifest.threads;
  json["input_hash"] = manifest.input_hash;
  json["stages"] = stages_json(manifest.stages);
  json["counters"] = manifest.counters;
  json["build"] = manifest.build;
  json["files"] = manifest.files;
  json[digest_key] = digest_of(json);
  return text_of(json);
}

void write_manifest(const std::filesystem::path& path, const Manifest& manifest) {
  base::write_text_file(path, manifest_text(manifest));
}

Manifest read_manifest(const std::filesystem::path& path) {
  const UserError damaged(fmt::format(
      "{} is not a manifest of ionskin or is damaged\n  = start the run anew in another "
      "folder",
      path.string()));
  std::optional<Json> json = parse(path);
  if (!json) {
    throw damaged;
  }
  try {
    const auto digest = json->at(digest_key).get<std::string>();
    json->erase(digest_key);
    if (digest != digest_of(*json)) {
      throw damaged;
    }
    Manifest manifest;
    manifest.state = json->at("state").get<std::string>();
    manifest.reason = json->value("reason", "");
    manifest.started = json->at("started").get<std::string>();
    manifest.command = json->at("command").get<std::string>();
    if (!json->at("threads").is_number_integer()) {
      throw damaged; // the JSON library would convert a number that is not an integer
    }
    manifest.threads = json->at("threads").get<int>();
    manifest.input_hash = json->at("input_hash").get<std::string>();
    manifest.stages = read_stages(json->at("stages"));
    manifest.counters = json->at("counters").get<std::map<std::string, double>>();
    manifest.build = json->at("build").get<std::string>();
    manifest.files = json->at("files").get<std::map<std::string, std::string>>();
    return manifest;
  } catch (const nlohmann::json::exception&) {
    throw damaged;
  }
}

bool is_ionskin_manifest(const std::filesystem::path& path) {
  return parse(path).has_value();
}

std::string content_hash(std::string_view content) {
  return base::DigestBuilder().add(content).finish().hex();
}

} // namespace ionskin::results
