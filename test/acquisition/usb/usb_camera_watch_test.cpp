#include "usb_camera_fixture.h"

#include <gmock/gmock.h>

#include <condition_variable>
#include <mutex>
#include <thread>

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;
using News = std::vector<std::string>;
using namespace std::chrono_literals;

class UsbCameraWatching : public UsbCameraFixture {
protected:
  /** \brief Callback for a watch that records its news. */
  UsbCameraWatch::Callback
  notes()
  {
    return [this](const UsbCamera& camera, bool is_there) {
      const std::lock_guard lock(mutex_);
      news_.push_back((is_there ? "+" : "-") + camera.place);
      thread_ = std::this_thread::get_id();
      changed_.notify_all();
    };
  }

  /** \brief Waits for this number of news; returns those that have arrived after a
   * while. */
  News
  waitForNews(std::size_t count)
  {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, patience, [&] { return news_.size() >= count; });
    return news_;
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  News news_;
  std::thread::id thread_;
};

TEST_F(UsbCameraWatching, TellsOfThoseThatAreThere)
{
  EmulatedIidcCamera camera(imageOf);
  const EmulatedUsbCamera cable(testbed_, camera);
  const std::string second = "1:" + std::to_string(cable.address());
  const UsbCameraWatch watch(notes());
  EXPECT_THAT(waitForNews(2),
              testing::UnorderedElementsAre("+" + place(), "+" + second));
  EXPECT_NE(std::this_thread::get_id(), thread_);
}

TEST_F(UsbCameraWatching, TellsOfThoseThatComeAndGo)
{
  const UsbCameraWatch watch(notes());
  const std::string first = place();
  waitForNews(1);
  cable_.unplug();
  waitForNews(2);
  cable_.plug();
  EXPECT_NE(first, place());
  EXPECT_THAT(waitForNews(3), ElementsAre("+" + first, "-" + first, "+" + place()));
}

TEST_F(UsbCameraWatching, TellsNothingOfOthers)
{
  const UsbCameraWatch watch(notes());
  waitForNews(1);
  UsbIdentity other;
  other.vendor = 0x04B4;
  EmulatedIidcCamera camera(imageOf);
  {
    const EmulatedUsbCamera cable(testbed_, camera, other);
  }
  const std::string first = place();
  cable_.unplug();
  EXPECT_THAT(waitForNews(2), ElementsAre("+" + first, "-" + first));
}

TEST_F(UsbCameraWatching, LetsACallbackOpenTheCamera)
{
  std::mutex mutex;
  std::condition_variable changed;
  std::string serial;
  const UsbCameraWatch watch([&](const UsbCamera& camera, bool) {
    const auto bus = openUsbBus(camera.place);
    const std::lock_guard lock(mutex);
    serial = listUsbCameras().at(0).serial;
    changed.notify_all();
  });
  std::unique_lock lock(mutex);
  changed.wait_for(lock, patience, [&] { return !serial.empty(); });
  EXPECT_EQ("00b09d0100c0ffee", serial);
}

TEST_F(UsbCameraWatching, SwallowsWhatACallbackThrows)
{
  const auto note = notes();
  const UsbCameraWatch watch([&](const UsbCamera& camera, bool is_there) {
    note(camera, is_there);
    throw std::runtime_error("of no interest");
  });
  waitForNews(1);
  cable_.unplug();
  EXPECT_EQ(2u, waitForNews(2).size());
}

TEST_F(UsbCameraWatching, IsSilentAfterItsEnd)
{
  for (int i = 0; i < 20; ++i) {
    std::size_t count = 0;
    {
      const UsbCameraWatch watch(notes());
      if (i % 2 == 0)
        waitForNews(1);
    }
    {
      const std::lock_guard lock(mutex_);
      count = news_.size();
    }
    cable_.unplug();
    cable_.plug();
    std::this_thread::sleep_for(5ms);
    EXPECT_EQ(count, waitForNews(0).size());
  }
}

TEST_F(UsbCameraWatching, EndsAtOnce)
{
  EXPECT_LT(timeOf([&] { const UsbCameraWatch watch(notes()); }), 900ms);
  auto watch = std::make_unique<UsbCameraWatch>(notes());
  waitForNews(1);
  std::this_thread::sleep_for(50ms); // it is waiting by now
  EXPECT_LT(timeOf([&] { watch.reset(); }), 500ms);
}

} // namespace
} // namespace pcl::acmap::test
