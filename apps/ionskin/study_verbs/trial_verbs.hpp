// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command_line/options.hpp"

namespace ionskin::apps {

// Verbs that run many trials of a case, carried out by ionskin's Python package. The exit code is
// that of its script.

/// Results of uncertain keys.
int uncertainty(const UncertaintyOptions& options);

/// Best values of free keys.
int design(const DesignOptions& options);

/// A store of random touches.
int generate(const GenerateOptions& options);

/// A path of waypoints from recordings of a robot.
int motion(const MotionOptions& options);

} // namespace ionskin::apps
