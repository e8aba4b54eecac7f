// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/sweep/point_failure.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/text.hpp"

#include <new>

namespace ionskin::study {

std::optional<std::string> failure_of(const std::function<void()>& solve) {
  try {
    solve();
  } catch (const Interrupted&) {
    throw;
  } catch (const SolverError& error) {
    return base::printable(std::string(error.what()) + "; remedy: " + error.remedy());
  } catch (const std::bad_alloc&) {
    return "out of memory; remedy: use fewer --threads or a coarser numerics.preset";
  } catch (const std::exception& error) {
    return base::printable(error.what());
  }
  return std::nullopt;
}

} // namespace ionskin::study
