#include "office_views.h"
#include "temporary_folder.h"

#include <pcl/conversions.h>
#include <pcl/pipeline/compact_mapping.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/simulation/simulated_rig_grabber.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <filesystem>
#include <mutex>

namespace pcl::acmap::test {
namespace {

class ArrivingViews : public OfficeViews {
protected:
  static void
  addAll(CompactMapping& mapping, bool with_poses)
  {
    for (std::size_t i = 0; i < views; ++i)
      mapping.addObservation(
          clouds_[i], with_poses ? std::optional(trajectory_.poses[i]) : std::nullopt);
  }

  static void
  expectSameWithPoses(const CompactMap& a, const CompactMap& b)
  {
    expectSame(a, b);
    ASSERT_EQ(a.trajectory.poses.size(), b.trajectory.poses.size());
    for (std::size_t i = 0; i < a.trajectory.poses.size(); ++i)
      EXPECT_EQ(a.trajectory.poses[i].matrix(), b.trajectory.poses[i].matrix());
  }
};

TEST_F(ArrivingViews, becomeTheMapThatTheyBecomeAfterwards)
{
  for (const bool with_poses : {false, true}) {
    CompactMapping afterwards, arriving;
    std::vector<MappingState> told;
    arriving.setProvisionalInterval(0);
    arriving.setStateCallback([&](const MappingState& state) {
      if (!state.is_late)
        told.push_back(state);
    });
    CompactMap expected, map;
    addAll(afterwards, with_poses);
    afterwards.compute(expected);
    arriving.start();
    addAll(arriving, with_poses);
    EXPECT_EQ(arriving.getNumberOfObservations(), views);
    arriving.compute(map);
    expectSameWithPoses(map, expected);
    EXPECT_EQ(arriving.getReport().remarks, afterwards.getReport().remarks);
    ASSERT_EQ(arriving.getReport().odometry.has_value(), !with_poses);
    ASSERT_EQ(arriving.getReport().consolidation->representatives,
              afterwards.getReport().consolidation->representatives);
    ASSERT_EQ(told.size(), views);
    for (std::size_t i = 0; i < views; ++i) {
      EXPECT_EQ(told[i].processed, i + 1);
      EXPECT_LE(told[i].processed, told[i].arrived);
      EXPECT_EQ(told[i].poses.size(), i + 1);
      EXPECT_EQ(told[i].newest, clouds_[i]);
    }
    EXPECT_EQ(told.back().lag, 0);
    EXPECT_TRUE(told.back().poses.back().has_value());
  }
}

/** The thread of the mapping is held up, so that observations come too fast. */
TEST_F(ArrivingViews, thatComeTooFastWaitAndAreNotLost)
{
  CompactMapping mapping;
  EXPECT_THROW(mapping.setMaximumWaiting(0), BadArgumentException);
  mapping.setMaximumWaiting(1);
  std::mutex mutex;
  std::condition_variable changed;
  std::size_t late = 0, processed = 0;
  double lag = 0;
  mapping.setProvisionalInterval(0);
  mapping.setStateCallback([&](const MappingState& state) {
    std::unique_lock lock(mutex);
    if (state.is_late) {
      ++late;
      lag = std::max(lag, state.lag);
      changed.notify_all();
    }
    else if (++processed == 1) // until the thread that adds has to wait
      changed.wait(lock, [&] { return late > 0; });
  });
  mapping.start();
  addAll(mapping, true);
  CompactMap map;
  mapping.compute(map);
  EXPECT_GE(late, 1U);
  EXPECT_GT(lag, 0);
  EXPECT_EQ(processed, views);
  EXPECT_EQ(map.trajectory.poses.size(), views);
}

TEST_F(ArrivingViews, becomeTheSameMapFromTheirFolder)
{
  const TemporaryFolder folder;
  CompactMapping kept, in_memory;
  kept.setObservationFolder(folder.path("deep/observations"));
  CompactMap map, expected;
  kept.start();
  in_memory.start();
  addAll(kept, false);
  addAll(in_memory, false);
  kept.compute(map);
  in_memory.compute(expected);
  expectSameWithPoses(map, expected);
  EXPECT_EQ(ObservationSequence(folder.path("deep/observations")).size(), views);
  CompactMapping nowhere;
  nowhere.setObservationFolder("/proc/no/folder");
  EXPECT_THROW(nowhere.start(), OutputFileException);
}

TEST_F(ArrivingViews, cannotComeBeforeTheStartNorAfterTheMap)
{
  CompactMapping mapping;
  mapping.addObservation(clouds_[0], trajectory_.poses[0]);
  EXPECT_THROW(mapping.start(), InitFailedException);
  mapping.clear();
  mapping.start();
  CompactMap map;
  EXPECT_THROW(mapping.compute(map), InitFailedException) << "nothing arrived";
  EXPECT_THROW(mapping.addObservation(clouds_[0]), InitFailedException);
  mapping.clear();
  addAll(mapping, true);
  mapping.compute(map);
  EXPECT_EQ(map.trajectory.poses.size(), views);
}

TEST_F(ArrivingViews, thatAreBrokenAreToldByTheNextCall)
{
  CompactMapping mapping;
  const auto unorganized = std::make_shared<PointCloudFile>();
  unorganized->cloud = clouds_[0]->cloud;
  unorganized->cloud.width *= unorganized->cloud.height;
  unorganized->cloud.height = 1;
  mapping.setMode(MappingMode::Paper); // its egomotion needs images
  mapping.start();
  mapping.addObservation(std::shared_ptr<const PointCloudFile>(unorganized));
  CompactMap map;
  EXPECT_THROW(mapping.compute(map), InputFileException);
  EXPECT_THROW(mapping.compute(map), InputFileException) << "and not a map of the rest";
  mapping.keepProcessed();
  EXPECT_THROW(mapping.compute(map), InputFileException) << "there is no rest";
  mapping.clear();
  mapping.start();
  mapping.setMaximumWaiting(1); // of the next start
  mapping.addObservation(std::shared_ptr<const PointCloudFile>(unorganized));
  EXPECT_THROW(
      {
        for (int i = 0; i < 1000; ++i) // until the fault is known
          mapping.addObservation(clouds_[0]);
        mapping.compute(map);
      },
      InputFileException);
}

/** A folder stands where the file of the last view belongs. */
TEST_F(ArrivingViews, beforeAFaultBecomeAMap)
{
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path(observationName(views - 1)) + "/x");
  CompactMapping faulty, expecting;
  faulty.setObservationFolder(folder.path(""));
  CompactMap map, expected;
  faulty.start();
  addAll(faulty, true);
  EXPECT_THROW(faulty.compute(map), OutputFileException);
  faulty.keepProcessed();
  faulty.compute(map);
  EXPECT_THAT(faulty.getReport().remarks,
              testing::Contains(testing::HasSubstr("observations are missing")));
  for (std::size_t i = 0; i + 1 < views; ++i)
    expecting.addObservation(clouds_[i], trajectory_.poses[i]);
  expecting.compute(expected);
  expectSameWithPoses(map, expected);
}

TEST_F(ArrivingViews, showTheirPlanesOnTheWay)
{
  CompactMapping mapping;
  EXPECT_THROW(mapping.setProvisionalInterval(-1), BadArgumentException);
  mapping.setProvisionalInterval(1e-3);
  std::mutex mutex;
  std::condition_variable changed;
  std::shared_ptr<const CompactMap> told;
  mapping.setStateCallback([&](const MappingState& state) {
    const std::lock_guard lock(mutex);
    told = state.provisional;
    changed.notify_all();
  });
  mapping.start();
  addAll(mapping, true);
  {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return told && told->trajectory.poses.size() == views; });
  }
  CompactMap map;
  mapping.compute(map);
  ASSERT_FALSE(map.planes.empty());
  const PlanePatch& largest = map.planes.front();
  const bool is_there = std::any_of(
      told->planes.begin(), told->planes.end(), [&](const PlanePatch& plane) {
        constexpr double max_angle = 0.05, max_distance = 0.05; // radians, metres
        const Eigen::Vector4d& n = largest.coefficients;
        return plane.coefficients.head<3>().dot(n.head<3>()) > std::cos(max_angle) &&
               std::abs(plane.coefficients[3] - n[3]) < max_distance;
      });
  EXPECT_TRUE(is_there) << told->planes.size() << " planes";
}

