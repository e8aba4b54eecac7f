// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// Protocol between `ForeignHdf5File` and the separate process that reads the file for it. The
// client sends an `Hdf5Request`, the name of an object and the name of an attribute; the process
// replies with an `Hdf5Answer` and its content. Numbers are sent as they are in memory, since both
// processes run on one machine.

namespace ionskin::results {

/// Question to the reading process: the member function of `Hdf5File` to call.
enum class Hdf5Question : std::uint32_t {
  open,  ///< open the file; always the first question
  plain, ///< check that every object can be opened
  has,
  has_numbers,
  members,
  shape,
  numbers,
  text,
  texts,
  frame,
  text_attribute,
  number_attribute
};

/// Header of a question, followed by the names of the object and of the attribute.
struct Hdf5Request {
  Hdf5Question question = Hdf5Question::open;
  /// Lengths of the names of the object and of the attribute [bytes].
  std::uint32_t object_bytes = 0, name_bytes = 0;
  std::uint64_t frame = 0;          ///< index of the frame, for `Hdf5Question::frame`
  std::uint64_t expected_bytes = 0; ///< size of the answer, which raises the time limit [bytes]
};

/// Outcome of a question.
enum class Hdf5State : std::uint32_t {
  answered,     ///< the content follows
  nothing,      ///< the attribute asked for does not exist
  refused,      ///< the process caught a UserError; its message follows
  out_of_memory ///< the process reached its memory limit
};

/// Header of an answer, followed by its content.
struct Hdf5Answer {
  Hdf5State state = Hdf5State::answered;
  std::uint64_t bytes = 0; ///< length of the content [bytes]
};

/// Limit of the processor time for reading a number of bytes [s]: one second, and many times the
/// time that a slow machine needs to decompress them. A reader that takes longer is taken to be in
/// an endless loop.
inline double reading_seconds(double bytes) {
  return 1.0 + bytes / 10e6;
}

/// Joins texts into one byte string: each text is preceded by its length as 8 bytes.
std::string joined_texts(const std::vector<std::string>& texts);
/// Splits a byte string that `joined_texts` made into its texts. Throws UserError when the lengths
/// do not add up.
std::vector<std::string> separate_texts(std::string_view joined);

} // namespace ionskin::results
