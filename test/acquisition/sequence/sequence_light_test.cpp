#include "sequence_rig.h"

namespace pcl::acmap::test {
namespace {

/** A projector with latency, and a camera with a long exposure. */
class SequenceLight : public SequenceRig {
protected:
  static constexpr Milliseconds latency{25};

  SequenceLight()
  {
    setLight(latency);
    camera_->exposure = Milliseconds(12);
    camera_->row_time = Milliseconds(1.5);
  }

  int
  countMixed() const
  {
    int mixed = 0;
    for (const TrinocularFrame::ConstPtr& frame : frames())
      mixed += showsOnly(*frame, levelOf(frame->pattern)) ? 0 : 1;
    return mixed;
  }
};

TEST_F(SequenceLight, NoFrameMixesWhenTheLightHasSettled)
{
  const auto grabber = open(5);
  grabber->setSettleTime(latency / std::chrono::seconds(1));
  grabber->observe();
  grabber->observe();
  grabber->wait();
  EXPECT_EQ(frames().size(), 12U);
  EXPECT_EQ(countMixed(), 0);
  EXPECT_EQ(errorOf(*grabber), "");
}

TEST_F(SequenceLight, FramesMixWithoutSettling)
{
  const auto grabber = open(5);
  grabber->setSettleTime(0);
  grabber->observe();
  grabber->observe();
  grabber->wait();
  EXPECT_EQ(frames().size(), 12U);
  EXPECT_GE(countMixed(), 1) << "else the test above tells nothing";
}

} // namespace
} // namespace pcl::acmap::test
