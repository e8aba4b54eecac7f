// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace ionskin {

/// Exit codes of the program, which scripts may rely on.
enum class ExitCode {
  success = 0,
  internal_error = 1,
  user_error = 2,
  solver_gave_up = 3,
  unfinished = 4, ///< points of a planned sweep are still to be solved, or no report was made
  interrupted = 130
};

/// Exception for a mistake in the user's case, file or command line, thrown before anything is
/// computed. Exit code 2. The message says what is wrong, where, the actual value and the remedy.
class UserError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// Exception for a solver that gave up on a valid case. Results that were finished before are kept.
/// Exit code 3.
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

/// Exception for a defect of the program itself. Exit code 1.
class InternalError : public std::logic_error {
public:
  using std::logic_error::logic_error;
};

/// Exception that unwinds the work after the user asked to stop (SIGINT, SIGTERM). Exit code 130.
class Interrupted : public std::runtime_error {
public:
  Interrupted() : std::runtime_error("interrupted") {}
};

} // namespace ionskin