/** The destructor stops the thread, which throws away what it was doing. */
TEST_F(ArrivingViews, canBeLeftAlone)
{
  for (std::size_t added = 0; added < views; ++added) {
    CompactMapping mapping;
    mapping.start();
    for (std::size_t i = 0; i < added; ++i)
      mapping.addObservation(clouds_[i]);
    if (added == 1)
      mapping.clear();
    EXPECT_EQ(mapping.getNumberOfObservations(), added == 1 ? 0U : added);
  }
}

TEST(LiveMapping, framesBecomeObservationsAsByTheirClasses)
{
  SimulatedScene scene = standardScene("office");
  makeSmall(scene, 4);
  scene.views.resize(2);
  RgbImage stripes{1024, 768, {}};
  for (std::size_t i = 0; i < std::size_t{1024} * 768; ++i)
    stripes.values.insert(
        stripes.values.end(), 3, (i * 2654435761U >> 28U & 1U) != 0 ? 255 : 0);
  const SimulatedRigGrabber grabber(scene, {stripes, stripes});
  CompactMapping mapping;
  mapping.setInputRig(scene.rig);
  std::vector<std::shared_ptr<const PointCloudFile>> clouds;
  mapping.setProvisionalInterval(0);
  mapping.setStateCallback([&](const MappingState& state) {
    if (!state.is_late)
      clouds.push_back(state.newest);
  });
  mapping.start();
  for (std::size_t view = 0; view < scene.views.size(); ++view)
    for (const TrinocularFrame::Ptr& shot : grabber.observe(view))
      mapping.addFrame(shot);
  CompactMap map;
  try {
    mapping.compute(map);
  }
  catch (const EmptyInputException& error) { // for views this small
    EXPECT_THAT(error.what(), testing::HasSubstr("could be joined"));
  }
  EXPECT_EQ(mapping.getNumberOfObservations(), scene.views.size());
  DisparityFusion fusion;
  fusion.setInputRig(scene.rig);
  DisparityBackProjection projection;
  projection.setInputRig(scene.rig);
  ASSERT_EQ(clouds.size(), scene.views.size());
  for (std::size_t view = 0; view < scene.views.size(); ++view) {
    for (const TrinocularFrame::Ptr& shot : grabber.observe(view))
      fusion.addShot(shot);
    MatchedDisparity disparity;
    fusion.fuse(disparity);
    PointCloud<PointXYZRGBSigma> expected;
    projection.project(disparity, fusion.getColor(), expected);
    PointCloud<PointXYZRGBSigma> cloud;
    fromPCLPointCloud2(clouds[view]->cloud, cloud);
    ASSERT_EQ(cloud.size(), expected.size());
    std::size_t finite = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      EXPECT_EQ(cloud[i].rgba, expected[i].rgba);
      const bool is_finite = expected[i].getVector3fMap().allFinite();
      ASSERT_EQ(cloud[i].getVector3fMap().allFinite(), is_finite);
      if (!is_finite)
        continue;
      EXPECT_EQ(cloud[i].getVector3fMap(), expected[i].getVector3fMap());
      EXPECT_EQ(cloud[i].sigma, expected[i].sigma);
      ++finite;
    }
    EXPECT_GT(finite, 100U);
    fusion.clear();
  }
}

} // namespace
} // namespace pcl::acmap::test
