// As for any class of PCL: this file instantiates the templates for the custom type.
#define PCL_NO_PRECOMPILE

#include "filtered_observations.h"

#include <pcl/register_point_struct.h>

#include <cstdint>

namespace pcl::acmap::test {

/** \brief A measurement of a laser scanner. */
struct EIGEN_ALIGN16 LaserReturn {
  PCL_ADD_POINT4D;
  std::uint32_t microseconds;
  std::uint16_t ring;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

} // namespace pcl::acmap::test

// clang-format off
POINT_CLOUD_REGISTER_POINT_STRUCT(
  pcl::acmap::test::LaserReturn,
  (float, x, x)
  (float, y, y)
  (float, z, z)
  (std::uint32_t, microseconds, microseconds)
  (std::uint16_t, ring, ring))
// clang-format on

namespace pcl::acmap::test {
namespace {

TEST(RegisteringFilter, takesAPointTypeOfAUser)
{
  expectFilterOfAllAndOfSome<LaserReturn, EntropyRectification<LaserReturn>>();
}

TEST(RegisteringFilter, keepsTheFieldsOfAUser)
{
  auto scans = posedScans<LaserReturn>();
  for (std::size_t i = 0; i < scans.size(); ++i)
    for (LaserReturn& point : *scans[i]) {
      point.ring = static_cast<std::uint16_t>(i);
      point.microseconds = static_cast<std::uint32_t>(1000 * i);
    }
  EntropyRectification<LaserReturn> rectification;
  const auto map =
      mapByFilter<EntropyRectification<LaserReturn>, LaserReturn>(rectification, scans);
  ASSERT_EQ(map.size() % scans.size(), 0U);
  const std::size_t beams = map.size() / scans.size();
  for (std::size_t p = 0; p < map.size(); ++p) {
    ASSERT_EQ(map[p].ring, p / beams);
    ASSERT_EQ(map[p].microseconds, 1000 * (p / beams));
  }
}

} // namespace
} // namespace pcl::acmap::test
