#include <pcl/core/exceptions.h>
#include <pcl/core/interruption.h>

#include <gtest/gtest.h>

#include <csignal>

namespace pcl::acmap::test {
namespace {

TEST(Interruptions, AreNotedOnceUntilTheyAreForgotten)
{
  noteInterruptions();
  EXPECT_FALSE(interrupted());
  EXPECT_NO_THROW(stopIfInterrupted());
  std::raise(SIGTERM);
  EXPECT_TRUE(interrupted());
  EXPECT_THROW(stopIfInterrupted(), CancelledException);
  forgetInterruption();
  EXPECT_FALSE(interrupted());
  std::raise(SIGTERM); // noted again
  EXPECT_TRUE(interrupted());
  forgetInterruption();
  obeyInterruptions();
}

TEST(Interruptions, ASecondOneEndsTheProcess)
{
  EXPECT_EXIT(
      {
        noteInterruptions();
        std::raise(SIGINT);
        std::raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT),
      "");
  EXPECT_EXIT(
      {
        noteInterruptions();
        obeyInterruptions();
        std::raise(SIGTERM);
      },
      testing::KilledBySignal(SIGTERM),
      "");
}

TEST(Interruptions, IgnoredSignalsStayIgnored)
{
  std::signal(SIGHUP, SIG_IGN);
  noteInterruptions();
  std::raise(SIGHUP);
  EXPECT_FALSE(interrupted());
  obeyInterruptions();
  std::signal(SIGHUP, SIG_DFL);
}

} // namespace
} // namespace pcl::acmap::test
