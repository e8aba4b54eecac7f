// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command_line/options.hpp"

namespace ionskin::apps {

// Verbs that run many trials of a case, carried out by ionskin's Python package. The exit code is
// that of its script.

/// Runs `ionskin uncertainty`: statistics and Sobol' indices of results under uncertain keys.
int uncertainty(const UncertaintyOptions& options);

/// Runs `ionskin design`: searches the best values of free keys under constraints.
int design(const DesignOptions& options);

/// Runs `ionskin generate`: writes a file of random touches with their signals, as training data.
int generate(const GenerateOptions& options);

/// Runs `ionskin motion`: makes a path of waypoints from recordings of a robot.
int motion(const MotionOptions& options);

} // namespace ionskin::apps
