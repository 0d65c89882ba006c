#include "active_stereo_session.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstring>

namespace pcl::acmap::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using ActiveStereo = ActiveStereoSession;

/** Compares also NaN. */
bool
isSame(float a, float b)
{
  return std::memcmp(&a, &b, sizeof(a)) == 0;
}

void
expectSame(const std::vector<float>& a, const std::vector<float>& b)
{
  ASSERT_EQ(a.size(), b.size());
  EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), isSame));
}

void
expectSame(const PointCloud<PointXYZRGBSigma>& a, const PointCloud<PointXYZRGBSigma>& b)
{
  ASSERT_EQ(a.width, b.width);
  ASSERT_EQ(a.height, b.height);
  EXPECT_EQ(a.is_dense, b.is_dense);
  for (std::size_t i = 0; i < a.size(); ++i)
    ASSERT_TRUE(isSame(a[i].x, b[i].x) && isSame(a[i].y, b[i].y) &&
                isSame(a[i].z, b[i].z) && isSame(a[i].sigma, b[i].sigma) &&
                a[i].rgba == b[i].rgba)
        << i;
}

TEST_F(ActiveStereo, GivesWhatFusionAndBackProjectionMake)
{
  const auto frames = simulate();
  const auto grabber = grab(frames);
  std::vector<PointCloud<PointXYZRGBSigma>::ConstPtr> clouds;
  const std::function<ActiveStereoGrabber::CloudCallback> note =
      [&](const auto& cloud) { clouds.push_back(cloud); };
  grabber->registerCallback(note);
  grabber->start();
  grabber->wait();
  EXPECT_EQ(errorOf(*grabber), "");
  EXPECT_THAT(wholeOnes(), ElementsAre(0, 1, 2));
  ASSERT_EQ(clouds.size(), observations);
  DisparityFusion fusion;
  fusion.setInputRig(scene_.rig);
  setUp(fusion);
  DisparityBackProjection projection;
  projection.setInputRig(scene_.rig);
  for (std::size_t i = 0; i < observations; ++i) {
    const ActiveStereoObservation observation = given()[i];
    EXPECT_EQ(clouds[i], observation.cloud);
    EXPECT_EQ(clouds[i]->header.seq, i);
    EXPECT_EQ(clouds[i]->header.stamp, 3 * i * 1000000 / 14);
    EXPECT_EQ(clouds[i]->header.frame_id, "reference_camera");
    EXPECT_TRUE(clouds[i]->sensor_origin_.head<3>().isZero());
    fusion.clear();
    for (const auto& shot : frames->observe(i))
      fusion.addShot(shot);
    MatchedDisparity matched;
    fusion.fuse(matched);
    expectSame(observation.disparity->disparity.values, matched.disparity.values);
    expectSame(observation.disparity->sigma, matched.sigma);
    EXPECT_EQ(observation.disparity->support, matched.support);
    EXPECT_EQ(observation.fusion.outcomes, fusion.getReport().outcomes);
    PointCloud<PointXYZRGBSigma> cloud;
    projection.project(matched, fusion.getColor(), cloud);
    expectSame(*clouds[i], cloud);
    EXPECT_GT(projection.getReport().points, cloud.size() / 10);
  }
}

template <typename PointT>
using Clouds = std::vector<typename PointCloud<PointT>::ConstPtr>;

/** Collects the clouds of a point type. */
template <typename PointT>
boost::signals2::connection
collect(ActiveStereoGrabber& grabber, Clouds<PointT>& clouds)
{
  const std::function<ActiveStereoGrabber::PointCloudCallback<PointT>> note =
      [&clouds](const auto& cloud) { clouds.push_back(cloud); };
  return grabber.registerCallback(note);
}

template <typename PointT>
void
expectSamePlaces(const PointCloud<PointT>& a, const PointCloud<PointXYZRGBSigma>& b)
{
  EXPECT_EQ(a.header.seq, b.header.seq);
  EXPECT_EQ(a.header.stamp, b.header.stamp);
  EXPECT_EQ(a.header.frame_id, b.header.frame_id);
  EXPECT_EQ(a.sensor_origin_, b.sensor_origin_);
  EXPECT_TRUE(a.sensor_orientation_.coeffs() == b.sensor_orientation_.coeffs());
  EXPECT_EQ(a.is_dense, b.is_dense);
  ASSERT_EQ(a.width, b.width);
  ASSERT_EQ(a.height, b.height);
  for (std::size_t i = 0; i < a.size(); ++i)
    ASSERT_TRUE(isSame(a[i].x, b[i].x) && isSame(a[i].y, b[i].y) &&
                isSame(a[i].z, b[i].z))
        << i;
}

TEST_F(ActiveStereo, TakesTheCallbacksOfOpenNI)
{
  const auto grabber = grab(simulate());
  Clouds<PointXYZ> points;
  Clouds<PointXYZRGB> rgb;
  Clouds<PointXYZRGBA> rgba, nothing;
  collect<PointXYZ>(*grabber, points);
  collect<PointXYZRGB>(*grabber, rgb);
  collect<PointXYZRGBA>(*grabber, rgba);
  collect<PointXYZRGBA>(*grabber, nothing).disconnect();
  grabber->start();
  grabber->wait();
  EXPECT_EQ(errorOf(*grabber), "");
  ASSERT_EQ(points.size(), observations);
  ASSERT_EQ(rgb.size(), observations);
  ASSERT_EQ(rgba.size(), observations);
  EXPECT_THAT(nothing, IsEmpty());
  for (std::size_t i = 0; i < observations; ++i) {
    const PointCloud<PointXYZRGBSigma>& cloud = *given()[i].cloud;
    expectSamePlaces(*points[i], cloud);
    expectSamePlaces(*rgb[i], cloud);
    expectSamePlaces(*rgba[i], cloud);
    for (std::size_t k = 0; k < cloud.size(); ++k) {
      ASSERT_EQ(rgb[i]->points[k].rgba, cloud[k].rgba) << k;
      ASSERT_EQ(rgba[i]->points[k].rgba, cloud[k].rgba) << k;
    }
  }
}

