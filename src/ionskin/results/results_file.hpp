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

/// Writer of results.h5, with the groups /signals, /sampled, /strain, /ions, /contact and /slider
/// and the texts /case and /manifest. A group that is written replaces one of the same name. The
/// file appears under its final name only at `commit`, which also seals it
/// (base/files/sealed_file.hpp).
class ResultsFile {
public:
  enum class Start {
    empty, ///< start from an empty file
    extend ///< start from a copy of the existing file, or empty if there is none
  };
  ResultsFile(const std::filesystem::path& path, Start start);

  /// Writes a table of signals as a group, with one dataset per column.
  /// @param group name of the table, such as "signals", "sampled", "taxels", "sampled_taxels" or
  ///   "signals_error"
  void write_signals(const std::string& group, const readout::SignalTable& table);
  /// Writes a strain history as /strain, with the layout of strain_file.hpp.
  void write_strain(const history::CoreHistory& history);
  /// Writes the fields of Study 2: the grid as /ions/grid [m], and each snapshot as a group
  /// /ions/TIME with concentration [mol/m3], potential [V] and shear [1], and where water moves
  /// pore pressure [Pa] and swelling [1]. Fields are [z][y][x].
  void write_ions(const electrochemistry::TransportGrid& grid,
                  const std::vector<electrochemistry::IonSnapshot>& snapshots);
  /// Writes the contact maps of one slider as the group /contact, one subgroup per state.
  /// @param suffix of the slider ("_2" for the second), appended to the name /contact
  void write_contact(const ContactMaps& contact, const std::string& suffix = "");
  /// Writes the shape of a slider's underside, for drawings, as the group /slider: sample
  /// positions x and y from the slider's centre [m], and height [y][x] above its lowest point [m].
  /// @param suffix of the slider ("_2" for the second), appended to the name /slider
  void write_slider(const Slider& slider, const std::string& suffix = "");
  /// Writes the text of the case or of the manifest.
  /// @param name "case" or "manifest"
  void write_text(const std::string& name, const std::string& text);

  /// Open HDF5 file, for groups whose layout only the caller knows.
  Hdf5File& file() { return file_; }
  /// Closes and seals the file and gives it its final name. Throws UserError when something could
  /// not be written.
  void commit();

private:
  base::PendingFile pending_;
  Hdf5File file_;
};

} // namespace ionskin::results
