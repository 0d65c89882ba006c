#include "temporary_folder.h"
#include "video_writer.h"

#include <pcl/acquisition/pattern_sequence_grabber.h>
#include <pcl/acquisition/trinocular_file_grabber.h>
#include <pcl/acquisition/trinocular_recorder.h>
#include <pcl/stereo/disparity_fusion.h>
#include <pcl/video/camera_grabber.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace pcl::acmap::test {
namespace {

/** \brief A projector that needs no light, since the videos were filmed before. */
class NoProjector : public PatternProjector {
public:
  void
  show(const RgbImage& /*image*/) override
  {}

  void
  showNothing() override
  {}
};

std::vector<TrinocularFrame::ConstPtr>
framesOfSession(const std::string& folder)
{
  const TrinocularFileGrabber session(folder);
  std::vector<TrinocularFrame::ConstPtr> frames;
  for (std::size_t i = 0; i < session.frames(); ++i)
    frames.push_back(session.frame(i));
  return frames;
}

/** \brief Disparities of the frames that a grabber gives for one observation. */
MatchedDisparity
disparitiesOf(const std::vector<TrinocularFrame::ConstPtr>& frames,
              const TrinocularRig& rig)
{
  DisparityFusion fusion;
  fusion.setInputRig(rig);
  for (const TrinocularFrame::ConstPtr& frame : frames)
    fusion.addShot(frame);
  MatchedDisparity disparity;
  fusion.fuse(disparity);
  return disparity;
}

/** \brief Takes one observation of the videos, as of two webcams. */
std::vector<TrinocularFrame::ConstPtr>
observeVideos(const FilmedPair& pair, const std::vector<std::string>& videos)
{
  const CameraGrabber::Ptr cameras(new CameraGrabber(pair.rig, videos));
  PatternSequenceGrabber grabber(
      cameras, shared_ptr<PatternProjector>(new NoProjector), pair.patterns);
  grabber.setSettleTime(0);
  std::vector<TrinocularFrame::ConstPtr> frames;
  const std::function<TrinocularGrabber::FrameCallback> take =
      [&](const TrinocularFrame::ConstPtr& frame) { frames.push_back(frame); };
  grabber.registerCallback(take);
  grabber.observe();
  grabber.wait();
  if (grabber.getError())
    std::rethrow_exception(grabber.getError());
  EXPECT_EQ(cameras->getReport().moved, 0u);
  return frames;
}

bool
haveSameBits(const std::vector<float>& a, const std::vector<float>& b)
{
  return a.size() == b.size() && !a.empty() &&
         std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

/** \brief Expects frames and disparities of the videos to be those of a session. */
void
expectSessionsDisparities(const FilmedPair& pair,
                          const std::vector<TrinocularFrame::ConstPtr>& frames)
{
  const TemporaryFolder folder;
  TrinocularRecorder recorder(folder.path("session"), pair.rig);
  for (const TrinocularFrame::Ptr& shot : pair.shots)
    recorder.record(*shot);
  recorder.finish();
  const auto recorded = framesOfSession(folder.path("session"));

  ASSERT_EQ(frames.size(), 4u);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i]->pattern, recorded[i]->pattern);
    EXPECT_TRUE(frames[i]->images == recorded[i]->images) << i;
  }
  const MatchedDisparity of_video = disparitiesOf(frames, pair.rig);
  const MatchedDisparity of_session = disparitiesOf(recorded, pair.rig);
  EXPECT_TRUE(haveSameBits(of_video.disparity.values, of_session.disparity.values));
  std::size_t matched = 0;
  for (const float value : of_video.disparity.values)
    matched += std::isfinite(value) ? 1 : 0;
  EXPECT_GT(matched, of_video.disparity.values.size() / 2);
  testing::Test::RecordProperty("matched pixels", static_cast<int>(matched));
}

TEST(VideoDisparities, OfAVideoWithoutLossAreThoseOfASession)
{
  const TemporaryFolder folder;
  const FilmedPair pair = filmPair();
  expectSessionsDisparities(
      pair, observeVideos(pair, writeVideos(pair, folder.path(""), ".mkv")));
}

TEST(VideoDisparities, OfAPipelineOfGStreamerAreThoseOfASession)
{
  const TemporaryFolder folder;
  try {
    openVideo("filesrc location=/dev/zero ! rawvideoparse format=gray8 ! appsink");
  }
  catch (const CameraException& exception) {
    GTEST_SKIP() << "GStreamer has not what is needed: " << exception.what();
  }
  const FilmedPair pair = filmPair();
  std::vector<std::string> pipelines;
  for (const std::string& file : writeVideos(pair, folder.path(""), ".raw"))
    pipelines.push_back(
        "filesrc location=" + file +
        " ! rawvideoparse format=bgr width=" + std::to_string(pair.rig.width) +
        " height=" + std::to_string(pair.rig.height) + " framerate=30/1 ! appsink");
  expectSessionsDisparities(pair, observeVideos(pair, pipelines));
}

} // namespace
} // namespace pcl::acmap::test
