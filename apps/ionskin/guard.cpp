// SPDX-License-Identifier: Apache-2.0
#include "guard.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/text.hpp"

#include <fmt/core.h>

#include <cstdio>
#include <new>

namespace ionskin::apps {
namespace {

int fail(ExitCode code, const std::string& message) {
  fmt::print(stderr, "{}\n", base::printable(message));
  return static_cast<int>(code);
}

} // namespace

int guarded(const std::function<int()>& body) {
  try {
    return body();
  } catch (const UserError& error) {
    return fail(ExitCode::user_error, fmt::format("error: {}", error.what()));
  } catch (const SolverError& error) {
    return fail(ExitCode::solver_gave_up,
                fmt::format("error: {}\nremedy: {}", error.what(), error.remedy()));
  } catch (const Interrupted&) {
    return fail(ExitCode::interrupted, "interrupted: what was finished is kept; --resume goes on");
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::solver_gave_up,
                "error: out of memory\nremedy: use fewer --threads or a coarser numerics.preset");
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
