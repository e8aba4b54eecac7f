// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/unit_response.hpp"

#include "ionskin/base/byte_record.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace ionskin::mechanics {
namespace {

using linear_algebra::DenseMatrix;
using linear_algebra::FixedPointMatrix;

struct Sizes {
  std::int32_t cells = 0, core_rows = 0, membrane_rows = 0;
  std::array<std::int32_t, 3> held{}; ///< whether the response in each direction follows
};

template <class T> std::span<const std::byte> bytes_of(const std::vector<T>& values) {
  return std::as_bytes(std::span(values));
}

} // namespace

bool responses_fit(int core_rows, int membrane_rows, int components, std::size_t positions) {
  const double rows = static_cast<double>(core_rows) + membrane_rows;
  return static_cast<double>(std::max(least_positions, positions)) * rows * components *
             sizeof(std::int32_t) <
         static_cast<double>(base::default_cache_limit);
}

std::shared_ptr<const StoredPosition> read_position(base::DiskCache& cache, const base::Digest& key,
                                                    int core_rows, int membrane_rows, int cells) {
  const auto content = cache.read(key);
  if (!content) {
    return nullptr;
  }
  base::ByteReader reader(*content);
  Sizes sizes;
  auto stored = std::make_shared<StoredPosition>();
  StoredPosition& result = *stored;
  result.compliance = DenseMatrix(3 * cells, 3 * cells);
  if (!reader.take(sizes) || sizes.cells != cells || sizes.core_rows != core_rows ||
      sizes.membrane_rows != membrane_rows || !reader.take_known(result.compliance.values)) {
    return nullptr;
  }
  for (std::size_t d = 0; d < result.response.size(); ++d) {
    if (sizes.held[d] == 0) {
      continue;
    }
    DirectionResponse& response = result.response[d].emplace(
        DirectionResponse{FixedPointMatrix(core_rows, cells),
                          FixedPointMatrix(membrane_rows, cells), DenseMatrix(3, cells)});
    if (!reader.take_known(response.base_reaction.values) ||
        !reader.take_known(response.core.unit) || !reader.take_known(response.core.values) ||
        !reader.take_known(response.membrane.unit) ||
        !reader.take_known(response.membrane.values)) {
      return nullptr;
    }
  }
  return reader.at_end() ? stored : nullptr;
}

void write_position(base::DiskCache& cache, const base::Digest& key, const StoredPosition& position,
                    std::size_t positions) {
  const auto& [compliance, response] = position;
  Sizes sizes{compliance.columns / 3, 0, 0, {}};
  std::vector<std::span<const std::byte>> parts{std::as_bytes(std::span(&sizes, 1)),
                                                bytes_of(compliance.values)};
  std::size_t bytes = 0;
  for (std::size_t d = 0; d < response.size(); ++d) {
    if (!response[d]) {
      continue;
    }
    const auto& [core, membrane, base_reaction] = *response[d];
    sizes.core_rows = core.rows;
    sizes.membrane_rows = membrane.rows;
    sizes.held[d] = 1;
    for (const auto part :
         {bytes_of(base_reaction.values), bytes_of(core.unit), bytes_of(core.values),
          bytes_of(membrane.unit), bytes_of(membrane.values)}) {
      parts.push_back(part);
      bytes += part.size();
    }
  }
  const auto needed = static_cast<double>(std::max(least_positions, positions) * bytes);
  if (needed < static_cast<double>(cache.most_bytes())) {
    cache.write(key, parts);
  }
}

} // namespace ionskin::mechanics
