// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/hdf5/foreign_hdf5_file.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/available_memory.hpp"
#include "ionskin/results/hdf5/hdf5_messages.hpp"
#include "ionskin/results/hdf5/hdf5_reader_image.hpp"

#include <csignal>
#include <limits>

namespace ionskin::results {
namespace {

using Transfer = base::ChildProgram::Transfer;

constexpr const char* reader_name = "ionskin-hdf5-reader";
/// Largest size of a text, or of a list of names or texts [bytes].
constexpr std::uint64_t most_text = 256'000'000;
/// Time to start the reader [s], and the least share of a processor that it gets beside other
/// programs [1]. Both make up the time limit of an answer.
constexpr double start_seconds = 20, share_of_processor = 0.25;

/// Size of an array of doubles [bytes]; a floating-point number, so that it cannot overflow.
/// @param from first dimension that counts; 1 for the size of one frame
double bytes_of(const Hdf5File::Shape& shape, std::size_t from = 0) {
  double bytes = sizeof(double);
  for (std::size_t i = from; i < shape.size(); ++i) {
    bytes *= static_cast<double>(shape[i]);
  }
  return bytes;
}

} // namespace

ForeignHdf5File::ForeignHdf5File(const std::filesystem::path& path)
    : path_(path), copy_(path),
      reader_(hdf5_reader_image(), reader_name, {path.string()}, copy_.descriptor()) {
  receive_truth(*ask(Hdf5Question::open, ""), "");
}

void ForeignHdf5File::lost(Transfer how) const {
  const int signal = how == Transfer::late ? SIGXCPU : reader_.end();
  if (signal == SIGXCPU) {
    throw UserError(fmt::format("the HDF5 library does not finish reading {}, and was stopped\n  = "
                                "the file is damaged: write it again",
                                path_.string()));
  }
  throw UserError(fmt::format("the HDF5 library crashes on {}{}\n  = the file is damaged: write it "
                              "again",
                              path_.string(),
                              signal == 0 ? "" : fmt::format(" (signal {})", signal)));
}

void ForeignHdf5File::contradicted(const std::string& object) const {
  throw UserError(read_failure(path_, object.empty() ? "the content" : object));
}

std::optional<std::uint64_t> ForeignHdf5File::ask(Hdf5Question question, const std::string& object,
                                                  const std::string& name,
                                                  std::uint64_t expected_bytes,
                                                  std::uint64_t frame) const {
  const Hdf5Request request{question, static_cast<std::uint32_t>(object.size()),
                            static_cast<std::uint32_t>(name.size()), frame, expected_bytes};
  for (const auto& [bytes, count] : {std::pair<const void*, std::size_t>{&request, sizeof(request)},
                                     {object.data(), object.size()},
                                     {name.data(), name.size()}}) {
    if (reader_.send(bytes, count) != Transfer::done) {
      lost(Transfer::ended);
    }
  }
  const double work = static_cast<double>(copy_.bytes()) + static_cast<double>(expected_bytes);
  seconds_ = start_seconds + reading_seconds(work) / share_of_processor;
  Hdf5Answer answer;
  receive(&answer, sizeof(answer));
  switch (answer.state) {
  case Hdf5State::answered:
    return answer.bytes;
  case Hdf5State::nothing:
    return std::nullopt;
  case Hdf5State::refused:
    throw UserError(receive_text(answer.bytes, object));
  case Hdf5State::out_of_memory:
    throw UserError(fmt::format("{} of {} takes more memory than a damaged file is granted\n  = "
                                "write it in smaller chunks, or write the file again",
                                object.empty() ? "the content" : object, path_.string()));
  }
  contradicted(object);
}

void ForeignHdf5File::receive(void* bytes, std::size_t count) const {
  const Transfer how = reader_.receive(bytes, count, seconds_);
  if (how != Transfer::done) {
    lost(how);
  }
}

std::string ForeignHdf5File::receive_text(std::uint64_t bytes, const std::string& object) const {
  if (bytes > most_text) {
    contradicted(object);
  }
  std::string text(bytes, '\0');
  receive(text.data(), text.size());
  return text;
}

bool ForeignHdf5File::receive_truth(std::uint64_t bytes, const std::string& object) const {
  unsigned char truth = 0;
  if (bytes != sizeof(truth)) {
    contradicted(object);
  }
  receive(&truth, sizeof(truth));
  return truth != 0;
}

void ForeignHdf5File::receive_numbers(std::uint64_t bytes, const std::string& object,
                                      std::vector<double>& values) const {
  if (bytes != values.size() * sizeof(double)) {
    contradicted(object);
  }
  receive(values.data(), bytes);
}

void ForeignHdf5File::require_memory(double bytes, const std::string& object) const {
  const double free = 0.5 * base::available_memory().bytes;
  if (!(bytes <= free)) {
    throw UserError(fmt::format("{}: {} takes {:.3g} GB of memory, and {:.3g} GB are free for it\n"
                                "  = write fewer values, or free memory",
                                path_.string(), object, bytes * 1e-9, free * 1e-9));
  }
}

bool ForeignHdf5File::has(const std::string& object) const {
  return receive_truth(*ask(Hdf5Question::has, object), object);
}

bool ForeignHdf5File::has_numbers(const std::string& object) const {
  return receive_truth(*ask(Hdf5Question::has_numbers, object), object);
}

std::vector<std::string> ForeignHdf5File::members(const std::string& group) const {
  return separate_texts(receive_text(*ask(Hdf5Question::members, group), group));
}

ForeignHdf5File::Shape ForeignHdf5File::shape(const std::string& dataset) const {
  constexpr std::size_t most_dimensions = 32;
  const std::uint64_t bytes = *ask(Hdf5Question::shape, dataset);
  std::vector<std::uint64_t> extents(bytes / sizeof(std::uint64_t));
  if (bytes % sizeof(std::uint64_t) != 0 || extents.size() > most_dimensions) {
    contradicted(dataset);
  }
  receive(extents.data(), bytes);
  return {extents.begin(), extents.end()};
}

void ForeignHdf5File::require_plain() const {
  receive_truth(*ask(Hdf5Question::plain, "/"), "/");
}

std::vector<double> ForeignHdf5File::read(const std::string& dataset) const {
  const double expected = bytes_of(shape(dataset));
  require_memory(expected, dataset);
  const std::uint64_t bytes =
      *ask(Hdf5Question::numbers, dataset, "", static_cast<std::uint64_t>(expected));
  if (static_cast<double>(bytes) != expected) {
    contradicted(dataset);
  }
  std::vector<double> values(bytes / sizeof(double));
  receive_numbers(bytes, dataset, values);
  return values;
}

std::string ForeignHdf5File::read_text(const std::string& dataset) const {
  return receive_text(*ask(Hdf5Question::text, dataset), dataset);
}

std::vector<std::string> ForeignHdf5File::read_texts(const std::string& dataset) const {
  return separate_texts(receive_text(*ask(Hdf5Question::texts, dataset), dataset));
}

void ForeignHdf5File::read_frame(const std::string& dataset, std::size_t frame,
                                 std::vector<double>& values) const {
  const double expected = bytes_of(shape(dataset), 1);
  require_memory(expected, dataset);
  const std::uint64_t bytes =
      *ask(Hdf5Question::frame, dataset, "", static_cast<std::uint64_t>(expected), frame);
  if (static_cast<double>(bytes) != expected) {
    contradicted(dataset);
  }
  values.resize(bytes / sizeof(double));
  receive_numbers(bytes, dataset, values);
}

std::optional<std::string> ForeignHdf5File::text_attribute(const std::string& object,
                                                           const std::string& name) const {
  const auto bytes = ask(Hdf5Question::text_attribute, object, name);
  return bytes ? std::optional(receive_text(*bytes, object)) : std::nullopt;
}

std::optional<double> ForeignHdf5File::number_attribute(const std::string& object,
                                                        const std::string& name) const {
  const auto bytes = ask(Hdf5Question::number_attribute, object, name);
  if (!bytes) {
    return std::nullopt;
  }
  std::vector<double> value(1);
  receive_numbers(*bytes, object, value);
  return value[0];
}

} // namespace ionskin::results
