#include <pcl/core/arguments.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace pcl::acmap::test {
namespace {

TEST(RequireInRange, letsLegalValuesPass)
{
  for (const double value : {0.0, 0.5, 1.0})
    EXPECT_NO_THROW(requireInRange("overlap", value, 0.0, 1.0, ""));
}

TEST(RequireInRange, refusesOthers)
{
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double value : {-0.1, 1.1, infinity, -infinity, std::nan("")})
    EXPECT_THROW(requireInRange("overlap", value, 0.0, 1.0, ""), BadArgumentException);
  EXPECT_THROW(requireInRange("length", infinity, 0.0, infinity, "m"),
               BadArgumentException);
}

TEST(RequireInRange, namesValueRangeAndUnit)
{
  try {
    requireInRange("maximum_edge_length", -0.25, 0.0, 10.0, "m");
    FAIL() << "was accepted";
  }
  catch (const BadArgumentException& exception) {
    EXPECT_THAT(exception.what(),
                testing::HasSubstr("maximum_edge_length = -0.25 is refused: it must be "
                                   "within [0, 10] m"));
  }
}

} // namespace
} // namespace pcl::acmap::test
