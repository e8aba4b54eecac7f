// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/equations/steric_excess.hpp"

#include <algorithm>
#include <cstddef>

namespace ionskin::electrochemistry {

void StericExcess::drive(std::span<const double> concentration, std::span<const double> potential,
                         std::span<double> out) const {
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = potential[i] + excess(concentration[i]);
  }
}

void StericExcess::drive_change(std::span<const double> concentration,
                                std::span<const double> d_concentration,
                                std::span<const double> d_potential, std::span<double> out) const {
  const double taken = filling;
#pragma omp simd
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = d_potential[i] + taken / (1.0 - taken * concentration[i]) * d_concentration[i];
  }
}

bool StericExcess::leaves_room(std::span<const double> safe, std::span<const double> guess,
                               double share) const {
  for (std::size_t i = 0; i < guess.size(); ++i) {
    if (!(room(guess[i]) > share * room(safe[i]))) {
      return false;
    }
  }
  return true;
}

void StericExcess::keep_room(std::span<const double> before, std::span<double> after,
                             double share) const {
  const double most = (1.0 - share) / filling;
  for (std::size_t i = 0; i < after.size(); ++i) {
    after[i] = std::min(after[i], share * before[i] + most);
  }
}

std::optional<StericExcess> steric_excess(const Electrochemistry& electrochemistry) {
  if (electrochemistry.ion_model != IonModel::steric) {
    return std::nullopt;
  }
  return StericExcess{electrochemistry.fixed_charge_concentration /
                      (electrochemistry.valence * electrochemistry.largest_concentration)};
}

} // namespace ionskin::electrochemistry
