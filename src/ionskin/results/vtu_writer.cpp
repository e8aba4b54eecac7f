// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/vtu_writer.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/results/atomic_file.hpp"

#include <deal.II/base/data_out_base.h>

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <string>
#include <system_error>
#include <utility>

namespace ionskin::results {
namespace {

using Patch = dealii::DataOutBase::Patch<3, 3>;
using electrochemistry::IonSnapshot;
using electrochemistry::TransportGrid;

struct ElementIndex {
  std::size_t x, y, z;
};

// Vertices in deal.II's order: x fastest, z slowest.
void place(Patch& patch, const TransportGrid& grid, double core_bottom, const ElementIndex& at) {
  for (unsigned vertex = 0; vertex < 8; ++vertex) {
    patch.vertices[vertex] = {grid.x_edges[at.x + vertex % 2], grid.y_edges[at.y + vertex / 2 % 2],
                              core_bottom + grid.z_nodes[at.z + vertex / 4]};
  }
}

void fill(Patch& patch, const TransportGrid& grid, const IonSnapshot& snapshot,
          const ElementIndex& at) {
  const std::size_t columns_x = grid.x_edges.size() - 1;
  const std::size_t columns_y = grid.y_edges.size() - 1;
  patch.data.reinit(3, 8);
  for (unsigned vertex = 0; vertex < 8; ++vertex) {
    const std::size_t value = ((at.z + vertex / 4) * columns_y + at.y) * columns_x + at.x;
    patch.data(0, vertex) = static_cast<float>(snapshot.concentration[value]);
    patch.data(1, vertex) = static_cast<float>(snapshot.potential[value]);
    patch.data(2, vertex) = static_cast<float>(snapshot.shear[value]);
  }
}

std::vector<Patch> make_patches(const TransportGrid& grid, double core_bottom,
                                const IonSnapshot& snapshot) {
  std::vector<Patch> patches;
  for (std::size_t z = 0; z + 1 < grid.z_nodes.size(); ++z) {
    for (std::size_t y = 0; y + 1 < grid.y_edges.size(); ++y) {
      for (std::size_t x = 0; x + 1 < grid.x_edges.size(); ++x) {
        Patch& patch = patches.emplace_back();
        patch.patch_index = static_cast<unsigned>(patches.size() - 1);
        patch.n_subdivisions = 1;
        place(patch, grid, core_bottom, {x, y, z});
        fill(patch, grid, snapshot, {x, y, z});
      }
    }
  }
  return patches;
}

void write_vtu(const std::filesystem::path& path, const TransportGrid& grid, double core_bottom,
               const IonSnapshot& snapshot) {
  const std::vector<std::string> names{"concentration", "potential", "shear"};
  dealii::DataOutBase::VtkFlags flags;
  flags.time = snapshot.time;
  flags.print_date_and_time = false;
  // The best compression takes seconds for a few per cent.
  flags.compression_level = dealii::DataOutBase::VtkFlags::best_speed;
  flags.physical_units = {{"concentration", "mol/m3"}, {"potential", "V"}, {"shear", "1"}};
  AtomicFile file(path);
  dealii::DataOutBase::write_vtu(make_patches(grid, core_bottom, snapshot), names, {}, flags,
                                 file.stream());
  file.commit();
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw UserError(fmt::format("the folder {} cannot be made: {}\n  = choose another with -o",
                                folder.string(), error.message()));
  }
}

} // namespace

void write_fields(const std::filesystem::path& folder, const TransportGrid& grid,
                  double core_bottom, const std::vector<IonSnapshot>& snapshots) {
  make_folder(folder);
  std::vector<std::pair<double, std::string>> record;
  for (std::size_t i = 0; i < snapshots.size(); ++i) {
    const std::string name = fmt::format("fields_{:04}.vtu", i);
    write_vtu(folder / name, grid, core_bottom, snapshots[i]);
    record.emplace_back(snapshots[i].time, name);
  }
  AtomicFile file(folder / "fields.pvd");
  dealii::DataOutBase::write_pvd_record(file.stream(), record);
  file.commit();
}

} // namespace ionskin::results
