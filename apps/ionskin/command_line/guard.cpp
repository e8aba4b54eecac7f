// SPDX-License-Identifier: Apache-2.0
#include "command_line/guard.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/text.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <system_error>

namespace ionskin::apps {
namespace {

/// Prints a message on stderr and returns the exit code, which tells the failure even where the
/// message is lost.
int fail(ExitCode code, const std::string& message) {
  std::fputs((base::printable(message) + "\n").c_str(), stderr);
  return static_cast<int>(code);
}

int fail_at_output() {
  const std::string reason = std::strerror(errno);
  return fail(ExitCode::user_error,
              fmt::format("error: the standard output cannot be written: {}; what was computed is "
                          "kept in its folder",
                          reason));
}

/// Flushes the standard output and returns the exit code, that of a failed output where the output
/// could not be written.
int flushed(int exit_code) {
  return exit_code == 0 && (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) ? fail_at_output()
                                                                                  : exit_code;
}

} // namespace

int guarded(const std::function<int()>& body) {
  // A limit on the size of files is an error of the write, as a full disk is.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return flushed(body());
  } catch (const UserError& error) {
    return fail(ExitCode::user_error, fmt::format("error: {}", error.what()));
  } catch (const SolverError& error) {
    return fail(ExitCode::solver_gave_up,
                fmt::format("error: {}\nremedy: {}", error.what(), error.remedy()));
  } catch (const Interrupted&) {
    return fail(ExitCode::interrupted,
                "interrupted: what was finished is kept; --resume continues");
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::solver_gave_up,
                "error: out of memory\nremedy: use fewer --threads or a coarser numerics.preset");
  } catch (const std::system_error& error) {
    if (std::ferror(stdout) != 0) {
      return fail_at_output();
    }
    return fail(ExitCode::user_error,
                fmt::format("error: {}\n  = check the free space and the permissions of the "
                            "folders",
                            error.what()));
  } catch (const std::exception& error) {
    return fail(ExitCode::internal_error,
                fmt::format("internal error: {}\nThis is a mistake of ionskin, not of your case: "
                            "please report it with the case file.",
                            error.what()));
  }
}

void require_vector_instructions() {
#if defined(__x86_64__) && defined(IONSKIN_VECTOR_LEVEL_V3)
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) {
    throw UserError(
        "this binary was built for processors with AVX2 and FMA (x86-64-v3), which this "
        "machine lacks; configure with -DIONSKIN_VECTOR_LEVEL=x86-64 and build again");
  }
#endif
#if defined(__x86_64__) && defined(IONSKIN_VECTOR_LEVEL_V4)
  if (!__builtin_cpu_supports("avx512f") || !__builtin_cpu_supports("avx512vl")) {
    throw UserError(
        "this binary was built for processors with AVX-512 (x86-64-v4), which this machine "
        "lacks; configure with -DIONSKIN_VECTOR_LEVEL=x86-64-v3 and build again");
  }
#endif
}

} // namespace ionskin::apps
