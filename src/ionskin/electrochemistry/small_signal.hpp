// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/equations/steric_excess.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/electrochemistry/grid/scaled_grid.hpp"
#include "ionskin/electrochemistry/output/ion_solution.hpp"

#include <array>
#include <complex>
#include <optional>
#include <vector>

namespace ionskin::electrochemistry {

/// The cell's answer to a small alternating voltage about its rest (c = c0/v, phi = 0), which is
/// the same in every column. The levels and the Jacobian are those of the transport equations, so
/// that the spectrum belongs to the very discretisation that gives the currents; for each frequency
/// one complex block-tridiagonal system through the thickness is solved directly.
class SmallSignalCell {
public:
  explicit SmallSignalCell(const Case& input);

  /// Voltage phi_top - phi_bottom over the current into the top electrode, times the area of the
  /// electrode [ohm m2].
  /// @param frequency [Hz], positive
  std::complex<double> area_impedance(double frequency) const;

private:
  using Block = std::array<double, 4>; ///< rows: ion balance, Poisson; columns: c, phi

  using Answer = std::array<std::complex<double>, 2>; ///< c, phi

  void probe_jacobian();
  /// Departure from rest per level under half a unit of potential of either sign on the walls.
  /// @param rate i omega tau
  std::vector<Answer> respond(std::complex<double> rate) const;

  DerivedScales scales_;
  TransportGrid grid_;
  ScaledGrid scaled_;
  std::optional<StericExcess> excess_;
  std::vector<Block> lower_, diagonal_, upper_; ///< of a stage of unit step, per level
};

} // namespace ionskin::electrochemistry
