// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

/// Coefficients of TR-BDF2 as a diagonally implicit Runge-Kutta method with an explicit first stage
/// (Hosea and Shampine 1996, Applied Numerical Mathematics 20, 21). A time step of length h begins
/// at y0 with the rate r0 and has two implicit stages:
///   middle, at a share `stage_fraction` of the step: y1 = y0 + h (d r0 + d r1),
///   end: y2 = y0 + h (w r0 + w r1 + d r2),
/// with d = `diagonal` and w = `weight`. An embedded formula of order 3 estimates the error of the
/// step as h (`error_of_begin` r0 + `error_of_middle` r1 + `error_of_end` r2).
namespace ionskin::electrochemistry::tr_bdf2 {

inline constexpr double diagonal = 1.0 - 0.5 * std::numbers::sqrt2;
inline constexpr double stage_fraction = 2.0 * diagonal;
inline constexpr double weight = 0.25 * std::numbers::sqrt2;
/// Weights (w, w, d) minus those of the embedded formula, ((1 - w)/3, (3 w + 1)/3, d/3).
inline constexpr double error_of_begin = (4.0 * weight - 1.0) / 3.0, error_of_middle = -1.0 / 3.0,
                        error_of_end = 2.0 * diagonal / 3.0;

} // namespace ionskin::electrochemistry::tr_bdf2
