#include <pcl/simulation/simulated_observation.h>
#include <pcl/simulation/standard_scenes.h>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

TEST(CorridorCount, IsThatOfThePaper)
{
  const SimulatedScene scene = standardScene("corridor");
  std::size_t points = 0;
  for (std::size_t view = 0; view < scene.views.size(); ++view) {
    const SimulatedObservation observation = observe(scene, view, 1);
    std::size_t finite = 0;
    for (const ObservationPixel& pixel : observation.pixels)
      finite += std::isfinite(pixel.x) ? 1 : 0;
    EXPECT_EQ(finite, view < 15 ? 138654u : 138653u) << view;
    points += finite;
  }
  EXPECT_EQ(points, 14697233u);
}

} // namespace
} // namespace pcl::acmap::test
