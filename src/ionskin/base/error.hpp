// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace ionskin {

/// Exit codes that scripts may rely on.
enum class ExitCode {
  success = 0,
  internal_error = 1,
  user_error = 2,
  solver_gave_up = 3,
  unfinished = 4, ///< points of a planned sweep are still to be solved, or no report was made
  interrupted = 130
};

/// The user's case, file or command line is wrong: nothing was computed. Exit code 2.
/// The message says what is wrong, where, the actual value and the remedy.
class UserError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// A solver gave up on a valid case; what was finished is kept. Exit code 3.
class SolverError : public std::runtime_error {
public:
  /// @param what_happened the quantity that failed, with its value
  /// @param remedy what the user can change
  SolverError(const std::string& what_happened, std::string remedy)
      : std::runtime_error(what_happened), remedy_(std::move(remedy)) {}
  const std::string& remedy() const { return remedy_; }

private:
  std::string remedy_;
};

/// A mistake of the program. Exit code 1.
class InternalError : public std::logic_error {
public:
  using std::logic_error::logic_error;
};

/// The user asked to stop (SIGINT, SIGTERM). Exit code 130.
class Interrupted : public std::runtime_error {
public:
  Interrupted() : std::runtime_error("interrupted") {}
};

} // namespace ionskin
