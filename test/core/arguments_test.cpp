#include <pcl/core/camera_exception.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/arguments.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace pcl::acmap::test {
namespace {

/** \brief Is the message of the exception just what was said, and is it caught as Base? */
template <typename Exception, typename Base>
void
expectPlain(const Exception& thrown)
{
  try {
    throw Exception(thrown);
  }
  catch (const Base& caught) {
    EXPECT_STREQ(caught.what(), "view.pcd: 3 of 4 points") << typeid(Exception).name();
  }
}

TEST(Exceptions, SayTheirMessageAlone)
{
  const std::string message = "view.pcd: 3 of 4 points";
  expectPlain<BadArgument, BadArgumentException>(
      BadArgument("view.pcd: ", 3, " of ", 4, " points"));
  expectPlain<InitFailed, InitFailedException>(InitFailed(message));
  expectPlain<Unorganized, UnorganizedPointCloudException>(Unorganized(message));
  expectPlain<InputFileException, IOException>(InputFileException(message));
  expectPlain<OutputFileException, IOException>(OutputFileException(message));
  expectPlain<EmptyInputException, PCLException>(EmptyInputException(message));
  expectPlain<MemoryLimitException, PCLException>(MemoryLimitException(message));
  expectPlain<CancelledException, PCLException>(CancelledException(message));
  expectPlain<CameraException, IOException>(
      CameraException(CameraFault::Busy, message));
}

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
  EXPECT_THAT([&] { requireInRange("maximum_edge_length", -0.25, 0.0, 10.0, "m"); },
              testing::ThrowsMessage<BadArgumentException>(testing::HasSubstr(
                  "maximum_edge_length = -0.25 is refused: it must be "
                  "within [0, 10] m")));
}

TEST(RequireViewpoints, refusesWhatIsNoPlace)
{
  EXPECT_NO_THROW(requireViewpoints({}));
  EXPECT_NO_THROW(requireViewpoints({{0, 0, 0}, {1e9F, -1e9F, 3}}));
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const float wrong : {std::nanf(""), infinity, -infinity, 2e9F})
    for (int axis = 0; axis < 3; ++axis) {
      Eigen::Vector3f place(1, 2, 3);
      place[axis] = wrong;
      EXPECT_THROW(requireViewpoints({{0, 0, 0}, place}), BadArgumentException);
    }
}

} // namespace
} // namespace pcl::acmap::test
