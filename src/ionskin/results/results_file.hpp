// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/history/core_history.hpp"
#include "ionskin/readout/signals.hpp"
#include "ionskin/results/contact_map.hpp"
#include "ionskin/results/hdf5/hdf5_file.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace ionskin::results {

/// results.h5: /signals, /sampled, /strain, /ions, /contact, /slider, /case and /manifest. What is
/// written replaces what stood there; nothing is seen under the final name before `commit`, which
/// seals the file.
class ResultsFile {
public:
  enum class Start {
    empty, ///< a new file
    extend ///< with the content of the file that is there, if one is
  };
  ResultsFile(const std::filesystem::path& path, Start start);

  /// Writes a table of signals as a group, one dataset for each column.
  /// @param group "signals", "sampled", "taxels", "circuit", or one of the latter with "sampled_"
  void write_signals(const std::string& group, const readout::SignalTable& table);
  void write_strain(const history::CoreHistory& history);
  /// Concentration, potential and shear, and pore pressure and swelling where water moves, of every
  /// snapshot under /ions/TIME, the grid under /ions/grid.
  void write_ions(const electrochemistry::TransportGrid& grid,
                  const std::vector<electrochemistry::IonSnapshot>& snapshots);
  /// Writes the tractions of the states of a contact.
  /// @param suffix of the slider, after /contact
  void write_contact(const ContactMaps& contact, const std::string& suffix = "");
  /// The slider's underside for drawings, with its suffix after /slider: places /slider/x and
  /// /slider/y from its centre [m], and the height above its lowest point there, /slider/height [y,
  /// x] in m.
  void write_slider(const Slider& slider, const std::string& suffix = "");
  /// Writes the text of the case or of the manifest.
  /// @param name "case" or "manifest"
  void write_text(const std::string& name, const std::string& text);

  /// HDF5 file itself, for groups that only their owner knows.
  Hdf5File& file() { return file_; }
  /// Throws UserError when something could not be written.
  void commit();

private:
  base::PendingFile pending_;
  Hdf5File file_;
};

} // namespace ionskin::results
