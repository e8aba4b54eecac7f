// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/training/training_record.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/base/files/read_text_file.hpp"
#include "ionskin/live/data/skin_archive.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

namespace ionskin::live {
namespace {

constexpr std::string_view magic = "ionskin live training, format 2\n";
constexpr std::size_t largest_record = 512u << 20u; // [bytes]

/// Visits the entries of the validation, in their order, for reading and writing.
/// @param archive `Writer` or `Reader`
template <class Archive, class Footprint, class Errors>
void visit(Archive& archive, Footprint& footprint, std::uint64_t& touches, Errors& errors) {
  archive.entry("half_size", footprint.half_size);
  archive.entry("rim", footprint.rim);
  archive.entry("resolved", footprint.resolved);
  archive.entry("touches", touches);
  archive.list("errors", errors);
  for (auto& error : errors) {
    archive.entry("error.name", error.name);
    archive.entry("error.event", error.event);
    archive.entry("error.largest", error.largest);
    archive.entry("error.rms", error.rms);
    archive.entry("error.worst", error.worst);
  }
}

} // namespace

void write_record(const std::filesystem::path& path, const std::string& identity,
                  const TrainingRecord& record) {
  Writer writer(magic);
  writer.entry("identity", identity);
  writer.entry("model", skin_bytes(record.data));
  std::uint64_t touches = record.compared.count;
  visit(writer, record.footprint, touches, record.compared.errors);
  const std::string bytes = sealed(std::move(writer.bytes));
  base::PendingFile file(path);
  file.write(std::as_bytes(std::span(bytes)));
  file.commit();
}

TrainingRecord read_record(const std::filesystem::path& path, const std::string& identity) {
  const std::string bytes = base::read_text_file(path.string(), "training record", largest_record);
  TrainingRecord record;
  std::string own_identity;
  try {
    const std::string_view content = opened(bytes, path.string());
    if (!content.starts_with(magic)) {
      refuse(path.string() + ": is not the record of a training");
    }
    Reader reader(content.substr(magic.size()), path.string());
    std::string model;
    reader.entry("identity", own_identity);
    if (own_identity == identity) {
      reader.entry("model", model);
      record.data = skin_of_bytes(model, path.string());
      std::uint64_t touches = 0;
      visit(reader, record.footprint, touches, record.compared.errors);
      record.compared.count = touches;
    }
  } catch (const UserError&) {
    throw UserError(fmt::format("--resume: {} is damaged\n"
                                "  = train anew with --overwrite in place of --resume",
                                path.string()));
  }
  if (own_identity != identity) {
    throw UserError(
        fmt::format("--resume: {} is of a training with another case or other options, "
                    "or by another build of ionskin\n"
                    "  = repeat the command that began it, with --resume, or train anew "
                    "with --overwrite",
                    path.string()));
  }
  return record;
}

} // namespace ionskin::live
