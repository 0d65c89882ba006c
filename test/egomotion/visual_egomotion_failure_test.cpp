#include "room_views.h"

#include <pcl/core/random.h>
#include <pcl/egomotion/visual_egomotion.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

namespace pcl::acmap::test {

namespace {

using Egomotion = VisualEgomotion<PointXYZRGBSigma>;
using Cloud = PointCloud<PointXYZRGBSigma>;

/** \brief A room with custom grey levels. */
Room
roomOf(std::function<double(const Eigen::Vector3d&, const Eigen::Vector2d&)> brightness)
{
  Room room;
  room.brightness = std::move(brightness);
  return room;
}

Cloud::Ptr
withoutPoints(const Cloud& view)
{
  Cloud::Ptr blind(new Cloud(view));
  for (PointXYZRGBSigma& point : *blind)
    point.getVector3fMap().setConstant(std::numeric_limits<float>::quiet_NaN());
  return blind;
}

std::optional<EgomotionEstimate>
estimateOf(Egomotion& egomotion,
           const Cloud::ConstPtr& source,
           const Cloud::ConstPtr& target)
{
  egomotion.setInputSource(source);
  egomotion.setInputTarget(target);
  const auto estimate = egomotion.compute();
  const EgomotionReport& report = egomotion.getReport();
  EXPECT_EQ(estimate.has_value(), report.outcome == EgomotionOutcome::Estimated);
  EXPECT_EQ(report.reason.empty(), estimate.has_value());
  return estimate;
}

EgomotionOutcome
outcomeOf(Egomotion& egomotion,
          const Cloud::ConstPtr& source,
          const Cloud::ConstPtr& target)
{
  estimateOf(egomotion, source, target);
  return egomotion.getReport().outcome;
}

EgomotionOutcome
outcomeOf(const Cloud::ConstPtr& source, const Cloud::ConstPtr& target)
{
  Egomotion egomotion;
  return outcomeOf(egomotion, source, target);
}

void
expectRight(const EgomotionEstimate& estimate,
            const Eigen::Isometry3d& T_before_now = before.inverse() * now)
{
  const Eigen::Matrix<double, 6, 1> error =
      motionBetween(T_before_now, estimate.T_target_source);
  for (const int i : {0, 2, 4})
    EXPECT_LT(std::abs(error[i]), 4 * std::sqrt(estimate.covariance(i, i))) << i;
}

} // namespace

TEST(VisualEgomotionFailure, blankViewsShowNothing)
{
  const auto painted = viewOf(Room(), before);
  for (const double grey : {0.0, 128.0, 255.0}) {
    const auto blank =
        viewOf(roomOf([=](const auto&, const auto&) { return grey; }), now);
    EXPECT_EQ(outcomeOf(blank, painted), EgomotionOutcome::BlankView);
    EXPECT_EQ(outcomeOf(painted, blank), EgomotionOutcome::BlankView);
  }
  const auto blind = withoutPoints(*viewOf(Room(), now));
  EXPECT_EQ(outcomeOf(blind, painted), EgomotionOutcome::BlankView);
  EXPECT_EQ(outcomeOf(painted, blind), EgomotionOutcome::BlankView);
}

TEST(VisualEgomotionFailure, blankViewsWithNoiseShowNothing)
{
  const auto noisy = [](std::uint64_t seed) {
    auto random = std::make_shared<Random>(seed);
    return roomOf([=](const auto&, const auto&) { return 100 + 3 * random->normal(); });
  };
  EXPECT_NE(outcomeOf(viewOf(noisy(1), now), viewOf(noisy(2), before)),
            EgomotionOutcome::Estimated);
}

// One textured patch on the far wall: if a motion is reported, it must be correct.
TEST(VisualEgomotionFailure, smallPatchGivesTheMotionOrNone)
{
  const SpacePaint paint(1);
  for (const double size : {0.1, 0.25, 0.5}) {
    const Room room = roomOf([=](const Eigen::Vector3d& place, const auto&) {
      const double off = (place - Eigen::Vector3d(-0.2, -0.2, 5)).norm() / size;
      return off < 1 ? 128 + (paint(place) - 128) * (1 - off * off) : 128.0;
    });
    Egomotion egomotion;
    const auto estimate =
        estimateOf(egomotion, viewOf(room, now), viewOf(room, before));
    if (estimate)
      expectRight(*estimate);
    EXPECT_EQ(estimate.has_value(), size > 0.3);
  }
}

TEST(VisualEgomotionFailure, differentPlacesAreNotMatched)
{
  for (std::uint64_t seed = 10; seed < 16; ++seed) {
    const auto outcome =
        outcomeOf(viewOf(Room(seed), now), viewOf(Room(seed + 10), before));
    EXPECT_TRUE(outcome == EgomotionOutcome::FewMatches ||
                outcome == EgomotionOutcome::Inconsistent);
  }
}

TEST(VisualEgomotionFailure, motionsBeyondTheBoundsAreNone)
{
  const auto source = viewOf(Room(), now), target = viewOf(Room(), before);
  Egomotion egomotion;
  egomotion.setMaximumTranslation(0.1);
  EXPECT_EQ(outcomeOf(egomotion, source, target), EgomotionOutcome::Inconsistent);
  EXPECT_NE(egomotion.getReport().reason.find("at most 0.1 m"), std::string::npos)
      << egomotion.getReport().reason;
  egomotion.setMaximumTranslation(1);
  EXPECT_EQ(outcomeOf(egomotion, source, target), EgomotionOutcome::Estimated);
  egomotion.setMaximumRotation(0.04);
  EXPECT_EQ(outcomeOf(egomotion, source, target), EgomotionOutcome::Inconsistent);
  EXPECT_NE(egomotion.getReport().reason.find("0.04 rad"), std::string::npos)
      << egomotion.getReport().reason;
}

// A vertical strip of texture on the far wall does not determine the rotation about it;
// the surfaces do.
TEST(VisualEgomotionFailure, featuresOnALineLeaveATurnOpen)
{
  const SpacePaint paint(1);
  const Room room = roomOf([=](const Eigen::Vector3d& place, const auto&) {
    const double off = (place.x() + 0.2) / 0.06;
    return place.z() > 4.99 && std::abs(off) < 1
               ? 128 + (paint(place) - 128) * (1 - off * off)
               : 128.0;
  });
  const auto source = viewOf(room, now), target = viewOf(room, before);
  Egomotion egomotion;
  egomotion.setRefinement(false);
  EXPECT_EQ(outcomeOf(egomotion, source, target), EgomotionOutcome::Unobservable);
  egomotion.setRefinement(true);
  const auto estimate = estimateOf(egomotion, source, target);
  ASSERT_TRUE(estimate);
  expectRight(*estimate);
}

// The colours should be those of a shot without a pattern. If they are not, and the
// walls have little texture, the surfaces contradict features that move with the
// camera.
TEST(VisualEgomotionFailure, lightThatMovesWithTheCameraIsDenied)
{
  const SpacePaint pattern(4);
  for (const double contrast : {0.0, 5.0}) {
    const SpacePaint paint(1, contrast);
    const Room room =
        roomOf([=](const Eigen::Vector3d& place, const Eigen::Vector2d& pixel) {
          return paint(place) + pattern({pixel.x() / 100, pixel.y() / 100, 0}) - 128;
        });
    Egomotion egomotion;
    EXPECT_EQ(outcomeOf(egomotion, viewOf(room, now), viewOf(room, before)),
              EgomotionOutcome::Inconsistent);
    EXPECT_NE(egomotion.getReport().reason.find("surfaces"), std::string::npos)
        << egomotion.getReport().reason;
  }
}

// Views of an infinite pattern repeat with its period: no method can distinguish them.
TEST(VisualEgomotionFailure, wallpaperThatRepeatsIsRightUpToItsPeriod)
{
  int told = 0;
  for (const double period : {0.2, 0.3, 0.4, 0.6}) {
    Room room = roomOf([=](const Eigen::Vector3d& place, const auto&) {
      const Eigen::Vector3d phase = 6.283185307 / period * place;
      return 128 + 40 * std::sin(phase.x()) * std::sin(phase.y());
    });
    room.walls = Box(Eigen::Vector3d(-50, -50, -1), Eigen::Vector3d(50, 50, 2.5));
    room.things.clear();
    for (const double part : {0.1, 0.3, 0.5, 1.3}) {
      const auto away = viewOf(room, poseOf({part * period, 0, 0}, 0));
      Egomotion egomotion;
      const auto estimate =
          estimateOf(egomotion, away, viewOf(room, Eigen::Isometry3d::Identity()));
      if (estimate) {
        const double error = estimate->action.dx / period - part;
        EXPECT_NEAR(error, std::round(error), 0.01) << period << " " << part;
        ++told;
      }
    }
  }
  EXPECT_GE(told, 2) << "of 16";
}

} // namespace pcl::acmap::test
