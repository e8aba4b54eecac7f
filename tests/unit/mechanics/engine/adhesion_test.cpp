// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/motion_stepper.hpp"
#include "ionskin/mechanics/solve_contact.hpp"
#include "ionskin/mechanics/surface/adhesion_energy.hpp"
#include "small_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace ionskin::mechanics {
namespace {

constexpr std::array<double, 2> centre{1e-3, 1e-3};
constexpr double area = 1e-8;                          // of a cell [m2]
constexpr double strength = 1e5;                       // [Pa]
constexpr double most = strength * area;               // pull of a cell [N]
constexpr double range = 1e-6;                         // of the pull [m]
constexpr double adhesion_work = strength * range / 2; // of adhesion [J/m2]

/// One cell on a spring.
struct OneCell {
  SlidingContact contact;

  explicit OneCell(double compliance)
      : contact(
            [compliance](const auto&, ContactProblem& problem) {
              problem.compliance = compliance * Eigen::MatrixXd::Identity(3, 3);
            },
            {area}, {0.0},
            laws::friction(
                "adhesive", 0.3,
                {{"work_of_adhesion", adhesion_work}, {"cohesive_strength", strength}})) {}

  /// Force at a height of the slider [N].
  double at_height(double height) {
    return contact.step(1, centre, {LoadKind::indentation, -height}).force[0];
  }
};

TEST(AdhesiveContact, OfAStiffCellFollowsTheLawUpToItsRange) {
  const double softening = 0.5, compliance = softening * range / most;
  OneCell cell(compliance);
  EXPECT_NEAR(cell.at_height(-1e-6), 1e-6 / compliance, 1e-9 * most);
  // Closed as long as the spring pulls less than the faces hold.
  EXPECT_NEAR(cell.at_height(0.3e-6), -0.3e-6 / compliance, 1e-9 * most);
  for (const double height : {0.6e-6, 0.75e-6, 0.85e-6, 0.9e-6}) {
    const double expected = -(most - most / range * height) / (1 - softening);
    EXPECT_NEAR(cell.at_height(height), expected, 1e-9 * most);
    EXPECT_FALSE(cell.contact.may_have_jumped());
  }
  cell.at_height(1.01e-6);
  EXPECT_FALSE(cell.contact.in_contact());
  // It is pulled again on the way down.
  EXPECT_NEAR(cell.at_height(0.8e-6), -(most - most / range * 0.8e-6) / (1 - softening),
              1e-9 * most);
}

TEST(AdhesiveContact, OfASoftCellJumpsOffWhereTheSpringPullsHarder) {
  const double compliance = 2 * range / most;
  OneCell cell(compliance);
  cell.at_height(-1e-6);
  EXPECT_NEAR(cell.at_height(1.99e-6), -1.99e-6 / compliance, 1e-9 * most);
  EXPECT_EQ(cell.at_height(2.01e-6), 0);
  EXPECT_FALSE(cell.contact.in_contact());
  EXPECT_EQ(cell.at_height(1.99e-6), 0) << "out of its range nothing pulls it back";
}

/// Pull and pressure cancel there, so that the forces are no measure of the residual.
TEST(AdhesiveContact, OfAFlatSliderIsFoundAtTheHeightOfTheUndeformedSkin) {
  constexpr int across = 6, cells = across * across;
  const double width = std::sqrt(area), softness = 0.02 * range / most * width;
  const auto set_compliance = [&](const auto&, ContactProblem& problem) {
    problem.compliance = Eigen::MatrixXd::Zero(3 * cells, 3 * cells);
    for (int i = 0; i < cells; ++i) {
      for (int j = 0; j < cells; ++j) {
        const double way = std::hypot(i % across - j % across, i / across - j / across),
                     value = softness / (width * std::max(way, 0.3));
        problem.compliance.block<3, 3>(3 * i, 3 * j) = value * Eigen::Matrix3d::Identity();
        problem.compliance(3 * i, 3 * j + 1) = 0.1 * value * (i % across - j % across);
        problem.compliance(3 * j + 1, 3 * i) = problem.compliance(3 * i, 3 * j + 1);
      }
    }
  };
  SlidingContact contact(
      set_compliance, std::vector<double>(cells, area), std::vector<double>(cells, 0.0),
      laws::friction("adhesive", 0.3,
                     {{"work_of_adhesion", adhesion_work}, {"cohesive_strength", strength}}));
  for (const double height : {-1e-6, -3.3e-7, 0.0, 1e-8, 0.0}) {
    SCOPED_TRACE(height);
    const auto& state = contact.step(1, centre, {LoadKind::indentation, -height});
    EXPECT_TRUE(contact.in_contact());
    EXPECT_EQ(state.force[0] > 1e-9 * most, height < 0);
  }
}

TEST(AdhesiveContact, CarriesAPullThatIsGivenOrLetsGo) {
  OneCell cell(0.5 * range / most);
  const auto under = [&](double force) {
    return cell.contact.step(1, centre, {LoadKind::force, force});
  };
  EXPECT_NEAR(under(2 * most).indentation, range, 1e-6 * range);
  EXPECT_NEAR(under(-0.5 * most).indentation, -0.25 * range, 1e-6 * range);
  EXPECT_NEAR(under(-0.99 * most).indentation, -0.495 * range, 1e-6 * range);
  under(-1.01 * most);
  EXPECT_FALSE(cell.contact.in_contact());
  under(-0.1 * most);
  EXPECT_FALSE(cell.contact.in_contact()) << "it has flown";
  under(most);
  EXPECT_TRUE(cell.contact.in_contact());
}

TEST(AdhesiveContact, CountsWhatAJumpLoses) {
  const double compliance = 2 * range / most;
  OneCell cell(compliance);
  cell.at_height(-1e-6);
  cell.at_height(2e-6 * (1 - 1e-9));
  const SlidingContact::Moment before = cell.contact.moment();
  const double energy = cell.contact.energy();
  cell.at_height(2e-6 * (1 + 1e-9));
  const double lost =
      work_on_skin(before.state, cell.contact.state(), 0) - (cell.contact.energy() - energy);
  // The spring's energy goes, the bond is to be paid.
  EXPECT_NEAR(lost, 0.5 * compliance * most * most - adhesion_work * area,
              1e-6 * adhesion_work * area);
}

TEST(AdhesiveContact, IsSteppedThroughHeightsOrPullsAlone) {
  const SliderLevel above{false, range}, touching{false, 0.5 * range};
  for (const auto& [from, to] :
       {std::pair{SliderLevel{false, 0.6 * range}, SliderLevel{false, 0.9 * range}},
        std::pair{SliderLevel{true, -0.6 * most}, SliderLevel{true, -0.2 * most}}}) {
    OneCell cell(0.5 * range / most);
    StepperOptions options;
    options.longest_travel = 1e-4;
    double force = 0;
    MotionStepper stepper(cell.contact, options, [&](const StepPoint&, const SlidingContact& at) {
      force = at.state().force[0];
    });
    stepper.follow({Phase::touchdown, 0, 1, centre, centre, above, touching});
    stepper.follow({Phase::slide, 1, 1, centre, centre, touching, from});
    stepper.follow({Phase::slide, 2, 1, centre, centre, from, to});
    EXPECT_LT(stepper.steps(), 200);
    EXPECT_NEAR(force, -0.2 * most, 1e-9 * most); // the pull at 0.9 of the range, too
  }
}

/// Forces take it off, leave it where it let go, and land it again from there.
TEST(AdhesiveContact, ThatForcesMoveLosesInJumpsWhatTheSliderDoesNotGetBack) {
  OneCell cell(0.5 * range / most);
  StepperOptions options;
  options.heaviest_force = 2 * most;
  std::vector<std::array<double, 2>> points; // height and force
  MotionStepper stepper(
      cell.contact, options, [&](const StepPoint& point, const SlidingContact& at) {
        points.push_back({point.height, at.in_contact() ? at.state().force[0] : 0.0});
      });
  const std::array<double, 6> forces{0, 2 * most, -2 * most, -0.5 * most, 0, most};
  for (std::size_t i = 1; i < forces.size(); ++i) {
    stepper.follow({Phase::slide, static_cast<double>(i), 1, centre, centre,
                    SliderLevel{true, forces[i - 1]}, SliderLevel{true, forces[i]}});
  }
  double did = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_LT(points[i][0], range) << "point " << i;
    EXPECT_GT(points[i][0], -2 * range) << "point " << i;
    did += 0.5 * (points[i][1] + points[i - 1][1]) * (points[i - 1][0] - points[i][0]);
  }
  EXPECT_TRUE(cell.contact.in_contact());
  EXPECT_NEAR(stepper.adhesion_loss(), did - cell.contact.energy(), 1e-9 * adhesion_work * area);
}

