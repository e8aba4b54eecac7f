// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ionskin::study {

/// True if a metric judges the solution, such as a residual, or the instrument, and has no error of
/// its own.
bool is_audit(const std::string& metric);

/// True if a metric or a signal is made at the edges of the contact, where the strain is singular
/// or what touches changes by whole cells: first moments, percentiles and extremes of the shear,
/// area, pressure and stick of the contact.
bool hangs_on_edges(const std::string& quantity);

/// Signals whose relative error over the run a metric's is taken to be no smaller than.
std::vector<std::string> related_signals(const std::string& metric);

/// Signals whose relative error over the run that of a signal is taken to be no smaller than, the
/// signal itself left out: a mean shear follows the forces.
std::vector<std::string> leading_signals(const std::string& signal);

/// Metrics whose relative error a metric's is taken to be no smaller than.
std::vector<std::string> related_metrics(const std::string& metric);

} // namespace ionskin::study
