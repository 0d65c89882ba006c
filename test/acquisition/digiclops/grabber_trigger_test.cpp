#include "grabber_fixture.h"

#include <thread>

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;

class GrabberTrigger : public DigiclopsTest {
protected:
  /** Triggers shots one after another; each must be exposed after its request. */
  void
  expectFreshShots(int shots)
  {
    for (int i = 0; i < shots; ++i) {
      const auto asked = Clock::now();
      grabber_->trigger();
      requireEnd([&] { grabber_->wait(); });
      const auto frames = log_->frames();
      ASSERT_EQ(frames.size(), static_cast<std::size_t>(i + 1));
      const std::uint64_t sent = numberOf(*frames.back(), images_);
      EXPECT_GE(images_.exposureOf(sent).begin, asked) << i;
      EXPECT_EQ(frames.back()->number, static_cast<std::uint64_t>(i));
    }
    EXPECT_EQ(grabber_->getError(), nullptr);
  }
};

TEST_F(GrabberTrigger, ShotsAreExposedAfterTheyWereAskedFor)
{
  open();
  ASSERT_TRUE(grabber_->camera().hasOneShot());
  expectFreshShots(6);
  EXPECT_EQ(grabber_->getReport().early, 0U);
}

TEST_F(GrabberTrigger, WithoutOneShotTheFramesOnTheWayAreLeftOut)
{
  emulated_.faults().overrideRegister(iidc::basic_functions, iidc::on);
  open();
  ASSERT_FALSE(grabber_->camera().hasOneShot());
  expectFreshShots(4);
  EXPECT_GE(grabber_->getReport().early, 8U);
}

TEST_F(GrabberTrigger, ManyAtOnceAreAsManyShots)
{
  open();
  for (int i = 0; i < 4; ++i)
    grabber_->trigger();
  requireEnd([&] { grabber_->wait(); });
  EXPECT_EQ(log_->frames().size(), 4U);
  sentNumbers();
}

TEST_F(GrabberTrigger, InACallbackAsksForTheNext)
{
  open();
  log_->on_frame = [&] {
    if (log_->frames().size() < 4)
      grabber_->trigger();
  };
  grabber_->trigger();
  EXPECT_TRUE(log_->awaitFrames(4));
  requireEnd([&] { grabber_->wait(); });
  EXPECT_EQ(log_->frames().size(), 4U);
}

TEST_F(GrabberTrigger, WhileItStreamsThereIsNone)
{
  open();
  startFor(2);
  grabber_->trigger();
  EXPECT_TRUE(log_->awaitFrames(6));
  grabber_->stop();
  const auto frames = log_->frames();
  for (std::size_t i = 0; i < frames.size(); ++i)
    EXPECT_EQ(frames[i]->number, i);
  std::this_thread::sleep_for(150ms);
  EXPECT_EQ(log_->frames().size(), frames.size());
}

TEST_F(GrabberTrigger, AStreamGoesOnFromASingleShot)
{
  open();
  grabber_->trigger();
  startFor(4);
  grabber_->stop();
  grabber_->trigger();
  requireEnd([&] { grabber_->wait(); });
  const auto frames = log_->frames();
  for (std::size_t i = 0; i < frames.size(); ++i)
    EXPECT_EQ(frames[i]->number, i);
  sentNumbers();
}

TEST_F(GrabberTrigger, ABrokenShotIsTakenAgain)
{
  open();
  emulated_.faults().failFrame(FrameFault::Short, 0);
  emulated_.faults().failFrame(FrameFault::Short, 1);
  grabber_->trigger();
  requireEnd([&] { grabber_->wait(); });
  EXPECT_THAT(sentNumbers(), ElementsAre(2));
  EXPECT_EQ(grabber_->getReport().broken, 2U);
}

TEST_F(GrabberTrigger, SilenceIsAnErrorInTheEnd)
{
  open();
  emulated_.faults().setSilent(true);
  grabber_->trigger();
  requireEnd([&] { grabber_->wait(); });
  EXPECT_THAT(log_->errors(), ElementsAre(CameraFault::Silent));
  EXPECT_EQ(grabber_->getReport().restarts, 2U);
  emulated_.faults().heal();
  expectFreshShots(2);
}

TEST_F(GrabberTrigger, ManyBrokenShotsAreAnError)
{
  open();
  emulated_.faults().failFramesFrom(FrameFault::Short, 0);
  grabber_->trigger();
  requireEnd([&] { grabber_->wait(); });
  EXPECT_THAT(log_->errors(), ElementsAre(CameraFault::Corrupt));
  emulated_.faults().heal();
  expectFreshShots(1);
}

TEST_F(GrabberTrigger, OfACameraThatGoesIsAnError)
{
  open();
  emulated_.faults().failFrame(FrameFault::Unplug, 0);
  grabber_->trigger();
  requireEnd([&] { grabber_->wait(); });
  EXPECT_EQ(grabber_->getFault(), CameraFault::Unplugged);
  EXPECT_EQ(faultOf([&] { grabber_->trigger(); }), CameraFault::NotFound);
  cable_.plug();
  emulated_.faults().heal();
  expectFreshShots(1);
}

} // namespace
} // namespace pcl::acmap::test
