// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/plane/grid_fourier.hpp"

#include <unsupported/Eigen/FFT>

namespace ionskin::finite_layers {
namespace {

/// Smallest multiple of 4, not below `least`, with no prime factors other than 2, 3 and 5.
/// Transforms of such sizes are fast.
Eigen::Index fast_size(Eigen::Index least) {
  for (Eigen::Index size = (least + 3) / 4 * 4;; size += 4) {
    Eigen::Index rest = size;
    for (const Eigen::Index factor : {2, 3, 5}) {
      while (rest % factor == 0) {
        rest /= factor;
      }
    }
    if (rest == 1) {
      return size;
    }
  }
}

/// Transformer of this thread, which stores its factors for each size that it has transformed.
Eigen::FFT<double>& transformer() {
  thread_local Eigen::FFT<double> fft(Eigen::FFT<double>::impl_type(),
                                      Eigen::FFT<double>::HalfSpectrum);
  return fft;
}

} // namespace

GridFourier::GridFourier(Eigen::Index columns, Eigen::Index rows)
    : columns_(fast_size(2 * columns)), rows_(fast_size(2 * rows)) {}

GridFourier::Spectrum GridFourier::forward(const Eigen::MatrixXd& field) const {
  Eigen::FFT<double>& fft = transformer();
  const Eigen::Index waves = columns_ / 2 + 1;
  Eigen::ArrayXXcd along_x(waves, field.cols());
  Eigen::VectorXd line = Eigen::VectorXd::Zero(columns_);
  for (Eigen::Index j = 0; j < field.cols(); ++j) {
    line.head(field.rows()) = field.col(j);
    fft.fwd(along_x.col(j).data(), line.data(), columns_);
  }
  Spectrum result(rows_, waves);
  Eigen::VectorXcd of_wave = Eigen::VectorXcd::Zero(rows_);
  for (Eigen::Index k = 0; k < waves; ++k) {
    of_wave.head(field.cols()) = along_x.row(k).transpose();
    fft.fwd(result.col(k).data(), of_wave.data(), rows_);
  }
  return result;
}

Eigen::MatrixXd GridFourier::back(const Spectrum& spectrum, Eigen::Index columns,
                                  Eigen::Index rows) const {
  Eigen::FFT<double>& fft = transformer();
  const Eigen::Index waves = columns_ / 2 + 1;
  Eigen::ArrayXXcd along_x(waves, rows);
  Eigen::VectorXcd of_wave(rows_);
  for (Eigen::Index k = 0; k < waves; ++k) {
    fft.inv(of_wave.data(), spectrum.col(k).data(), rows_);
    along_x.row(k) = of_wave.head(rows).transpose().array();
  }
  Eigen::MatrixXd result(columns, rows);
  Eigen::VectorXd line(columns_);
  for (Eigen::Index j = 0; j < rows; ++j) {
    fft.inv(line.data(), along_x.col(j).data(), columns_);
    result.col(j) = line.head(columns);
  }
  return result;
}

} // namespace ionskin::finite_layers
