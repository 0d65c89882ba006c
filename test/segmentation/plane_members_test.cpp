#include "labeling/plane_members.h"

#include <pcl/core/random.h>

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

TEST(PlaneMembers, areAllPointsOfEachPlaneInTheirOrder)
{
  Random random(3);
  for (const std::size_t size : {0, 1, 1000, 300000}) {
    constexpr std::size_t planes = 9; // the last one has no points
    std::vector<std::int32_t> labels;
    for (std::size_t i = 0; i < size; ++i)
      labels.push_back(static_cast<std::int32_t>(random.uniform(0, planes)) - 1);
    std::vector<std::vector<std::uint32_t>> expected(planes), found(planes);
    for (std::size_t i = 0; i < size; ++i)
      if (labels[i] >= 0)
        expected[static_cast<std::size_t>(labels[i])].push_back(
            static_cast<std::uint32_t>(i));
    std::vector<int> visits(planes, 0);
    labeling::PlaneMembers(labels.data(), labels.size(), planes)
        .forEachPlane([&](std::size_t plane, labeling::PlaneMembers::Range members) {
          ++visits[plane];
          for (const std::uint32_t i : members)
            found[plane].push_back(i);
        });
    EXPECT_EQ(found, expected);
    EXPECT_EQ(visits, std::vector<int>(planes, 1));
  }
}

} // namespace
} // namespace pcl::acmap::test
