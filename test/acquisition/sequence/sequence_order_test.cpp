#include "sequence_rig.h"

#include <gmock/gmock.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using SequenceOrder = SequenceRig;

TEST_F(SequenceOrder, TheOffShotComesFirstThenEachPattern)
{
  std::thread::id thread;
  std::thread::id camera_thread;
  camera_->on_shot = [&] { camera_thread = std::this_thread::get_id(); };
  std::vector<std::uint64_t> stamps;
  const std::function<TrinocularGrabber::FrameCallback> note =
      [&](const TrinocularFrame::ConstPtr& frame) { stamps.push_back(frame->stamp); };
  camera_->registerCallback(note);
  const auto grabber =
      open(3, [&](const auto&) { thread = std::this_thread::get_id(); });
  EXPECT_EQ(grabber->getName(), "PatternSequenceGrabber");
  EXPECT_EQ(grabber->getFramesPerSecond(), 0.0F);
  EXPECT_EQ(grabber->getRig().width, ShutterCamera::width);
  EXPECT_FALSE(grabber->isRunning());
  grabber->observe();
  grabber->wait();
  EXPECT_FALSE(grabber->isRunning());
  EXPECT_EQ(errorOf(*grabber), "");
  EXPECT_EQ(shots(), "0.off 0.0 0.1 0.2");
  for (std::size_t i = 0; i < frames().size(); ++i) {
    const TrinocularFrame& frame = *frames()[i];
    EXPECT_EQ(frame.number, i);
    EXPECT_EQ(frame.stamp, stamps.at(i));
    EXPECT_TRUE(showsOnly(frame, levelOf(frame.pattern))) << i;
  }
  EXPECT_THAT(lamp_->shown(), ElementsAre(0, 40, 80, 120, 0));
  EXPECT_NE(thread, std::this_thread::get_id());
  EXPECT_NE(thread, camera_thread);
  const PatternSequenceGrabberReport report = grabber->getReport();
  EXPECT_EQ(report.shots, 4U);
  EXPECT_EQ(report.observations, 1U);
  EXPECT_EQ(report.spared, 0U);
  EXPECT_THAT(report.remarks, ElementsAre());
}

TEST_F(SequenceOrder, ObservationsAskedForComeOneAfterAnother)
{
  const auto grabber = open(2);
  grabber->observe();
  grabber->observe();
  grabber->wait();
  EXPECT_EQ(shots(), "0.off 0.0 0.1 1.off 1.0 1.1");
  EXPECT_EQ(frames().back()->number, 5U);
  EXPECT_EQ(grabber->getReport().observations, 2U);
  grabber->observe();
  grabber->wait();
  EXPECT_EQ(frames().size(), 9U);
  EXPECT_EQ(frames().back()->number, 8U);
  EXPECT_EQ(frames().back()->observation, 2);
  EXPECT_EQ(grabber->getReport().observations, 1U) << "of the last stream";
  expectAtRest();
}

TEST_F(SequenceOrder, StreamsUntilItIsStopped)
{
  const auto grabber = open(1);
  grabber->start();
  grabber->start();   // is already running
  grabber->observe(); // is already running, too
  grabber->trigger();
  waitForFrames(7);
  EXPECT_TRUE(grabber->isRunning());
  grabber->stop();
  EXPECT_FALSE(grabber->isRunning());
  EXPECT_EQ(shots().substr(0, 35), "0.off 0.0 1.off 1.0 2.off 2.0 3.off");
  const Frames given = frames();
  for (std::size_t i = 0; i < given.size(); ++i) {
    EXPECT_EQ(given[i]->number, i);
    EXPECT_TRUE(showsOnly(*given[i], levelOf(given[i]->pattern))) << i;
  }
  expectAtRest();
}

TEST_F(SequenceOrder, TriggersTakeOneShotEach)
{
  const auto grabber = open(1);
  grabber->trigger();
  grabber->wait();
  EXPECT_EQ(shots(), "0.off");
  expectAtRest();
  grabber->trigger();
  grabber->wait();
  EXPECT_EQ(shots(), "0.off 0.0");
  EXPECT_EQ(grabber->getReport().observations, 1U);
  EXPECT_THAT(lamp_->shown(), ElementsAre(0, 0, 40, 0));
  for (int i = 0; i < 3; ++i)
    grabber->trigger();
  grabber->wait();
  EXPECT_EQ(shots(), "0.off 0.0 1.off 1.0 2.off");
  grabber->observe(); // the rest of the observation
  grabber->wait();
  EXPECT_EQ(shots(), "0.off 0.0 1.off 1.0 2.off 2.0");
}

TEST_F(SequenceOrder, WhatIsStoppedIsCutOff)
{
  PatternSequenceGrabber* self = nullptr;
  const auto grabber = open(3, [&](const TrinocularFrame& frame) {
    if (frame.observation == 1 && frame.pattern == 1)
      self->stop();
  });
  self = grabber.get();
  grabber->start();
  grabber->wait();
  EXPECT_EQ(shots(), "0.off 0.0 0.1 0.2 1.off 1.0 1.1");
  EXPECT_THAT(grabber->getReport().remarks,
              ElementsAre("observation 1 was cut off after 3 of its 4 shots"));
  EXPECT_EQ(grabber->getReport().observations, 1U);
  expectAtRest();
  grabber->trigger();
  grabber->wait();
  EXPECT_EQ(frames().back()->observation, 2);
  EXPECT_EQ(frames().back()->number, 7U);
  grabber->stop(); // while idle, within observation 2
  grabber->stop();
  grabber->trigger();
  grabber->wait();
  EXPECT_EQ(frames().back()->observation, 3);
  EXPECT_EQ(frames().back()->pattern, TrinocularFrame::no_pattern);
}

