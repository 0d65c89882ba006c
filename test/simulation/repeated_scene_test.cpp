#include <pcl/core/exceptions.h>
#include <pcl/simulation/ray_casting.h>
#include <pcl/simulation/repeated_scene.h>
#include <pcl/simulation/standard_scenes.h>

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

class Repeated : public testing::Test {
protected:
  const SimulatedScene one_ = standardScene("office");
  const SimulatedScene all_ = repeatedScene(one_, 3, 2);
};

TEST_F(Repeated, HasEachViewAndPlaneSixTimes)
{
  EXPECT_EQ(all_.views.size(), 6 * one_.views.size());
  EXPECT_EQ(all_.geometry.planes().size(), 6 * one_.geometry.planes().size());
  EXPECT_EQ(all_.geometry.surfaces().size(), 6 * one_.geometry.surfaces().size());
  EXPECT_EQ(all_.geometry.planes()[0].name, one_.geometry.planes()[0].name);
  EXPECT_EQ(all_.geometry.planes().back().name,
            one_.geometry.planes().back().name + " (2, 1)");
}

/** What is seen from a view of the last copy is what is seen from it in the scene. */
TEST_F(Repeated, LooksTheSameFromEachCopy)
{
  const std::size_t planes = one_.geometry.planes().size();
  const SurfaceImage seen = castView(one_.geometry, one_.rig, one_.views[0]);
  const SurfaceImage again =
      castView(all_.geometry, all_.rig, all_.views[5 * one_.views.size()]);
  std::size_t differing = 0;
  for (std::size_t i = 0; i < seen.surface.size(); i += 101) {
    if (seen.surface[i] < 0)
      continue;
    const auto& surfaces = one_.geometry.surfaces();
    const std::int32_t plane =
        surfaces[static_cast<std::size_t>(seen.surface[i])].plane;
    const std::int32_t moved =
        all_.geometry.surfaces()[static_cast<std::size_t>(again.surface[i])].plane;
    differing += plane >= 0 && moved != plane + static_cast<std::int32_t>(5 * planes);
    EXPECT_NEAR(again.distance[i], seen.distance[i], 1e-6);
  }
  EXPECT_EQ(differing, 0u);
}

TEST_F(Repeated, PlanesAreMovedWithTheirRectangles)
{
  for (const TruthPlane& plane : all_.geometry.planes())
    for (const SimulatedRectangle& rectangle : plane.rectangles)
      EXPECT_NEAR(plane.coefficients.head<3>().dot(rectangle.corner) +
                      plane.coefficients[3],
                  0,
                  1e-5)
          << plane.name;
}

/** The view of a copy shows the same, with other noise and with the planes of its copy. */
TEST_F(Repeated, IsObservedFromTheSceneAlone)
{
  const std::size_t copy = 4;
  const SimulatedObservation first = observeRepeated(one_, 0, 7);
  const SimulatedObservation again = observeRepeated(one_, copy * one_.views.size(), 7);
  EXPECT_GT(first.points, 1000u);
  std::size_t labelled = 0, equal_depths = 0;
  for (std::size_t i = 0; i < first.pixels.size(); ++i) {
    const ObservationPixel& a = first.pixels[i];
    const ObservationPixel& b = again.pixels[i];
    if (a.label == 0 || b.label == 0)
      continue;
    ++labelled;
    equal_depths += a.z == b.z;
    EXPECT_EQ(b.label, a.label + copy * one_.geometry.planes().size());
  }
  EXPECT_GT(labelled, 1000u);
  EXPECT_LT(equal_depths, labelled / 10);
}

TEST_F(Repeated, NeedsAtLeastOne)
{
  EXPECT_THROW(repeatedScene(one_, 0, 2), BadArgumentException);
  EXPECT_THROW(repeatedScene(one_, 2, 0), BadArgumentException);
  EXPECT_EQ(repeatedScene(one_, 1, 1).views.size(), one_.views.size());
}

} // namespace
} // namespace pcl::acmap::test
