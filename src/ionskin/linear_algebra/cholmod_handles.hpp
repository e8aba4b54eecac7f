// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/linear_algebra/sparse_matrix.hpp"

#include <cholmod.h>

#include <memory>

namespace ionskin::linear_algebra {

/// One CHOLMOD workspace (Chen, Davis, Hager and Rajamanickam 2008, doi 10.1145/1391989.1391995);
/// each thread needs its own.
class CholmodWorkspace {
public:
  CholmodWorkspace();
  ~CholmodWorkspace();
  CholmodWorkspace(const CholmodWorkspace&) = delete;
  CholmodWorkspace& operator=(const CholmodWorkspace&) = delete;
  cholmod_common* operator*() { return &common_; }
  cholmod_common* operator->() { return &common_; }

  /// Throws std::bad_alloc when memory ran out, InternalError on other failures of the last call.
  void check(const char* operation) const;

private:
  cholmod_common common_;
};

/// A CHOLMOD view of a pattern, with values when `values` is not null. Copies nothing.
cholmod_sparse view(const SymmetricPattern& pattern, const double* values);
/// A CHOLMOD view of a dense matrix. Copies nothing.
cholmod_dense view(DenseMatrix& matrix);

} // namespace ionskin::linear_algebra
