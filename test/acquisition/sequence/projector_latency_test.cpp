#include "sequence_rig.h"

#include <pcl/acquisition/projector_latency.h>
#include <pcl/core/camera_exception.h>

namespace pcl::acmap::test {
namespace {

/** A room with daylight, of which the projector lights a part. */
class ProjectorLatency : public SequenceRig {
protected:
  void
  setRoom(Milliseconds latency, Milliseconds fade = Milliseconds(0))
  {
    setLight(latency, fade);
    camera_->room = 120;
    camera_->noise = 3;
    camera_->lit_rows = 5;
    camera_->delay = Milliseconds(5);
    camera_->exposure = Milliseconds(20);
    camera_->row_time = Milliseconds(0.5);
  }

  std::optional<double>
  measure()
  {
    return measureSettleTime(camera_, lamp_, flatImage(60));
  }
};

TEST_F(ProjectorLatency, IsFoundInDaylight)
{
  setRoom(Milliseconds(60), Milliseconds(20));
  const auto begin = Clock::now();
  const auto found = measure();
  EXPECT_LE(Clock::now() - begin, std::chrono::seconds(20));
  ASSERT_TRUE(found);
  EXPECT_GE(*found, 0.06);
  EXPECT_LE(*found, 0.5);
  expectAtRest();

  camera_->noise = 0; // to distinguish mixed frames from others
  camera_->room = 0;
  camera_->lit_rows = ShutterCamera::height;
  const auto grabber = open(4);
  grabber->setSettleTime(*found);
  grabber->observe();
  grabber->wait();
  EXPECT_EQ(frames().size(), 5U);
  for (const TrinocularFrame::ConstPtr& frame : frames())
    EXPECT_TRUE(showsOnly(*frame, levelOf(frame->pattern))) << frame->pattern;
}

TEST_F(ProjectorLatency, IsNothingWhereNoChangeIsSeen)
{
  setRoom(Milliseconds(10));
  lamp_->power = 0;
  EXPECT_FALSE(measure());
  expectAtRest();
  camera_->noise = 0;
  camera_->room = 0;
  EXPECT_FALSE(measure()) << "lens cap";
}

TEST_F(ProjectorLatency, IsNothingWhereTheRoomChangesAsMuch)
{
  setRoom(Milliseconds(10));
  lamp_->power = 0.2;
  Random random(5);
  camera_->on_shot = [&] { camera_->room = random.uniform(60, 180); };
  EXPECT_FALSE(measure());
}

TEST_F(ProjectorLatency, FaultsAreToldAndLeaveTheProjectorDark)
{
  setRoom(Milliseconds(0));
  camera_->on_shot = [&] {
    if (camera_->triggers() == 3)
      throw CameraException(CameraFault::Unplugged, "the camera is gone");
  };
  EXPECT_THROW(measure(), CameraException);
  expectAtRest();
  lamp_->before = [](int level) {
    if (level > 0)
      throw IOException("the display is gone");
  };
  EXPECT_THROW(measure(), IOException);
  expectAtRest();
  EXPECT_THROW(measureSettleTime(nullptr, lamp_, flatImage(60)), BadArgumentException);
  EXPECT_THROW(measureSettleTime(camera_, nullptr, flatImage(60)),
               BadArgumentException);
}

} // namespace
} // namespace pcl::acmap::test
