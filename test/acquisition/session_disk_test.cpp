#include "session_frames.h"
#include "temporary_folder.h"

#include <pcl/acquisition/trinocular_recorder.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <mutex>
#include <thread>

namespace {

/** Files that the program has synchronized, and the result that fsync returns. */
std::mutex synced_mutex;
std::vector<std::string> synced;
std::atomic<int> disk_fault{0};
std::atomic<bool> disk_hangs{false};

} // namespace

/** Replaces the system's function: a power failure cannot be tested, but calls of fsync
 * can. */
extern "C" __attribute__((visibility("default"))) int
fsync(int file)
{
  const std::string link = "/proc/self/fd/" + std::to_string(file);
  while (disk_hangs)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const std::lock_guard lock(synced_mutex);
  synced.push_back(std::filesystem::read_symlink(link).string());
  errno = disk_fault;
  return disk_fault == 0 ? 0 : -1;
}

namespace pcl::acmap::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
namespace fs = std::filesystem;

class SessionDisk : public testing::Test {
protected:
  SessionDisk()
  {
    synced.clear();
    disk_fault = 0;
  }

  ~SessionDisk() override
  {
    disk_hangs = false;
  }

  std::string
  beginning() const
  {
    return faultOfRunning<OutputFileException>(
        [&] { TrinocularRecorder recorder(session_, rig_); });
  }

  TemporaryFolder folder_;
  std::string session_ = fs::canonical(folder_.path("")).string() + "/session";
  TrinocularRig rig_ = rigOf(16, 12);
};

TEST_F(SessionDisk, HasEachFileBeforeTheCallReturns)
{
  const std::string around = fs::path(session_).parent_path().string();
  TrinocularRecorder recorder(session_, rig_);
  EXPECT_THAT(synced, ElementsAre(session_ + "/rig.yaml", session_, around, session_));
  synced.clear();
  recorder.record(recordedFrame(rig_, 0));
  EXPECT_THAT(synced, ElementsAre(session_ + "/frame_000000.acf", session_));
  synced.clear();
  recorder.finish();
  EXPECT_THAT(synced, ElementsAre(session_ + "/session.yaml", session_));
}

TEST_F(SessionDisk, ThatFailsLeavesTheSessionAsItWas)
{
  disk_fault = EIO;
  EXPECT_THAT(beginning(), HasSubstr("rig.yaml: Input/output error"));
  EXPECT_EQ(folder_.count(), 0);
  disk_fault = 0;
  TrinocularRecorder recorder(session_, rig_);
  disk_fault = EIO;
  EXPECT_THAT(faultOfRunning<OutputFileException>(
                  [&] { recorder.record(recordedFrame(rig_, 0)); }),
              HasSubstr("frame_000000.acf: Input/output error"));
  EXPECT_EQ(TrinocularFileGrabber(session_).frames(), 0U);
  disk_fault = 0;
  recorder.record(recordedFrame(rig_, 0));
  EXPECT_EQ(recorder.frames(), 1U);
}

TEST_F(SessionDisk, MayHaveNothingToWaitFor)
{
  disk_fault = EINVAL;
  TrinocularRecorder recorder(session_, rig_);
  recorder.record(recordedFrame(rig_, 0));
  EXPECT_EQ(TrinocularFileGrabber(session_).frames(), 1U);
}

TEST_F(SessionDisk, ThatHangsDoesNotKeepUpThoseWhoMayWait)
{
  constexpr std::uint64_t frames = 6;
  TrinocularRecorder recorder(session_, rig_);
  recorder.setMostWaiting(frames);
  disk_hangs = true;
  for (std::uint64_t i = 0; i < frames; ++i)
    recorder.record(recordedFrame(rig_, i));
  EXPECT_EQ(recorder.frames(), 0U);
  // A frame in the queue counts as recorded, too.
  EXPECT_THROW(recorder.record(recordedFrame(rig_, 2)), BadArgumentException);
  disk_hangs = false;
  recorder.finish();
  EXPECT_EQ(recorder.frames(), frames);
  const TrinocularFileGrabber grabber(session_);
  EXPECT_TRUE(grabber.getReport().is_finished);
  ASSERT_EQ(grabber.frames(), frames);
  for (std::uint64_t i = 0; i < frames; ++i)
    expectEqual(*grabber.frame(i), recordedFrame(rig_, i));
}

TEST_F(SessionDisk, IsWaitedForWhenTooManyWait)
{
  constexpr std::uint64_t maximum = 2;
  TrinocularRecorder recorder(session_, rig_);
  recorder.setMostWaiting(maximum);
  disk_hangs = true;
  std::atomic<std::uint64_t> taken{0};
  std::thread camera([&] {
    for (std::uint64_t i = 0; i < 8; ++i, ++taken)
      recorder.record(recordedFrame(rig_, i));
  });
  while (taken < maximum + 1) // one more, as one is being written
    std::this_thread::yield();
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(taken, maximum + 1);
  disk_hangs = false;
  camera.join();
  recorder.finish();
  EXPECT_EQ(recorder.frames(), 8U);
}

TEST_F(SessionDisk, ThatFailsIsToldWithTheNextFrame)
{
  TrinocularRecorder recorder(session_, rig_);
  recorder.setMostWaiting(4);
  disk_hangs = true;
  disk_fault = EIO;
  recorder.record(recordedFrame(rig_, 0));
  disk_hangs = false;
  // Tries a frame that is refused, until the thread has failed.
  const TrinocularFrame other = frameOf(rigOf(1, 1), 1, 1, 1);
  std::string fault;
  for (int i = 0; i < 10000 && fault.empty(); ++i) {
    fault = faultOfRunning<OutputFileException>(
        [&] { faultOfRunning<BadArgumentException>([&] { recorder.record(other); }); });
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_THAT(fault, HasSubstr("frame_000000.acf: Input/output error"));
  EXPECT_EQ(recorder.frames(), 0U);

  disk_fault = 0;
  recorder.record(recordedFrame(rig_, 0));
  recorder.finish();
  EXPECT_EQ(recorder.frames(), 1U);
  EXPECT_EQ(TrinocularFileGrabber(session_).frames(), 1U);
}

TEST_F(SessionDisk, HasWhatWaitedWhenTheRecorderGoes)
{
  {
    TrinocularRecorder recorder(session_, rig_);
    recorder.setMostWaiting(4);
    for (std::uint64_t i = 0; i < 4; ++i)
      recorder.record(recordedFrame(rig_, i));
  }
  const TrinocularFileGrabber grabber(session_);
  EXPECT_FALSE(grabber.getReport().is_finished);
  EXPECT_EQ(grabber.frames(), 4U);
}

TEST_F(SessionDisk, MayKeepUpAThousandFrames)
{
  TrinocularRecorder recorder(session_, rig_);
  EXPECT_EQ(recorder.getMostWaiting(), 0U);
  recorder.setMostWaiting(1000);
  EXPECT_THROW(recorder.setMostWaiting(1001), BadArgumentException);
  EXPECT_EQ(recorder.getMostWaiting(), 1000U);
}

} // namespace
} // namespace pcl::acmap::test
