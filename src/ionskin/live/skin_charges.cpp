// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/skin.hpp"

#include <algorithm>

namespace ionskin::live {

/// Weighted sum over the z levels of the integrals of the driving channel over a region; in laws
/// that depend on the mean over the core, also of the integrals over the core times the region's
/// share of its area [C].
/// @param region 0 for the core, then the taxels
/// @param weights [model.inputs] [C/m2]
double Skin::drive(const ChargeModel& model, std::size_t region,
                   const double* weights) const noexcept {
  const std::size_t levels = data_.channels.back().mean.size();
  double sum = 0;
  for (std::size_t i = 0; i < levels; ++i) {
    sum += weights[i] * levels_[region * levels + i];
    if (model.inputs > levels) { // laws that depend on the mean over the core
      sum += weights[levels + i] * region_share_[region] * levels_[i];
    }
  }
  return sum;
}

void Skin::add_charges(double time_step, bool first) noexcept {
  const std::size_t rates = data_.rates.size();
  for (std::size_t rate = 0; rate < rates; ++rate) {
    passes_[rate] = LowPass::over(data_.rates[rate], time_step);
  }
  for (std::size_t region = 0; region < regions_; ++region) {
    const ChargeModel& model = region == 0 ? data_.whole : data_.part;
    for (std::size_t side = 0; side < sides; ++side) {
      const std::size_t output = sides * region + side;
      double charge = drive(model, region, model.direct.data() + side * model.inputs);
      for (std::size_t rate = 0; rate < rates; ++rate) {
        double &filtered = state_[filters_ + output * rates + rate],
               &before = state_[drives_ + output * rates + rate];
        const double now =
            drive(model, region, model.residue.data() + (side * rates + rate) * model.inputs);
        if (!first) {
          filtered = passes_[rate].next(filtered, before, now);
        }
        before = now;
        charge += filtered;
      }
      charge_[output] = charge;
    }
  }
}

void Skin::add_spread(const Pressed& pressed, std::span<const double> amplitude) noexcept {
  const std::size_t waves = spread_.waves();
  if (waves == 0) {
    return;
  }
  std::ranges::fill(wave_drive_, 0.0);
  if (pressed.touches) {
    spread_.drive(pressed.place, amplitude, wave_drive_);
  }
  const auto relaxed = std::span(state_).subspan(waves_, waves);
  double* before = state_.data() + waves_ + waves;
  for (std::size_t wave = 0; wave < waves; ++wave) {
    if (!pressed.first) {
      relaxed[wave] = LowPass::over(data_.spread.rates[wave], pressed.time_step)
                          .next(relaxed[wave], before[wave], wave_drive_[wave]);
    }
    before[wave] = wave_drive_[wave];
  }
  for (std::size_t taxel = 0; taxel + 1 < regions_; ++taxel) {
    const double charge = spread_.charge(taxel, relaxed);
    for (std::size_t side = 0; side < sides; ++side) {
      charge_[sides * (taxel + 1) + side] += charge;
    }
  }
}

/// Fills `levels_` with the integrals of a channel over every region, from its integrals up to the
/// regions' corners.
/// @param to called with a corner [m] and the span that receives the integrals there [level]
template <class IntegrateTo> void Skin::set_levels(std::size_t levels, IntegrateTo&& to) noexcept {
  const auto at = [&](std::size_t corner) {
    return std::span(corner_levels_).subspan(corner * levels, levels);
  };
  for (std::size_t corner = 0; corner < corners_.size(); ++corner) {
    to(corners_[corner], at(corner));
  }
  for (std::size_t region = 0; region < regions_; ++region) {
    const auto& own = region_corners_[region];
    for (std::size_t i = 0; i < levels; ++i) {
      levels_[region * levels + i] =
          (at(own[3])[i] - at(own[2])[i]) - (at(own[1])[i] - at(own[0])[i]);
    }
  }
}

void Skin::set_field_levels(const ChannelField& field, std::size_t lane,
                            const std::array<double, 2>& place) noexcept {
  set_levels(field.levels(), [&](const std::array<double, 2>& corner, std::span<double> levels) {
    field.integrate_to(lane, place, corner, levels);
  });
}

/// Fills `charge_slope_` with the derivatives of the charges, at the end of the last step, by a
/// rigid motion of the slider. The drives at the beginning of the step count as constant.
/// @param field of the driving channel, after `differentiate`
/// @param motion index of the motion, 0 to 5
void Skin::set_charge_slopes(const ChannelField& field, std::size_t motion) noexcept {
  set_levels(field.levels(), [&](const std::array<double, 2>& corner, std::span<double> levels) {
    field.integrate_slope_to(motion, last_.place, corner, levels);
  });
  const auto followed = [&](double rate) {
    return last_.first ? 0.0 : LowPass::over(rate, last_.time_step).now;
  };
  const std::size_t rates = data_.rates.size();
  for (std::size_t region = 0; region < regions_; ++region) {
    const ChargeModel& model = region == 0 ? data_.whole : data_.part;
    for (std::size_t side = 0; side < sides; ++side) {
      double slope = drive(model, region, model.direct.data() + side * model.inputs);
      for (std::size_t rate = 0; rate < rates; ++rate) {
        slope += followed(data_.rates[rate]) *
                 drive(model, region, model.residue.data() + (side * rates + rate) * model.inputs);
      }
      charge_slope_[sides * region + side] = slope;
    }
  }
  const std::size_t waves = spread_.waves();
  if (waves == 0) {
    return;
  }
  spread_.drive(last_.place, field.amplitude_slope(motion), wave_drive_);
  if (motion < last_.place.size()) {
    const auto along = motion == 0 ? ChargeSpread::Along::x : ChargeSpread::Along::y;
    spread_.drive(last_.place, field.amplitude(0), wave_slope_, along);
    for (std::size_t wave = 0; wave < waves; ++wave) {
      wave_drive_[wave] += wave_slope_[wave];
    }
  }
  for (std::size_t wave = 0; wave < waves; ++wave) {
    wave_drive_[wave] *= followed(data_.spread.rates[wave]);
  }
  for (std::size_t taxel = 0; taxel + 1 < regions_; ++taxel) {
    const double slope = spread_.charge(taxel, wave_drive_);
    for (std::size_t side = 0; side < sides; ++side) {
      charge_slope_[sides * (taxel + 1) + side] += slope;
    }
  }
}

} // namespace ionskin::live
