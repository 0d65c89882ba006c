#include "session_frames.h"
#include "temporary_folder.h"

#include <pcl/acquisition/trinocular_recorder.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>

namespace {

/** What the program asked the disk for, and what the disk says. */
std::vector<std::string> synced;
int disk_fault = 0;

} // namespace

/** Stands before the system's: a power failure cannot be tested, this can. */
extern "C" __attribute__((visibility("default"))) int
fsync(int file)
{
  const std::string link = "/proc/self/fd/" + std::to_string(file);
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

} // namespace
} // namespace pcl::acmap::test