Case adhesive_case() {
  Case input = small_case();
  input.contact.law = "adhesive";
  input.contact.parameters = {{"work_of_adhesion", 0.2}, {"cohesive_strength", 1e6}};
  return input;
}

TEST(AdhesiveContact, PullsOnTheWayUpAndGivesTheSameBitsWithMoreThreads) {
  const Case input = adhesive_case();
  base::Timers timers;
  const ContactSolution one = solve_contact(input, {.threads = 1}, timers);
  const ContactSolution two = solve_contact(input, {.threads = 2}, timers);
  ASSERT_EQ(one.stepped.size(), two.stepped.size());
  double pull = 0, height = 0;
  for (std::size_t i = 0; i < one.stepped.size(); ++i) {
    ASSERT_EQ(!one.stepped[i].state, !two.stepped[i].state);
    if (one.stepped[i].state) {
      EXPECT_EQ(one.stepped[i].state->normal_traction, two.stepped[i].state->normal_traction);
      pull = std::max(pull, -one.stepped[i].state->normal_force);
      height = std::max(height, one.stepped[i].height);
    }
  }
  EXPECT_GT(pull, 0);
  EXPECT_GT(height, 0) << "held above the height at which it landed";
  EXPECT_FALSE(one.stepped.back().state);
  EXPECT_EQ(one.adhesion_loss, two.adhesion_loss);
  EXPECT_LT(one.worst_complementarity_residual, 1e-6);
}

} // namespace
} // namespace ionskin::mechanics
