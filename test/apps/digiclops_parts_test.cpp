#include "digiclops_grabber/digiclops_camera.h"
#include "grabber/terminal.h"

#include <pcl/core/exceptions.h>

#include <gtest/gtest.h>

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <thread>

namespace pcl::acmap::test {
namespace {

using std::chrono::milliseconds;

/** \brief Simulates a user who types on a terminal that replaces standard input. */
class TypingUser {
public:
  TypingUser()
  : keys_(posix_openpt(O_RDWR | O_NOCTTY))
  , before_(dup(STDIN_FILENO))
  {
    grantpt(keys_);
    unlockpt(keys_);
    const int terminal = open(ptsname(keys_), O_RDWR | O_NOCTTY);
    dup2(terminal, STDIN_FILENO);
    close(terminal);
  }

  ~TypingUser()
  {
    dup2(before_, STDIN_FILENO);
    close(before_);
    close(keys_);
  }

  void
  type(const std::string& keys) const
  {
    ASSERT_EQ(write(keys_, keys.data(), keys.size()),
              static_cast<ssize_t>(keys.size()));
  }

private:
  int keys_;
  int before_;
};

TEST(Pacing, EnterBeginsTheNextObservationOnATerminal)
{
  const TypingUser user;
  Pacing pacing(std::nullopt);
  ASSERT_TRUE(pacing.asks());
  int looks = 0;
  EXPECT_TRUE(pacing.wait([&] {
    if (++looks == 3)
      user.type("\n");
  }));
  EXPECT_GE(looks, 3);
  user.type("q\n");
  EXPECT_FALSE(pacing.wait([] {}));
  user.type("\x04"); // Ctrl-D, end of input
  EXPECT_FALSE(pacing.wait([] {}));
  EXPECT_THROW(pacing.wait([] { throw CancelledException("interrupted"); }),
               CancelledException);
}

TEST(Pacing, AClockDoesNotAsk)
{
  const TypingUser user;
  Pacing pacing(0.2);
  EXPECT_FALSE(pacing.asks());
  const auto begin = std::chrono::steady_clock::now();
  pacing.begin();
  EXPECT_TRUE(pacing.wait([] {}));
  EXPECT_GE(std::chrono::steady_clock::now() - begin, milliseconds(200));
}

TEST(GrabStatus, TellsWhatIsKnown)
{
  GrabStatus status;
  status.frames = 12;
  EXPECT_EQ(statusText(status), "frames 12, lost 0, broken 0");
  status.frames_per_second = 13.96;
  status.lost = 2;
  status.written = 774000000;
  status.free = 52300000000;
  status.doing = "observation 2, shot 5";
  EXPECT_EQ(statusText(status),
            "observation 2, shot 5: 14.0 fps, frames 12, lost 2, broken 0, "
            "written 774 MB, free 52.3 GB");
}

TEST(ChannelOrderOption, IsReadFromLettersOrWords)
{
  using Order = ChannelOrder;
  EXPECT_FALSE(channelOrderOf("auto"));
  EXPECT_EQ(channelOrderOf("v,r,h"),
            (Order{RigCamera::Vertical, RigCamera::Reference, RigCamera::Horizontal}));
  EXPECT_EQ(channelOrderOf("reference,vertical,horizontal"),
            (Order{RigCamera::Reference, RigCamera::Vertical, RigCamera::Horizontal}));
  EXPECT_THROW(channelOrderOf("r,h,r"), UsageError);
  EXPECT_THROW(channelOrderOf(""), UsageError);
}

} // namespace
} // namespace pcl::acmap::test
