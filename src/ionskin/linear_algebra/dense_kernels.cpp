// SPDX-License-Identifier: Apache-2.0
#include "ionskin/linear_algebra/dense_kernels.hpp"

#include <cblas.h>
#include <f77blas.h>
#include <omp.h>

#include <algorithm>

namespace ionskin::linear_algebra {
namespace {

// The Fortran interface takes pointers to non-const but does not write through these.
double* input(const double* values) {
  return const_cast<double*>(values);
}

/// BLAS refuses the leading dimension 0 of an empty matrix.
int lead(int given) {
  return std::max(1, given);
}

} // namespace

KernelThreads::KernelThreads(int count) {
  openblas_set_num_threads(count);
  // CHOLMOD would take four OpenMP threads for every loop of a factorisation.
  omp_set_max_active_levels(0);
}

KernelThreads::~KernelThreads() {
  openblas_set_num_threads(1);
}

std::string kernel_name() {
  // OpenBLAS puts the text together in a buffer that all threads share: it is asked once.
  static const std::string name = openblas_get_config();
  return name;
}

std::string overlooked_kernels() {
#if defined(__x86_64__)
  const bool oldest = kernel_name().find(" Prescott ") != std::string::npos;
  if (oldest && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512bw") &&
      __builtin_cpu_supports("avx512vl")) {
    return "SkylakeX";
  }
  if (oldest && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    return "Haswell";
  }
#endif
  return {};
}

void product(bool transpose_a, int m, int n, int k, double alpha, const double* a, int lead_a,
             const double* b, int lead_b, double beta, double* c, int lead_c) {
  lead_a = lead(lead_a), lead_b = lead(lead_b), lead_c = lead(lead_c);
  char form_a = transpose_a ? 'T' : 'N', form_b = 'N';
  dgemm_(&form_a, &form_b, &m, &n, &k, &alpha, input(a), &lead_a, input(b), &lead_b, &beta, c,
         &lead_c);
}

void symmetric_product(bool transpose_first, int n, int k, double alpha, const double* a,
                       int lead_a, double beta, double* c, int lead_c) {
  lead_a = lead(lead_a), lead_c = lead(lead_c);
  char triangle = 'L', form = transpose_first ? 'T' : 'N';
  dsyrk_(&triangle, &form, &n, &k, &alpha, input(a), &lead_a, &beta, c, &lead_c);
}

void solve_left(bool transpose, int m, int n, const double* l, int lead_l, double* b, int lead_b) {
  lead_l = lead(lead_l), lead_b = lead(lead_b);
  char side = 'L', triangle = 'L', form = transpose ? 'T' : 'N', diagonal = 'N';
  double alpha = 1;
  dtrsm_(&side, &triangle, &form, &diagonal, &m, &n, &alpha, input(l), &lead_l, b, &lead_b);
}

void solve_right(int m, int n, const double* l, int lead_l, double* b, int lead_b) {
  lead_l = lead(lead_l), lead_b = lead(lead_b);
  char side = 'R', triangle = 'L', form = 'N', diagonal = 'N';
  double alpha = 1;
  dtrsm_(&side, &triangle, &form, &diagonal, &m, &n, &alpha, input(l), &lead_l, b, &lead_b);
}

bool factorise(int n, double* a, int lead_a) {
  lead_a = lead(lead_a);
  char triangle = 'L';
  int info = 0;
  dpotrf_(&triangle, &n, a, &lead_a, &info);
  return info == 0;
}

} // namespace ionskin::linear_algebra
