// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/fit/fit_model.hpp"
#include "ionskin/study/fit/fit_statistics.hpp"

#include <ceres/cost_function.h>

#include <exception>
#include <optional>
#include <vector>

namespace ionskin::study {

/// Residuals and derivatives as Ceres asks for them: scaled, in coordinates. The coordinate of a
/// key of the case is the logarithm of its magnitude; that of one of the data its distance from the
/// start in parts of a scale.
class Misfit : public ceres::CostFunction {
public:
  /// @param start one value per parameter [SI]; model and data must outlive the misfit
  Misfit(FitModel& model, const FitData& data, const std::vector<double>& start);

  bool Evaluate(const double* const* parameters, double* residuals,
                double** jacobians) const override;

  std::vector<double> coordinates(const std::vector<double>& values) const;
  std::vector<double> values(const std::vector<double>& coordinates) const;
  /// Change of the parameter in one unit of its coordinate; 0 for a logarithm.
  double scale(std::size_t parameter) const { return scales_[parameter]; }

  /// The model at every row of the data; nothing where there is no solution.
  std::optional<std::vector<double>> fitted(const std::vector<double>& coordinates) const;
  /// Derivatives of that by the coordinates; nothing where there is no solution.
  std::optional<Jacobian> derivatives(const std::vector<double>& coordinates) const;

  /// Steps go out from here: one that leads far away finds no answer, so that the solver shortens
  /// it before any solution is sought there.
  void accept(const std::vector<double>& coordinates) { accepted_ = coordinates; }

  /// Rethrows the exception that an evaluation met, if any.
  void rethrow() const;
  bool failed() const { return failure_ != nullptr; }

private:
  bool too_far(const std::vector<double>& coordinates) const;
  std::vector<double> by_data(const std::vector<double>& coordinates, std::size_t parameter) const;

  FitModel& model_;
  const FitData& data_;
  std::vector<double> start_, scales_, accepted_;
  double size_ = 1;     ///< of the data
  double interval_ = 1; ///< between rows [s]
  mutable std::exception_ptr failure_;
};

} // namespace ionskin::study
