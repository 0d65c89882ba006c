#include "temporary_folder.h"

#include <pcl/conversions.h>
#include <pcl/pipeline/compact_mapping.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/simulation/simulated_observation.h>
#include <pcl/simulation/simulated_rig_grabber.h>
#include <pcl/simulation/standard_scenes.h>

#include <gmock/gmock.h>

namespace pcl::acmap::test {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr std::size_t views = 3;

/** Gives the cameras fewer pixels. */
void
makeSmall(SimulatedScene& scene, int factor)
{
  scene.rig.width /= factor;
  scene.rig.height /= factor;
  scene.rig.focal_length /= factor;
  scene.rig.center_x = (scene.rig.width - 1) / 2.0;
  scene.rig.center_y = (scene.rig.height - 1) / 2.0;
  scene.sensor.points /= static_cast<std::size_t>(factor) * factor;
}

/** A few views of an office, each with its pose. */
class OfficeViews : public testing::Test {
protected:
  static void
  SetUpTestSuite()
  {
    SimulatedScene office = standardScene("office");
    makeSmall(office, 2);
    trajectory_ = trajectoryOf(office, views);
    for (std::size_t i = 0; i < views; ++i) {
      const auto file = std::make_shared<PointCloudFile>();
      file->cloud = cloudOf(observe(office, i, 1));
      clouds_.push_back(file);
    }
  }

  static void
  TearDownTestSuite()
  {
    clouds_.clear();
  }

  static void
  expectSame(const CompactMap& a, const CompactMap& b)
  {
    ASSERT_EQ(a.planes.size(), b.planes.size());
    ASSERT_EQ(a.charts.size(), b.charts.size());
    for (std::size_t i = 0; i < a.planes.size(); ++i)
      EXPECT_EQ(a.planes[i].coefficients, b.planes[i].coefficients);
    for (std::size_t i = 0; i < a.charts.size(); ++i)
      EXPECT_EQ(a.charts[i].colors.values, b.charts[i].colors.values);
    EXPECT_EQ(a.observations, b.observations);
  }

  static inline Trajectory trajectory_;
  static inline std::vector<std::shared_ptr<const PointCloudFile>> clouds_;
};

TEST_F(OfficeViews, becomeAMap)
{
  CompactMapping mapping;
  for (std::size_t i = 0; i < views; ++i)
    mapping.addObservation(clouds_[i], trajectory_.poses[i]);
  EXPECT_EQ(mapping.getNumberOfObservations(), views);
  CompactMap map;
  mapping.compute(map);
  EXPECT_GE(map.planes.size(), 3U);
  EXPECT_EQ(map.trajectory.poses.size(), views);
  const CompactMappingReport& report = mapping.getReport();
  EXPECT_FALSE(report.odometry);
  EXPECT_TRUE(report.rectification);
  EXPECT_EQ(report.merging.observations, views);
  EXPECT_GT(report.texture.seen, report.texture.texels / 2);
  EXPECT_EQ(mapping.getOdometryTrajectory().poses.size(), views);
  EXPECT_EQ(mapping.getMappedPlanes().planes.size(), map.planes.size());
}

TEST_F(OfficeViews, becomeTheSameMapFromFilesThatAreReadTwiceAtMost)
{
  const TemporaryFolder folder;
  for (std::size_t i = 0; i < views; ++i)
    saveObservation(folder.path(observationName(i)),
                    clouds_[i]->cloud,
                    Eigen::Isometry3d::Identity());
  saveTrajectory(folder.path(trajectory_name), trajectory_);
  const ObservationSequence sequence(folder.path(""));
  CompactMapping from_files, from_memory;
  from_files.setInputSequence(sequence, true);
  for (std::size_t i = 0; i < views; ++i)
    from_memory.addObservation(clouds_[i], trajectory_.poses[i]);
  CompactMap read, held;
  from_files.compute(read);
  from_memory.compute(held);
  expectSame(read, held);
  EXPECT_LE(sequence.getNumberOfReads(), 2 * views);
}

TEST_F(OfficeViews, areTheSameForEveryNumberOfThreads)
{
  CompactMap maps[2];
  for (const unsigned threads : {1U, 4U}) {
    CompactMapping mapping;
    mapping.setNumberOfThreads(threads);
    mapping.setRectify(false);
    for (std::size_t i = 0; i < views; ++i)
      mapping.addObservation(clouds_[i], trajectory_.poses[i]);
    mapping.compute(maps[threads == 1 ? 0 : 1]);
    EXPECT_FALSE(mapping.getReport().rectification);
  }
  expectSame(maps[0], maps[1]);
}

TEST_F(OfficeViews, findTheirPoses)
{
  CompactMapping mapping;
  for (std::size_t i = 0; i < views; ++i)
    mapping.addObservation(clouds_[i]);
  mapping.setRectify(false);
  CompactMap map;
  mapping.compute(map);
  ASSERT_TRUE(mapping.getReport().odometry);
  ASSERT_GE(mapping.getReport().odometry->posed(), 2U);
  const Eigen::Isometry3d truth = trajectory_.poses[0].inverse() * trajectory_.poses[1];
  const Eigen::Isometry3d found =
      map.trajectory.poses[0].inverse() * map.trajectory.poses[1];
  EXPECT_LT((found.translation() - truth.translation()).norm(), 0.05);
}

TEST_F(OfficeViews, goOnFromTheFolderOfAnEarlierRun)
{
  const TemporaryFolder folder;
  const auto run = [&](const std::string& settings, bool changed) {
    CompactMapping mapping;
    mapping.setFolder(folder.path("poses"), settings);
    for (std::size_t i = 0; i < views; ++i)
      mapping.addObservation(clouds_[changed ? views - 1 - i : i]);
    std::pair<CompactMap, CompactMappingReport> result;
    mapping.compute(result.first);
    result.second = mapping.getReport();
    EXPECT_EQ(mapping.getOdometryTrajectory().poses.size(),
              result.first.trajectory.poses.size());
    return result;
  };
  const auto [first, first_report] = run("", false);
  EXPECT_TRUE(first_report.odometry);
  EXPECT_TRUE(first_report.rectification);
  const auto [second, second_report] = run("", false);
  EXPECT_FALSE(second_report.odometry);
  EXPECT_FALSE(second_report.rectification);
  EXPECT_THAT(second_report.remarks, Contains(HasSubstr("poses of an earlier run")));
  expectSame(first, second);
  EXPECT_TRUE(run("other settings", false).second.odometry);
  EXPECT_TRUE(run("other settings", true).second.odometry) << "other observations";
}

TEST_F(OfficeViews, haveAllTheirPosesOrNone)
{
  CompactMapping mapping;
  CompactMap map;
  EXPECT_THROW(mapping.compute(map), InitFailedException);
  mapping.addObservation(clouds_[0]);
  mapping.addObservation(clouds_[1], trajectory_.poses[1]);
  EXPECT_THROW(mapping.compute(map), InitFailedException);
  mapping.clear();
  EXPECT_EQ(mapping.getNumberOfObservations(), 0U);
  EXPECT_THROW(mapping.addObservation(PointCloud<PointXYZRGB>::Ptr()),
               BadArgumentException);
  Eigen::Isometry3d stretched = Eigen::Isometry3d::Identity();
  stretched.linear() *= 2;
  EXPECT_THROW(mapping.addObservation(clouds_[0], stretched), BadArgumentException);
  mapping.addObservation(clouds_[0]);
  mapping.setInputSequence(ObservationSequence(clouds_), false);
  EXPECT_THROW(mapping.compute(map), InitFailedException);
}

TEST_F(OfficeViews, canBeCancelled)
{
  CompactMapping mapping;
  for (std::size_t i = 0; i < views; ++i)
    mapping.addObservation(clouds_[i], trajectory_.poses[i]);
  double last = 0;
  mapping.setProgressCallback([&](double done, const std::string&) {
    EXPECT_GE(done, last);
    last = done;
    return done < 0.7;
  });
  CompactMap map;
  map.planes.resize(7);
  EXPECT_THROW(mapping.compute(map), CancelledException);
  EXPECT_EQ(map.planes.size(), 7U);
}

/** Delivers clouds of one type when it is started. */
template <typename PointT>
class CloudGrabber : public Grabber {
public:
  using Callback = void(const typename PointCloud<PointT>::ConstPtr&);