TEST_F(SequenceOrder, NothingIsCutOffByAStopAfterTheLastShot)
{
  PatternSequenceGrabber* self = nullptr;
  const auto grabber = open(1, [&](const TrinocularFrame& frame) {
    if (frame.pattern == 0)
      self->stop();
  });
  self = grabber.get();
  for (int observation = 0; observation < 2; ++observation) {
    grabber->start();
    grabber->wait();
    EXPECT_EQ(grabber->getReport().observations, 1U);
    EXPECT_THAT(grabber->getReport().remarks, ElementsAre());
  }
  EXPECT_EQ(shots(), "0.off 0.0 1.off 1.0");
}

TEST_F(SequenceOrder, RewindBeginsAgain)
{
  PatternSequenceGrabber* self = nullptr;
  const auto grabber = open(2, [&](const TrinocularFrame& frame) {
    if (frame.number == 4)
      self->rewind();
  });
  self = grabber.get();
  grabber->observe();
  grabber->wait();
  grabber->rewind();
  grabber->trigger();
  grabber->wait();
  EXPECT_EQ(frames().back()->number, 0U);
  EXPECT_EQ(shots(), "0.off 0.0 0.1 0.off");
  grabber->observe();
  grabber->observe(); // interrupted by rewind; a complete one is delivered nevertheless
  grabber->wait();
  EXPECT_EQ(shots(), "0.off 0.0 0.1 0.off 0.0 0.1 1.off 1.0 0.off 0.0 0.1");
  EXPECT_EQ(errorOf(*grabber), "");
}

TEST_F(SequenceOrder, EndsEarlyWhenNoMoreIsWanted)
{
  std::vector<int> asked;
  std::size_t given = 0;
  const auto grabber = open(4, [&](const auto&) { ++given; });
  grabber->setWantMore([&](const TrinocularFrame& frame) {
    EXPECT_EQ(given, frames().size()) << "after the callbacks";
    EXPECT_EQ(frame.number, frames().back()->number);
    asked.push_back(frame.pattern);
    return frame.observation != 1 || frame.pattern < 1;
  });
  for (int i = 0; i < 3; ++i)
    grabber->observe();
  grabber->wait();
  EXPECT_EQ(shots(), "0.off 0.0 0.1 0.2 0.3 1.off 1.0 1.1 2.off 2.0 2.1 2.2 2.3");
  EXPECT_THAT(asked, ElementsAre(0, 1, 2, 0, 1, 0, 1, 2));
  EXPECT_EQ(frames().back()->number, 12U);
  EXPECT_EQ(grabber->getReport().spared, 2U);
  EXPECT_EQ(grabber->getReport().observations, 3U);
  grabber->setWantMore([](const auto&) { return false; });
  for (int i = 0; i < 3; ++i)
    grabber->trigger(); // each gives a shot, even if others are spared
  grabber->wait();
  EXPECT_EQ(shots().substr(shots().size() - 15), "3.off 3.0 4.off");
  EXPECT_EQ(grabber->getReport().spared, 3U);
  grabber->setWantMore({});
  grabber->observe();
  grabber->wait();
  EXPECT_EQ(frames().back()->pattern, 3);
}

TEST_F(SequenceOrder, WithoutPatternsThereAreOffShots)
{
  const auto grabber = open(0);
  grabber->setWantMore([](const auto&) -> bool { throw std::logic_error("asked"); });
  grabber->observe();
  grabber->observe();
  grabber->wait();
  EXPECT_EQ(errorOf(*grabber), "");
  EXPECT_EQ(shots(), "0.off 1.off");
  EXPECT_EQ(grabber->getReport().observations, 2U);
}

TEST_F(SequenceOrder, RefusesWhatCannotBe)
{
  const auto make = [&](const std::vector<RgbImage>& patterns) {
    PatternSequenceGrabber(camera_, lamp_, patterns);
  };
  EXPECT_NO_THROW(make(levelPatterns(2)));
  std::vector<RgbImage> patterns = levelPatterns(2);
  patterns[1].values.pop_back();
  EXPECT_THAT([&] { make(patterns); },
              testing::ThrowsMessage<BadArgumentException>(
                  HasSubstr("pattern 1 of 4 x 2 pixels has 23 values")));
  EXPECT_THROW(make({{}}), BadArgumentException);
  EXPECT_THROW(make({{-4, -2, std::vector<std::uint8_t>(24)}}), BadArgumentException);
  EXPECT_THROW(PatternSequenceGrabber(nullptr, lamp_, {}), BadArgumentException);
  EXPECT_THROW(PatternSequenceGrabber(camera_, nullptr, {}), BadArgumentException);
  PatternSequenceGrabber grabber(camera_, lamp_, {});
  EXPECT_EQ(grabber.getSettleTime(), 0.1);
  EXPECT_EQ(grabber.getShotTimeout(), 5.0);
  for (const double wrong : {-0.1, 10.1, double(NAN), double(INFINITY)})
    EXPECT_THROW(grabber.setSettleTime(wrong), BadArgumentException) << wrong;
  for (const double wrong : {0.0, 601.0, double(NAN), double(INFINITY)})
    EXPECT_THROW(grabber.setShotTimeout(wrong), BadArgumentException) << wrong;
  grabber.setSettleTime(0.25);
  grabber.setShotTimeout(2.5);
  EXPECT_EQ(grabber.getSettleTime(), 0.25);
  EXPECT_EQ(grabber.getShotTimeout(), 2.5);
}

} // namespace
} // namespace pcl::acmap::test
