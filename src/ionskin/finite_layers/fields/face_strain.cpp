// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/fields/face_strain.hpp"

#include "ionskin/finite_layers/fields/mode_means.hpp"
#include "ionskin/parallel/task_pool.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace ionskin::finite_layers {
namespace {

/// Number of modes of a parity that are all selected, and step between the selected modes beyond
/// them over the number of modes before.
constexpr Eigen::Index first_modes = 10;
constexpr double step_share = 0.13;

/// Values and slopes of the shape functions at all levels, [level, node].
struct Levels {
  Eigen::MatrixXd value, slope;

  Levels(const ThicknessColumn& column, const std::vector<DepthLevel>& levels)
      : value(static_cast<Eigen::Index>(levels.size()), column.nodes()),
        slope(value.rows(), value.cols()) {
    for (Eigen::Index i = 0; i < value.rows(); ++i) {
      const auto at = column.at(levels[static_cast<std::size_t>(i)]);
      value.row(i) = at.value;
      slope.row(i) = at.slope;
    }
  }
};

/// Calculates the strain of one mode per motion of a face, where a motion of 1 is a strain of 1,
/// [level, node].
Strains strain_of(const ModeMotion& motion, const Levels& levels, const PlaneMode& mode,
                  Face face) {
  const double k = std::hypot(mode.x, mode.y);
  const double c = k > 0 ? mode.x / k : 1, s = k > 0 ? mode.y / k : 0;
  const Eigen::MatrixXd x = c * motion.along - s * motion.across,
                        y = s * motion.along + c * motion.across;
  const Eigen::MatrixXd value_x = levels.value * x, value_y = levels.value * y,
                        value_z = levels.value * motion.upwards;
  Strains strain{mode.x * value_x,
                 mode.y * value_y,
                 levels.slope * motion.upwards,
                 0.5 * (levels.slope * y - mode.y * value_z),
                 0.5 * (levels.slope * x - mode.x * value_z),
                 -0.5 * (mode.y * value_x + mode.x * value_y)};
  strain[face == Face::side ? 1 : 0] += levels.value;
  return strain;
}

/// Sums of cos(n pi y)/n^2 and sin(n pi y)/n over all n = 2, 4, ... or n = 1, 3, ... in closed
/// form, averaged over a place y, which runs from 0 to 1 across the skin.
struct WholeSums {
  double cosine = 0, sine = 0;

  WholeSums(Parity parity, const Interval& place) {
    const double pi = std::numbers::pi;
    const auto sum = [&](double y) {
      return parity == Parity::even ? pi * pi * (1.0 / 24 - y * (1 - y) / 4)
                                    : pi * pi / 4 * (0.5 - y);
    };
    cosine = (sum(place.from) + 4 * sum(place.middle()) + sum(place.to)) / 6;
    sine = parity == Parity::even ? pi / 4 * (1 - 2 * place.middle()) : pi / 4;
  }
};

/// Calculates the means of the cosine and the sine of all modes of a parity up to a last one, which
/// also stands for all modes beyond it. The coefficients of cosines fall like 1/n^2. Those of sines
/// would fall at least as fast, as the faces carry no shear, but elements free the faces of shear
/// only on average, so that a remainder falls like 1/n.
ModeTransform complete_means(const std::vector<Interval>& places, double across, Parity parity,
                             Eigen::Index modes) {
  const double first = parity == Parity::even ? 0 : 0.5;
  ModeTransform means = mode_means(places, 2 * std::numbers::pi / across, modes, first);
  const auto number = [&](Eigen::Index i) { return 2 * (first + static_cast<double>(i)); };
  Eigen::ArrayXd cosine(means.cosine.rows()), sine(means.cosine.rows());
  for (Eigen::Index i = 0; i < means.cosine.rows(); ++i) {
    const Interval& place = places[static_cast<std::size_t>(i)];
    const WholeSums whole(parity, {place.from / across, place.to / across});
    cosine(i) = whole.cosine;
    sine(i) = whole.sine;
  }
  for (Eigen::Index i = parity == Parity::even ? 1 : 0; i + 1 < modes; ++i) {
    cosine -= means.cosine.col(i) / (number(i) * number(i));
    sine -= means.sine.col(i) / number(i);
  }
  const double last = number(modes - 1);
  means.cosine.col(modes - 1) = cosine * last * last;
  means.sine.col(modes - 1) = sine * last;
  return means;
}

/// Makes splits for places far from a face, where the shorter waves excited by the face have
/// decayed, so that only the long waves of a split are summed: from a sixteenth to half of all
/// waves.
/// @param last wave number up to which modes are summed at the face [1/m]
std::vector<WaveSplit> smooth_waves(double last) {
  constexpr double least = 1.0 / 16, tolerance = 1e-4; // tolerance as in SkinFields
  std::vector<WaveSplit> result;
  for (double share = least; share < 1; share *= 2) {
    result.emplace_back(WaveSplit(1, tolerance).last_long() / (share * last), tolerance);
  }
  return result;
}

/// Calculates the means of modes across the skin over places that are farther from both faces than
/// the reach of the shorter waves. Each mode is multiplied by its share in the longer waves,
/// docs/model.md (52).
ModeTransform smooth_means(const std::vector<Interval>& places, double across, Parity parity,
                           const WaveSplit& smooth) {
  const double first = parity == Parity::even ? 0 : 0.5, step = 2 * std::numbers::pi / across;
  const auto modes = static_cast<Eigen::Index>(smooth.last_long() / step) + 1;
  ModeTransform means = mode_means(places, step, modes, first);
  for (Eigen::Index i = 0; i < modes; ++i) {
    const double share = smooth.long_share((first + static_cast<double>(i)) * step);
    means.cosine.col(i) *= share;
    means.sine.col(i) *= share;
  }
  return means;
}

/// Weight of one of four selected modes in the interpolation of mode n: a cubic in ln n through
/// their values times n^2.
double share_of(const std::vector<Eigen::Index>& chosen, Eigen::Index first, Eigen::Index which,
                Eigen::Index n) {
  const auto number = [&](Eigen::Index i) {
    return static_cast<double>(chosen[static_cast<std::size_t>(first + i)]);
  };
  const auto mode = static_cast<double>(n);
  const double own = number(which);
  double share = own * own / (mode * mode);
  for (Eigen::Index i = 0; i < 4; ++i) {
    share *= i == which ? 1.0 : std::log(mode / number(i)) / std::log(own / number(i));
  }
  return share;
}

} // namespace

