// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// Protocol between ForeignHdf5File and the process that reads for it: a question, its two texts,
// and an answer with its content. Numbers stand as in memory, both ends being one machine.

namespace ionskin::results {

enum class Hdf5Question : std::uint32_t {
  open,  ///< asked first
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

struct Hdf5Request {
  Hdf5Question question = Hdf5Question::open;
  std::uint32_t object_bytes = 0, name_bytes = 0; ///< of the texts that follow
  std::uint64_t frame = 0;
  std::uint64_t expected_bytes = 0; ///< of the answer; the time that it may take grows with it
};

enum class Hdf5State : std::uint32_t {
  answered,
  nothing,      ///< such as an attribute that is not there
  refused,      ///< a UserError, whose message follows
  out_of_memory ///< of what the process may take
};

struct Hdf5Answer {
  Hdf5State state = Hdf5State::answered;
  std::uint64_t bytes = 0; ///< bytes that follow
};

/// A reader of so many bytes may keep a processor busy this long [s]: many times what a slow
/// machine needs to decompress them, and some to begin with. What takes longer goes round in a
/// circle.
inline double reading_seconds(double bytes) {
  return 1.0 + bytes / 10e6;
}

/// Texts in one: each behind its length.
std::string joined_texts(const std::vector<std::string>& texts);
/// Throws UserError when the lengths do not add up.
std::vector<std::string> separate_texts(std::string_view joined);

} // namespace ionskin::results
