// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ionskin::linear_algebra {

// The kernels of BLAS in use, on column-major arrays with leading dimensions. They go
// through the Fortran interface: programs that link GSL may find its unoptimised CBLAS under the
// names of OpenBLAS's.

/// So many threads for each kernel of BLAS within a scope, and one again after it: as a rule
/// positions, not kernels, run at the same time. CHOLMOD starts no threads of its own either way.
/// The number holds for all threads of the process, which only costs time where they overlap.
class KernelThreads {
public:
  explicit KernelThreads(int count);
  ~KernelThreads();
  KernelThreads(const KernelThreads&) = delete;
  KernelThreads& operator=(const KernelThreads&) = delete;
};

/// The library in use, its version, and its kernels, which follow the processor: others round
/// otherwise.
std::string kernel_name();

/// Kernels that suit the processor, by OpenBLAS's name for the environment variable
/// OPENBLAS_CORETYPE of a program that is started; empty where it chose well. An OpenBLAS older
/// than the processor takes its oldest kernels, with which a factorisation takes three times as
/// long.
std::string overlooked_kernels();

/// C := alpha A B + beta C, or alpha A^T B + beta C; C has shape [m, n], the sum runs over k.
void product(bool transpose_a, int m, int n, int k, double alpha, const double* a, int lead_a,
             const double* b, int lead_b, double beta, double* c, int lead_c);

/// Lower triangle of C := alpha A A^T + beta C, or alpha A^T A + beta C; C has shape [n, n], the
/// sum runs over k.
void symmetric_product(bool transpose_first, int n, int k, double alpha, const double* a,
                       int lead_a, double beta, double* c, int lead_c);

/// B := L^-1 B, or L^-T B, with the lower triangle L [m, m]; B has shape [m, n].
void solve_left(bool transpose, int m, int n, const double* l, int lead_l, double* b, int lead_b);

/// B := B L^-1 with the lower triangle L [n, n]; B has shape [m, n].
void solve_right(int m, int n, const double* l, int lead_l, double* b, int lead_b);

/// Lower triangle of A := L with A = L L^T; A has shape [n, n]. False when it is not positive
/// definite.
bool factorise(int n, double* a, int lead_a);

} // namespace ionskin::linear_algebra
