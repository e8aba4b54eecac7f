// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/linear_algebra/cholesky.hpp"
#include "ionskin/linear_algebra/lower_triangle.hpp"
#include "ionskin/mechanics/position/elastic_skin.hpp"
#include "ionskin/mesh/skin_mesh.hpp"
#include "ionskin/parallel/spare_threads.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <semaphore>
#include <utility>
#include <vector>

namespace ionskin::mechanics {

/// One part of the skin, factorised up to its interface.
class PartFactor {
public:
  PartFactor(const SkinPart& part, const mesh::MeshLines& lines,
             const std::vector<ElasticLaw>& law_of_row);

  const linear_algebra::Cholesky& cholesky() const { return *cholesky_; }
  /// Schur complement of its interface: the stiffness of the part as felt there [N/m].
  const linear_algebra::LowerTriangle& schur() const { return schur_; }
  void forget_schur() { schur_ = {}; }
  /// Adds the force of the skin on its base per unit of each unknown to that of the whole skin.
  void add_reaction(const PlacedPart& placed, std::size_t axis,
                    std::array<std::vector<double>, 3>& whole) const;

private:
  std::unique_ptr<const linear_algebra::Cholesky> cholesky_;
  linear_algebra::LowerTriangle schur_;
  std::array<std::vector<double>, 3> base_reaction_; ///< by the part's elimination order
};

/// The part under the slider with unit forces on the contact cells, where its interface is free.
struct InnerFactor {
  PartFactor factor;
  linear_algebra::ForwardSubstitution loads; ///< of unit forces on the components of the cells
  linear_algebra::DenseMatrix compliance;    ///< of the cells while the interface is held [m/N]

  InnerFactor(const SkinParts& parts, const ContactCells& cells, const mesh::MeshLines& lines,
              const std::vector<ElasticLaw>& law_of_row);
};

/// Displacement of the skin in some states. Large: to be filled again is faster than to be made.
class SkinDisplacement {
public:
  explicit SkinDisplacement(const SkinParts& parts) : parts_(parts), outer_(parts.outer.size()) {}
  int states() const { return inner_.rows; }
  /// Of all unknowns of the skin in `count` states from `first` on, each a column; valid until the
  /// next call.
  const linear_algebra::DenseMatrix& of_skin(int first, int count);

private:
  friend class FactorisedSkin;
  const SkinParts& parts_;
  linear_algebra::DenseMatrix inner_; ///< [states, unknowns in elimination order]
  std::vector<linear_algebra::DenseMatrix> outer_;
  linear_algebra::DenseMatrix of_skin_;
};

/// The factor of one position, and its place among those that fit into the memory: the parts by
/// themselves, and the Schur complement of their interface (substructuring; Przemieniecki 1963,
/// doi 10.2514/3.1514). The inner part is shared by the positions whose lines across the cut are
/// the same.
class FactorisedSkin {
public:
  /// @param threads where the memory holds no other factor beside this one
  /// @param spare help where it does; none when null
  FactorisedSkin(const ElasticSkin& skin, const mesh::MeshLines& lines, int threads = 1,
                 parallel::SpareThreads* spare = nullptr);

  /// As parallel::run_tasks, on the threads that this factor has.
  void run_tasks(std::size_t count, const std::function<void(std::size_t)>& task) const;
  const linear_algebra::DenseMatrix& compliance() const { return compliance_; }
  /// Under unit forces in one direction on the cells from `first` on. These two by one thread each.
  void unit_displacement(int direction, int first, int count, SkinDisplacement& result) const;
  /// Under given forces [3 cells, states].
  void displacement(const linear_algebra::DenseMatrix& forces, SkinDisplacement& result) const;
  std::array<double, 3> base_reaction(const double* displacement) const;

private:
  /// Waits until the memory holds one more factor. The first member, it goes when the factor is
  /// gone.
  class Place {
  public:
    explicit Place(std::counting_semaphore<>& places);
    ~Place();
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

  private:
    std::counting_semaphore<>& places_;
  };

  void factorise_parts(const ElasticSkin& skin, const mesh::MeshLines& lines);
  void join();
  void gather_reactions(int unknowns);
  /// From forward substitution in the inner part and displacements of the interface by state.
  void complete(const linear_algebra::DenseMatrix& interface, SkinDisplacement& result) const;

  Place place_;
  int threads_, kernel_threads_;
  parallel::SpareThreads* spare_;
  const SkinParts& parts_;
  std::vector<PartFactor> outer_;
  std::shared_ptr<const InnerFactor> inner_;
  linear_algebra::DenseMatrix compliance_;
  linear_algebra::DenseMatrix interface_; ///< displacement under unit forces, [unknowns, 3 cells]
  /// Of the unknowns that the base feels, by axis.
  std::vector<std::pair<std::size_t, std::array<double, 3>>> base_reaction_;
};

} // namespace ionskin::mechanics
