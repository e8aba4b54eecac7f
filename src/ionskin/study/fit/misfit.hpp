// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/fit/fit_model.hpp"
#include "ionskin/study/fit/fit_statistics.hpp"

#include <ceres/cost_function.h>

#include <exception>
#include <optional>
#include <vector>

namespace ionskin::study {

/// Cost function of the fit for Ceres: residuals (data minus model, scaled by the size of the data)
/// and their derivatives as functions of coordinates. The coordinate of a key of the case is the
/// logarithm of its magnitude; the coordinate of a key of the data is its distance from the start
/// over a scale.
class Misfit : public ceres::CostFunction {
public:
  /// Cost function about a start.
  /// @param start one value per parameter [SI]
  /// @param model, data must outlive this object
  Misfit(FitModel& model, const FitData& data, const std::vector<double>& start);

  /// Residuals and, unless null, derivatives, as Ceres defines them; false where there is no
  /// solution. Stores an exception for `rethrow`.
  bool Evaluate(const double* const* parameters, double* residuals,
                double** jacobians) const override;

  /// Coordinates of values of the parameters [SI].
  std::vector<double> coordinates(const std::vector<double>& values) const;
  /// Values of the parameters [SI] at coordinates.
  std::vector<double> values(const std::vector<double>& coordinates) const;
  /// Scale of a parameter: change of a key of the data per unit of its coordinate [SI]; 0 for a key
  /// of the case, whose coordinate is a logarithm.
  double scale(std::size_t parameter) const { return scales_[parameter]; }

  /// Prediction of the model at every row of the data [unit of the data]; empty where there is no
  /// solution.
  std::optional<std::vector<double>> fitted(const std::vector<double>& coordinates) const;
  /// Derivatives of `fitted` by the coordinates; empty where there is no solution.
  std::optional<Jacobian> derivatives(const std::vector<double>& coordinates) const;

  /// Sets the change of a time shift by which `derivatives` take differences, over its scale [1]. A
  /// signal with spikes is no smooth function of the shift: the difference has to be as wide as the
  /// range of shifts that is of interest.
  void take_shift_difference(double width) { shift_difference_ = width; }

  /// Sets the point from which the search takes its steps. `Evaluate` refuses points far away from
  /// it without solving them, so that the solver shortens its step.
  void accept(const std::vector<double>& coordinates) { accepted_ = coordinates; }

  /// Rethrows the exception that an evaluation met, if any; exceptions must not pass through Ceres.
  void rethrow() const;
  bool failed() const { return failure_ != nullptr; }

private:
  bool too_far(const std::vector<double>& coordinates) const;
  std::vector<double> by_data(const std::vector<double>& coordinates, std::size_t parameter) const;

  FitModel& model_;
  const FitData& data_;
  std::vector<double> start_, scales_, accepted_;
  double size_ = 1;                ///< root mean square of the data [unit of the data]
  double interval_ = 1;            ///< mean interval between rows [s]
  double shift_difference_ = 0.05; ///< no solution changes with it [1]
  mutable std::exception_ptr failure_;
};

} // namespace ionskin::study