TEST_F(ActiveStereo, ARecordingGivesTheSame)
{
  const auto simulated = grab(simulate());
  simulated->start();
  simulated->wait();
  const auto recorded = grab(open());
  recorded->start();
  recorded->wait();
  EXPECT_EQ(errorOf(*recorded), "");
  ASSERT_THAT(wholeOnes(), ElementsAre(0, 1, 2, 0, 1, 2));
  for (std::size_t i = 0; i < observations; ++i)
    expectSame(*given()[i].cloud, *given()[observations + i].cloud);
}

TEST_F(ActiveStereo, IsAGrabber)
{
  const auto grabber = grab(simulate());
  EXPECT_EQ(grabber->getName(), "ActiveStereoGrabber");
  EXPECT_EQ(grabber->getFramesPerSecond(), 0.0F);
  EXPECT_EQ(grabber->getRig().focal_length, scene_.rig.focal_length);
  EXPECT_TRUE(grabber->providesCallback<ActiveStereoGrabber::CloudCallback>());
  EXPECT_TRUE(
      grabber->providesCallback<void(const PointCloud<PointXYZRGBA>::ConstPtr&)>());
  EXPECT_FALSE(grabber->providesCallback<TrinocularGrabber::FrameCallback>());
  EXPECT_FALSE(grabber->isRunning());
  EXPECT_FALSE(grabber->getError());
  grabber->wait();
  grabber->stop();
}

TEST_F(ActiveStereo, ReportIsOfTheStream)
{
  const auto frames = simulate();
  const auto grabber = grab(frames);
  for (int round = 0; round < 2; ++round) {
    frames->rewind();
    grabber->start();
    grabber->wait();
    const ActiveStereoGrabberReport report = grabber->getReport();
    EXPECT_EQ(report.frames, observations * shots);
    EXPECT_EQ(report.observations, observations);
    EXPECT_THAT(report.remarks, IsEmpty());
    EXPECT_FALSE(report.seconds.empty());
  }
  grabber->start(); // at the end of the stream
  grabber->wait();
  EXPECT_EQ(grabber->getReport().frames, 0u);
  EXPECT_THAT(wholeOnes(), ElementsAre(0, 1, 2, 0, 1, 2));
}

TEST_F(ActiveStereo, SingleFramesMakeObservationsToo)
{
  const auto grabber = grab(open(0));
  std::vector<std::size_t> after;
  for (std::size_t frame = 0; frame < observations * shots + 2; ++frame) {
    grabber->start();
    grabber->wait();
    after.push_back(given().size());
  }
  EXPECT_THAT(after, ElementsAre(0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3));
  EXPECT_THAT(wholeOnes(), ElementsAre(0, 1, 2));
}

TEST_F(ActiveStereo, ASessionThatRepeatsBeginsAnObservation)
{
  scene_.views.resize(1);
  auto frames = simulate();
  frames->setNumberOfObservations(1);
  const std::function<TrinocularGrabber::FrameCallback> repeat =
      [&](const TrinocularFrame::ConstPtr& frame) {
        if (frame->number + 1 == shots && given().size() < 3)
          frames->rewind();
      };
  const auto grabber = grab(frames);
  frames->registerCallback(repeat);
  grabber->start();
  grabber->wait();
  EXPECT_THAT(wholeOnes(), ElementsAre(0, 0, 0, 0));
}

TEST_F(ActiveStereo, ShotsWithoutPatternsGiveColourOnly)
{
  const auto grabber = grab(simulate(false));
  grabber->start();
  grabber->wait();
  EXPECT_EQ(errorOf(*grabber), "");
  ASSERT_EQ(given().size(), observations);
  for (const auto& point : *given()[0].cloud) {
    EXPECT_TRUE(std::isnan(point.z));
    EXPECT_NE(point.rgba, 0xff000000u);
  }
  const std::vector<std::string> remarks = grabber->getReport().remarks;
  EXPECT_THAT(remarks,
              Contains(HasSubstr("observation 1: there is no shot with a pattern")));
  EXPECT_THAT(remarks, Contains(HasSubstr("observation 1: no pixel")));
}

TEST_F(ActiveStereo, SettingsWaitForTheEndOfTheStream)
{
  ActiveStereoGrabber* self = nullptr;
  int refused = 0;
  const auto grabber = grab(simulate(), [&] {
    for (const auto& set : {std::function<void()>([&] { self->fusion(); }),
                            std::function<void()>([&] { self->backProjection(); })})
      try {
        set();
      }
      catch (const InitFailedException&) {
        ++refused;
      }
  });
  self = grabber.get();
  grabber->backProjection().setMaximumDepth(0.02);
  grabber->start();
  grabber->wait();
  EXPECT_EQ(refused, 2 * static_cast<int>(observations));
  EXPECT_TRUE(std::isnan(given()[0].cloud->at(32, 24).z)) << "farther than 2 cm";
}

TEST_F(ActiveStereo, NonsenseIsRefused)
{
  EXPECT_THROW(ActiveStereoGrabber(nullptr), BadArgumentException);
  scene_.rig.baseline_horizontal = scene_.rig.baseline_vertical = 0.0;
  EXPECT_THROW(ActiveStereoGrabber{simulate()}, BadArgumentException);
}

} // namespace
} // namespace pcl::acmap::test
