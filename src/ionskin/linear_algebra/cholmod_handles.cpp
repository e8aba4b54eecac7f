// SPDX-License-Identifier: Apache-2.0
#include "ionskin/linear_algebra/cholmod_handles.hpp"

#include "ionskin/base/error.hpp"

#include <new>
#include <string>

namespace ionskin::linear_algebra {

CholmodWorkspace::CholmodWorkspace() {
  cholmod_start(&common_);
  common_.supernodal = CHOLMOD_SUPERNODAL;
  common_.final_ll = 1;
  common_.print = 0;
  common_.error_handler = nullptr;
}

CholmodWorkspace::~CholmodWorkspace() {
  cholmod_finish(&common_);
}

void CholmodWorkspace::check(const char* operation) const {
  if (common_.status == CHOLMOD_OUT_OF_MEMORY) {
    throw std::bad_alloc();
  }
  if (common_.status < CHOLMOD_OK) {
    throw InternalError(std::string("CHOLMOD failed in ") + operation + " with status " +
                        std::to_string(common_.status));
  }
}

cholmod_sparse view(const SymmetricPattern& pattern, const double* values) {
  cholmod_sparse result{};
  result.nrow = result.ncol = static_cast<std::size_t>(pattern.size);
  result.nzmax = pattern.row.size();
  // CHOLMOD takes pointers to non-const but does not write through them in the calls used here.
  result.p = const_cast<int*>(pattern.column_start.data());
  result.i = const_cast<int*>(pattern.row.data());
  result.x = const_cast<double*>(values);
  result.stype = -1;
  result.itype = CHOLMOD_INT;
  result.xtype = values ? CHOLMOD_REAL : CHOLMOD_PATTERN;
  result.dtype = CHOLMOD_DOUBLE;
  result.sorted = 1;
  result.packed = 1;
  return result;
}

cholmod_dense view(DenseMatrix& matrix) {
  cholmod_dense result{};
  result.nrow = static_cast<std::size_t>(matrix.rows);
  result.ncol = static_cast<std::size_t>(matrix.columns);
  result.nzmax = matrix.values.size();
  result.d = result.nrow;
  result.x = matrix.values.data();
  result.xtype = CHOLMOD_REAL;
  result.dtype = CHOLMOD_DOUBLE;
  return result;
}

} // namespace ionskin::linear_algebra