FaceModes::FaceModes(const ThicknessColumn& column, Face of_face, double extent_along,
                     double extent_across, std::vector<Eigen::Index> modes_along, Parity parity,
                     double last, int threads)
    : face(of_face), along(extent_along), across(extent_across), modes(std::move(modes_along)),
      motion(modes.size()) {
  const Eigen::Index first = parity == Parity::even ? 0 : 1;
  const auto most = static_cast<Eigen::Index>(last * across / (2 * std::numbers::pi));
  for (Eigen::Index i = 0; i <= std::max(most, first_modes + 4);
       i += std::max(
           Eigen::Index{1},
           i < first_modes ? 1 : static_cast<Eigen::Index>(step_share * static_cast<double>(i)))) {
    numbers.push_back(first + 2 * i);
  }
  parallel::run_tasks(modes.size(), threads, [&](std::size_t at) {
    for (std::size_t number = 0; number < numbers.size(); ++number) {
      motion[at].push_back(mode_motion(column, mode(at, number), face));
    }
  });
}

PlaneMode FaceModes::mode(std::size_t at, std::size_t number) const {
  const double own = static_cast<double>(modes[at]) * std::numbers::pi / along,
               other = static_cast<double>(numbers[number]) * std::numbers::pi / across;
  return face == Face::side ? PlaneMode{own, other} : PlaneMode{other, own};
}

FaceStrain::FaceStrain(const ThicknessColumn& column, const FaceModes& modes,
                       const std::vector<DepthLevel>& levels, const ComponentChoice& components,
                       std::size_t most)
    : face_(modes.face), components_(components), across_(modes.across), numbers_(modes.numbers),
      smooth_(smooth_waves(static_cast<double>(numbers_.back()) * std::numbers::pi / across_)),
      levels_(static_cast<Eigen::Index>(levels.size())) {
  for (std::size_t i = 0; i + 1 < numbers_.size(); ++i) {
    for (Eigen::Index n = numbers_[i] + 2; n < numbers_[i + 1]; n += 2) {
      Between between{n / 2, static_cast<Eigen::Index>(std::min(i - 1, numbers_.size() - 4)), {}};
      for (Eigen::Index j = 0; j < 4; ++j) {
        between.share[static_cast<std::size_t>(j)] = share_of(numbers_, between.first, j, n);
      }
      between_.push_back(between);
    }
  }
  const Levels at(column, levels);
  const auto count = static_cast<Eigen::Index>(numbers_.size());
  for (std::size_t mode = 0; mode < std::min(most, modes.modes.size()); ++mode) {
    Strains& of_mode = of_mode_.emplace_back();
    for (std::size_t c = 0; c < 6; ++c) {
      of_mode[c].resize(components[c] ? count * levels_ : 0, column.nodes());
    }
    for (std::size_t number = 0; number < numbers_.size(); ++number) {
      const Strains strain =
          strain_of(modes.motion[mode][number], at, modes.mode(mode, number), face_);
      for (std::size_t c = 0; c < 6; ++c) {
        if (!components[c]) {
          continue;
        }
        of_mode[c](Eigen::seqN(static_cast<Eigen::Index>(number), levels_, count), Eigen::all) =
            (numbers_[number] == 0 ? 2 : 4) / across_ * strain[c];
      }
    }
  }
}

