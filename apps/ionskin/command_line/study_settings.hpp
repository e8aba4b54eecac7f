// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command_line/threads.hpp"
#include "terminal/progress_display.hpp"

#include <string>

namespace ionskin::apps {

/// Makes the settings that a run, a sweep and a fit have in common from the options of their verb.
/// @param options options of the verb
/// @param command the command line, for the manifest
/// @param display shows the progress; must outlive the settings
template <class Settings, class Options>
Settings study_settings(const Options& options, const std::string& command,
                        ProgressDisplay& display) {
  Settings settings;
  settings.folder = options.output;
  settings.threads = thread_count(options.threads);
  settings.overwrite = options.overwrite;
  settings.command = command;
  settings.progress = display.callback();
  return settings;
}

} // namespace ionskin::apps
