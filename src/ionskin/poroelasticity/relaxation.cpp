// SPDX-License-Identifier: Apache-2.0
#include "ionskin/poroelasticity/relaxation.hpp"

#include "ionskin/case/elastic_constants.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ionskin::poroelasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Undrained pore pressure over the stress that causes it, M_B/(M + M_B) [1].
double undrained_share(const Relaxation& core) {
  return core.storage / (1 + core.storage);
}

/// Elastic strain of the branches of the Prony series right after a unit step of p_u, over dM/dG;
/// it is the same for all branches.
/// @param pressure P right after the step
double branch_strain(const Relaxation& core, double pressure) {
  // Dilation t follows from M t = P + (G e or -p), and a branch is strained by dM/dG t - e.
  const double stress = -1 / undrained_share(core); // G e or -p
  switch (core.load) {
  case RelaxingLoad::strain:
    return pressure + stress - stress / (core.shear_share * core.shear);
  case RelaxingLoad::pressure:
    return pressure + stress;
  case RelaxingLoad::water:
    break;
  }
  return pressure;
}

/// Factors of the rate matrix of one mode of the water, for P and the strains of the branches.
struct Rates {
  MatrixXd compliance; ///< T, symmetric; `compliance` * diag(`decay`) is the matrix of rates
  VectorXd decay;
};

/// Rate matrix T W of dz/dt = -T W z for z = (P, branch strains over dM/dG), with T symmetric and W
/// diagonal. For an infinite `diffusion` P is 0 and z holds only the strains.
Rates rates_of(const Relaxation& core, double diffusion) {
  const auto branches = static_cast<Index>(core.times.size());
  const double share = undrained_share(core);
  Rates rates{MatrixXd(branches + 1, branches + 1), VectorXd(branches + 1)};
  rates.compliance.setConstant(-share / core.storage);
  rates.compliance.row(0).setConstant(share);
  rates.compliance.col(0).setConstant(share);
  rates.decay(0) = diffusion / share;
  for (Index i = 0; i < branches; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double modulus = core.shear_share * core.lost[at];
    rates.compliance(i + 1, i + 1) += 1 / modulus;
    rates.decay(i + 1) = modulus / core.times[at];
  }
  if (std::isinf(diffusion)) { // open wall: P stays 0
    const MatrixXd inner = rates.compliance.bottomRightCorner(branches, branches);
    rates.compliance = inner - MatrixXd::Constant(branches, branches, share);
    rates.decay = VectorXd(rates.decay.tail(branches));
  }
  return rates;
}

} // namespace

Relaxation derive_relaxation(const Case& input) {
  const Material& core = input.skin.layers[input.skin.core_index()].material;
  Relaxation relaxation;
  const double modulus = swelling_modulus(input);
  relaxation.times = core.relaxation_times;
  relaxation.shear = shear_modulus(core) / modulus;
  for (const double lost : core.relaxation_shares) {
    relaxation.lost.push_back(lost * relaxation.shear);
  }
  relaxation.shear_share = bends_freely(input) ? 1.0 / 3 : 4.0 / 3;
  relaxation.storage = storage_modulus(input) / modulus;
  relaxation.load = input.strain.curvature != 0 ? RelaxingLoad::strain : RelaxingLoad::pressure;
  return relaxation;
}

StepResponse step_response(const Relaxation& core, double diffusion) {
  const bool drained = std::isinf(diffusion);
  if (core.times.empty()) {
    return {{drained ? 0.0 : diffusion}, {drained ? 0.0 : 1.0}, {0.0}, 1.0};
  }
  const Rates rates = rates_of(core, diffusion);
  const Index size = rates.decay.size();
  const MatrixXd inverse = rates.compliance.llt().solve(MatrixXd::Identity(size, size));
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> modes(
      MatrixXd(rates.decay.asDiagonal()), 0.5 * (inverse + inverse.transpose()));
  VectorXd begin = VectorXd::Constant(size, branch_strain(core, drained ? 0.0 : 1.0));
  if (!drained) {
    begin(0) = 1;
  }
  const MatrixXd shapes = modes.eigenvectors();
  const VectorXd amplitudes = shapes.transpose() * inverse * begin;

  const double lost = core.shear_share * std::accumulate(core.lost.begin(), core.lost.end(), 0.0);
  const double relaxed = 1 - lost; // M after complete relaxation
  const double share = undrained_share(core);
  StepResponse response;
  const auto add = [&](double rate, double pressure, double branches) {
    response.rate.push_back(rate);
    response.pressure.push_back(pressure);
    response.undrained.push_back(pressure * (1 - share * (1 / relaxed + 1 / core.storage)) +
                                 share * branches / relaxed);
  };
  for (Index j = 0; j < size; ++j) {
    double branches = 0;
    for (std::size_t i = 0; i < core.times.size(); ++i) {
      branches += core.shear_share * core.lost[i] *
                  shapes(static_cast<Index>(i) + (drained ? 0 : 1), j) * amplitudes(j);
    }
    const bool conserved = j == 0 && diffusion == 0;
    add(conserved ? 0.0 : std::max(0.0, modes.eigenvalues()(j)),
        drained ? 0.0 : shapes(0, j) * amplitudes(j), branches);
  }
  if (drained) {
    add(0, 0, 0);
  }
  switch (core.load) {
  case RelaxingLoad::strain:
    response.undrained_directly = (1 - lost / (core.shear_share * core.shear)) / relaxed;
    break;
  case RelaxingLoad::pressure:
    response.undrained_directly = 1 / relaxed;
    break;
  case RelaxingLoad::water:
    response.undrained_directly = 1;
    break;
  }
  return response;
}

} // namespace ionskin::poroelasticity