Eigen::MatrixXd FaceStrain::gathered(const Eigen::ArrayXXd& means) const {
  Eigen::MatrixXd result(means.rows(), static_cast<Eigen::Index>(numbers_.size()));
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    const Eigen::Index mode = numbers_[static_cast<std::size_t>(i)] / 2;
    if (mode < means.cols()) {
      result.col(i) = means.col(mode);
    } else {
      result.col(i).setZero();
    }
  }
  for (const Between& between : between_) {
    for (std::size_t j = 0; j < 4 && between.mode < means.cols(); ++j) {
      result.col(between.first + static_cast<Eigen::Index>(j)) +=
          between.share[j] * means.col(between.mode).matrix();
    }
  }
  return result;
}

std::array<Eigen::MatrixXd, 2> FaceStrain::waves_at(const std::vector<Interval>& places) const {
  const Parity parity = numbers_.front() == 0 ? Parity::even : Parity::odd;
  const auto place_count = static_cast<Eigen::Index>(places.size()),
             count = static_cast<Eigen::Index>(numbers_.size());
  const Eigen::Index all = numbers_.back() / 2 + 1;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<Eigen::MatrixXd, 2> result{Eigen::MatrixXd(place_count, count),
                                        Eigen::MatrixXd(place_count, count)};
  double beyond = infinity; // places at least this far from both faces are finished
  for (std::size_t group = 0; group <= smooth_.size(); ++group) {
    const bool near = group == smooth_.size();
    const double from = near ? -infinity : smooth_[group].reach();
    std::vector<Interval> chosen;
    std::vector<Eigen::Index> index;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double distance = std::min(places[i].from, across_ - places[i].to);
      if (distance >= from && distance < beyond) {
        chosen.push_back(places[i]);
        index.push_back(static_cast<Eigen::Index>(i));
      }
    }
    beyond = from;
    const ModeTransform means = near ? complete_means(chosen, across_, parity, all)
                                     : smooth_means(chosen, across_, parity, smooth_[group]);
    result[0](index, Eigen::all) = gathered(means.cosine);
    result[1](index, Eigen::all) = gathered(means.sine);
  }
  return result;
}

std::vector<Strains> FaceStrain::at(const std::vector<const Eigen::MatrixXd*>& motions,
                                    const std::vector<const std::vector<Interval>*>& places) const {
  const auto count = static_cast<Eigen::Index>(numbers_.size());
  std::vector<Strains> result(motions.size());
  for (std::size_t first = 0; first < motions.size(); first += states_at_once) {
    const std::size_t last = std::min<std::size_t>(first + states_at_once, motions.size());
    std::vector<std::array<Eigen::MatrixXd, 2>> waves; // cosine and sine, [place, number]
    for (std::size_t state = first; state < last; ++state) {
      waves.push_back(waves_at(*places[state]));
    }
    const Eigen::Index nodes = motions[first]->rows();
    std::vector<StatesTogether> together(of_mode_.size(),
                                         StatesTogether::Zero(nodes, states_at_once));
    for (Eigen::Index mode = 0; mode < modes(); ++mode) {
      for (std::size_t state = first; state < last; ++state) {
        together[static_cast<std::size_t>(mode)].col(static_cast<Eigen::Index>(state - first)) =
            motions[state]->col(mode);
      }
    }
    std::vector<Eigen::MatrixXd> numbers(last - first, Eigen::MatrixXd(count, modes() * levels_));
    StatesTogether strain(count * levels_, states_at_once);
    for (std::size_t c = 0; c < 6; ++c) {
      if (!components_[c]) {
        continue;
      }
      const bool by_sine = face_ == Face::side ? sine_along_y[c] : sine_along_x[c];
      for (Eigen::Index mode = 0; mode < modes(); ++mode) {
        strain.noalias() =
            of_mode_[static_cast<std::size_t>(mode)][c] * together[static_cast<std::size_t>(mode)];
        for (std::size_t state = 0; state < numbers.size(); ++state) {
          numbers[state].middleCols(mode * levels_, levels_) =
              strain.col(static_cast<Eigen::Index>(state)).reshaped(count, levels_);
        }
      }
      for (std::size_t state = 0; state < numbers.size(); ++state) {
        result[first + state][c].noalias() = waves[state][by_sine ? 1 : 0] * numbers[state];
      }
    }
  }
  return result;
}

} // namespace ionskin::finite_layers
