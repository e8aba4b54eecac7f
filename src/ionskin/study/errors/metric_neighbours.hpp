// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ionskin::study {

/// True if a metric measures the quality of the solution, such as a residual, or the noise of the
/// instrument, and therefore has no error of its own.
bool is_audit(const std::string& metric);

/// True if a metric or a signal depends on the edges of the contact, where the strain is singular
/// or the contact changes by whole cells: first moments, percentiles and extremes of the shear;
/// area, pressure and stick of the contact.
/// @param quantity name of the metric or signal
bool hangs_on_edges(const std::string& quantity);

/// Names of the signals related to a metric: the relative error of the metric is taken to be at
/// least the relative error norm of these signals over the run.
std::vector<std::string> related_signals(const std::string& metric);

/// Names of the signals that lead another signal, without the signal itself: its relative error is
/// taken to be at least theirs. The normal force leads a mean shear; other signals have none.
std::vector<std::string> leading_signals(const std::string& signal);

/// Names of the metrics related to a metric, such as contact area and mean pressure: its relative
/// error is taken to be at least theirs.
std::vector<std::string> related_metrics(const std::string& metric);

} // namespace ionskin::study