  CloudGrabber()
  : signal_(createSignal<Callback>())
  {}

  void
  start() override
  {
    (*signal_)(typename PointCloud<PointT>::ConstPtr(new PointCloud<PointT>(2, 2)));
  }

  void
  stop() override
  {}

  bool
  isRunning() const override
  {
    return false;
  }

  std::string
  getName() const override
  {
    return "CloudGrabber";
  }

  float
  getFramesPerSecond() const override
  {
    return 0;
  }

private:
  boost::signals2::signal<Callback>* signal_;
};

TEST(CompactMapping, takesTheCloudsOfAGrabber)
{
  CompactMapping mapping;
  CloudGrabber<PointXYZRGBA> colored;
  boost::signals2::connection connection = mapping.setInputGrabber(colored);
  colored.start();
  EXPECT_EQ(mapping.getNumberOfObservations(), 1U);
  connection.disconnect();
  colored.start();
  EXPECT_EQ(mapping.getNumberOfObservations(), 1U);
  CloudGrabber<PointXYZ> colorless;
  EXPECT_THROW(mapping.setInputGrabber(colorless), BadArgumentException);
}

TEST(CompactMapping, takesTheFramesOfARig)
{
  SimulatedScene scene = standardScene("corridor");
  makeSmall(scene, 8);
  scene.views.resize(2);
  const RgbImage blank{
      1024, 768, std::vector<std::uint8_t>(std::size_t{3} * 1024 * 768, 90)};
  SimulatedRigGrabber grabber(scene, {blank, blank});
  CompactMapping mapping;
  mapping.setInputGrabber(grabber);
  grabber.start();
  grabber.wait();
  ASSERT_FALSE(grabber.getError());
  EXPECT_EQ(mapping.getNumberOfObservations(), 1U) << "the last one is not complete";
  CompactMap map;
  map.planes.resize(7);
  try {
    mapping.compute(map);
  }
  catch (const InitFailedException& error) { // for views this small
    EXPECT_THAT(error.what(), HasSubstr("could be joined"));
  }
  EXPECT_EQ(mapping.getNumberOfObservations(), 2U);
}

} // namespace
} // namespace pcl::acmap::test
