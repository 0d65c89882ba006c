#include "office_views.h"
#include "temporary_folder.h"

#include <pcl/conversions.h>
#include <pcl/core/impl/rigid_alignment.h>
#include <pcl/pipeline/compact_mapping.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/observation_source.h>
#include <pcl/simulation/simulated_observation.h>
#include <pcl/simulation/simulated_rig_grabber.h>
#include <pcl/simulation/standard_scenes.h>
#include <pcl/stereo/active_stereo_grabber.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <mutex>

namespace pcl::acmap::test {
namespace {

using testing::Contains;
using testing::HasSubstr;

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

TEST(CompactMappingObservations, thatClaimMoreThanTheyHoldAreRefused)
{
  const auto liar = std::make_shared<PointCloud<PointXYZRGB>>(4, 3);
  liar->width = 40;
  CompactMapping mapping;
  EXPECT_THROW(mapping.addObservation(liar), InitFailedException);
  EXPECT_EQ(mapping.getNumberOfObservations(), 0U);
}

/** Clouds that count how often each of them is read. */
class CountedSource : public ObservationSource {
public:
  CountedSource(std::vector<std::shared_ptr<const PointCloudFile>> clouds,
                Trajectory trajectory)
  : clouds_(std::move(clouds))
  , trajectory_(std::move(trajectory))
  , reads_(clouds_.size())
  {}

  std::string
  name() const override
  {
    return "counted clouds";
  }

  std::size_t
  size() const override
  {
    return clouds_.size();
  }

  Trajectory
  trajectory() const override
  {
    return trajectory_;
  }

  PointCloudFile
  load(std::size_t i) const override
  {
    const std::lock_guard lock(mutex_);
    ++reads_[i];
    return *clouds_[i];
  }

  std::size_t
  mostReads() const
  {
    return *std::max_element(reads_.begin(), reads_.end());
  }

private:
  std::vector<std::shared_ptr<const PointCloudFile>> clouds_;
  Trajectory trajectory_;
  mutable std::mutex mutex_;
  mutable std::vector<std::size_t> reads_;
};

TEST_F(OfficeViews, areReadThreeTimesAtMost)
{
  struct Case {
    bool has_poses, adjusts;
    std::size_t most;
  };
  for (const auto& [has_poses, adjusts, most] :
       {Case{true, false, 3}, Case{false, false, 3}, Case{true, true, 8}}) {
    const auto source = std::make_shared<CountedSource>(
        clouds_, has_poses ? trajectory_ : Trajectory());
    ObservationSequence sequence(source);
    sequence.setCacheSize(0);
    CompactMapping mapping;
    mapping.setInputSequence(sequence, has_poses);
    mapping.setAdjust(adjusts);
    CompactMap map;
    mapping.compute(map);
    EXPECT_GE(map.planes.size(), 3U);
    EXPECT_LE(source->mostReads(), most) << has_poses << adjusts;
  }
}

/** A map made by the paper's classes, one after the other. */
struct PaperMap {
  CompactMap map;
  Trajectory odometry; ///< before rectification
};

Trajectory
asInFiles(const Trajectory& trajectory)
{
  const TemporaryFolder folder;
  saveTrajectory(folder.path(trajectory_name), trajectory);
  return loadTrajectory(folder.path(trajectory_name));
}

/** Which steps are the paper's; the planes have a test of their own. */
struct PaperSteps {
  bool egomotion = true, rectification = true, raw = true, texture = true;
};

PaperMap
mappedByThePapersClasses(const ObservationSequence& sequence, const PaperSteps& paper)
{
  PaperMap result;
  VisualOdometry odometry;
  VisualOdometry::Egomotion egomotion;
  egomotion.setPaperMode(paper.egomotion);
  odometry.setEgomotion(egomotion);
  const VisualOdometryResult found = odometry.compute(sequence);
  std::vector<std::size_t> places;
  std::vector<double> stamps;
  for (std::size_t i = 0; i < sequence.size(); ++i)
    stamps.push_back(sequence.stamp(i));
  EstimatedPoses estimated = found.estimated(stamps);
  result.odometry = asInFiles(estimated.trajectory);

  EntropyRectification<PointNormal> rectification;
  rectification.setBinSize(0.05);
  if (paper.rectification)
    rectification.setMode(RectificationMode::Paper);
  SequenceConsolidation consolidation;
  consolidation.setRawPoints(paper.raw);
  ConsolidatedObservations observations;
  consolidation.compute(sequence.withPoses(estimated.places, result.odometry),
                        observations);
  for (std::size_t i = 0; i < observations.clouds.size(); ++i)
    rectification.addPointCloud(
        observations.clouds[i], result.odometry.poses[i], observations.weights[i]);
  rectification.compute();
  Trajectory rectified = result.odometry;
  for (std::size_t i = 0; i < rectified.poses.size(); ++i)
    rectified.poses[i] = rectification.getPose(i);
  const ObservationSequence posed =
      sequence.withPoses(estimated.places, asInFiles(rectified));

  ObservationMerging merging;
  MergedCloud merged;
  merging.compute(posed, merged);
  PlaneMapping planes;
  planes.setMode(MappingMode::Paper);
  planes.setInputCloud(merged.cloud);
  planes.setViewpoints(merged.viewpoints);
  MappedPlanes mapped;
  planes.compute(mapped);
  CompactMapping::Texturing texturing;
  texturing.setPaperMode(paper.texture);
  texturing.setPlanes(mapped.planes);
  for (std::size_t i = 0; i < posed.size(); ++i)
    texturing.addObservationLoader([&posed, i]() -> std::optional<TexturedObservation> {
      const PosedObservation seen = posed.load(i);
      return TexturedObservation{
          sharedCloud(seen.file), seen.T_map_camera, posed.stamp(i), true};
    });
  texturing.texture(result.map);
  return result;
}

bool
isSame(const CompactMap& a, const CompactMap& b)
{
  const auto bytesOf = [](const CompactMap& map) {
    std::vector<double> numbers;
    for (const PlanePatch& plane : map.planes)
      for (int i = 0; i < 4; ++i)
        numbers.push_back(plane.coefficients[i]);
    for (const TextureChart& chart : map.charts)
      numbers.insert(
          numbers.end(), chart.colors.values.begin(), chart.colors.values.end());
    for (const Eigen::Isometry3d& pose : map.trajectory.poses)
      numbers.insert(numbers.end(), pose.data(), pose.data() + 16);
    return numbers;
  };
  return bytesOf(a) == bytesOf(b) && a.observations == b.observations;
}

/** The same views with few points, for which the paper's planes do not take long. */
class SparseViews : public OfficeViews {
protected:
  static std::vector<std::shared_ptr<const PointCloudFile>>
  sparse()
  {
    std::vector<std::shared_ptr<const PointCloudFile>> clouds;
    for (const auto& dense : clouds_) {
      const auto file = std::make_shared<PointCloudFile>(*dense);
      PointCloud<PointXYZRGBSigma> points;
      fromPCLPointCloud2(dense->cloud, points);
      for (std::size_t i = 0; i < points.size(); ++i)
        if (i % 3 != 0)
          points[i].getVector3fMap().setConstant(
              std::numeric_limits<float>::quiet_NaN());
      toPCLPointCloud2(points, file->cloud);
      clouds.push_back(file);
    }
    return clouds;
  }
};

TEST_F(SparseViews, becomeInPaperModeTheMapOfThePapersClassesOneByOne)
{
  const ObservationSequence sequence(sparse());
  CompactMapping mapping;
  mapping.setMode(MappingMode::Paper);
  EXPECT_EQ(mapping.getMode(), MappingMode::Paper);
  mapping.setInputSequence(sequence, false);
  CompactMap map;
  mapping.compute(map);
  ASSERT_GE(map.planes.size(), 3U);
  ASSERT_EQ(map.trajectory.poses.size(), views);
  const PaperMap expected = mappedByThePapersClasses(sequence, {});
  EXPECT_TRUE(isSame(map, expected.map));
  for (std::size_t i = 0; i < views; ++i) // rounded as in a file
    EXPECT_TRUE(mapping.getOdometryTrajectory().poses[i].isApprox(
        expected.odometry.poses[i], 1e-15));
  for (const PaperSteps& departure : {PaperSteps{false, true, true, true},
                                      PaperSteps{true, false, true, true},
                                      PaperSteps{true, true, false, true},
                                      PaperSteps{true, true, true, false}})
    EXPECT_FALSE(isSame(map, mappedByThePapersClasses(sequence, departure).map))
        << departure.egomotion << departure.rectification << departure.raw
        << departure.texture;

  const CompactMappingReport& report = mapping.getReport();
  EXPECT_EQ(report.mode, MappingMode::Paper);
  for (const OdometryPair& pair : report.odometry->pairs) {
    EXPECT_TRUE(pair.report.is_paper);
    EXPECT_EQ(pair.report.fits, 1U);
    EXPECT_FALSE(pair.report.is_refined);
  }
  EXPECT_EQ(report.consolidation->representatives, 0U);
  EXPECT_GT(report.consolidation->points, 1000U);
  EXPECT_GT(report.rectification->votes, 0U);
  EXPECT_EQ(report.planes.mode, MappingMode::Paper);
  EXPECT_EQ(report.planes.consolidated_points, 0U);
}

TEST_F(SparseViews, becomeTheUsualMapAfterPaperMode)
{
  CompactMap maps[2];
  for (const bool was_paper : {false, true}) {
    CompactMapping mapping;
    if (was_paper) {
      mapping.setMode(MappingMode::Paper);
      mapping.setMode(MappingMode::Accurate);
    }
    mapping.setInputSequence(ObservationSequence(sparse()), false);
    mapping.compute(maps[was_paper]);
    EXPECT_EQ(mapping.getReport().mode, MappingMode::Accurate);
    EXPECT_GT(mapping.getReport().planes.consolidated_points, 0U);
  }
  EXPECT_TRUE(isSame(maps[0], maps[1]));
}

TEST(PaperMapping, takesTheMedianOfTheShotsAndItsPointsAsTheyAre)
{
  SimulatedScene scene = standardScene("office");
  makeSmall(scene, 8);
  scene.views.resize(1);
  std::vector<RgbImage> patterns;
  for (int shift = 0; shift < 4; ++shift) { // stripes that never repeat
    RgbImage pattern{1024, 768, {}};
    for (int row = 0; row < pattern.height; ++row)
      for (int column = 0; column < pattern.width; ++column)
        pattern.values.insert(
            pattern.values.end(),
            3,
            static_cast<std::uint8_t>((column / 8 + shift) * (column / 8) * 37 % 251));
    patterns.push_back(std::move(pattern));
  }
  const SimulatedRigGrabber grabber(scene, patterns);
  CompactMapping mapping;
  mapping.setMode(MappingMode::Paper);
  mapping.setInputRig(scene.rig);
  DisparityFusion fusion;
  fusion.setInputRig(scene.rig);
  fusion.setMethod(DisparityFusion::Method::Median);
  for (const TrinocularFrame::Ptr& shot : grabber.observe(0)) {
    mapping.addFrame(shot);
    fusion.addShot(shot);
  }
  CompactMap map;
  mapping.compute(map);
  MatchedDisparity disparity;
  fusion.fuse(disparity);
  DisparityBackProjection projection;
  projection.setInputRig(scene.rig);
  PointCloud<PointXYZRGBSigma> expected;
  projection.project(disparity, fusion.getColor(), expected);
  const PointView found = requirePoints(mapping.getMappedPlanes().vertices);
  std::size_t row = 0;
  for (const PointXYZRGBSigma& point : expected)
    if (point.getVector3fMap().allFinite()) {
      ASSERT_LT(row, found.size());
      ASSERT_EQ(found[row++], point.getVector3fMap());
    }
  EXPECT_EQ(row, found.size());
  EXPECT_GT(row, 100U);
}

TEST(PaperMapping, takesQuantisedDepthAsItIs)
{
  SimulatedScene office = standardScene("office");
  useKinect(office);
  makeSmall(office, 4);
  const auto file = std::make_shared<PointCloudFile>();
  file->cloud = cloudOf(observe(office, 0, 1));
  for (const MappingMode mode : {MappingMode::Accurate, MappingMode::Paper}) {
    CompactMapping mapping;
    mapping.setMode(mode);
    mapping.addObservation(file, Eigen::Isometry3d::Identity());
    CompactMap map;
    mapping.compute(map);
    const CompactMappingReport& report = mapping.getReport();
    EXPECT_EQ(report.merging.refined, mode == MappingMode::Paper ? 0U : 1U);
    EXPECT_FALSE(report.planes.depth_planes && mode == MappingMode::Paper);
  }
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

/** Expects that everything in a map is where it is in another one, seen from another frame. */
void
expectMoved(const Eigen::Isometry3d& T_b_a, const CompactMap& a, const CompactMap& b)
{
  constexpr double tolerance = 1e-5; // metres: coordinates are single precision
  ASSERT_EQ(a.planes.size(), b.planes.size());
  ASSERT_EQ(a.boxes.size(), b.boxes.size());
  ASSERT_EQ(a.recesses.size(), b.recesses.size());
  ASSERT_EQ(a.cylinders.size(), b.cylinders.size());
  ASSERT_EQ(a.details.vertices.size(), b.details.vertices.size());
  const auto expectNear = [&](const Eigen::Vector3d& there,
                              const Eigen::Vector3d& here) {
    EXPECT_LT((there - T_b_a * here).norm(), tolerance);
  };
  for (std::size_t i = 0; i < a.planes.size(); ++i) {
    const PlanePatch &here = a.planes[i], &there = b.planes[i];
    expectNear(there.center, here.center);
    EXPECT_LT(
        (there.coefficients.head<3>() - T_b_a.linear() * here.coefficients.head<3>())
            .norm(),
        tolerance);
    EXPECT_NEAR(there.center.dot(there.coefficients.head<3>()),
                -there.coefficients[3],
                tolerance);
    ASSERT_EQ(there.polygons.size(), here.polygons.size());
    for (std::size_t k = 0; k < here.polygons.size(); ++k)
      for (std::size_t corner = 0; corner < here.polygons[k].outer.size(); ++corner)
        expectNear(there.polygons[k].outer.at(corner).cast<double>(),
                   here.polygons[k].outer[corner].cast<double>());
  }
  for (std::size_t i = 0; i < a.boxes.size(); ++i)
    expectNear(b.boxes[i].center, a.boxes[i].center);
  for (std::size_t i = 0; i < a.recesses.size(); ++i)
    expectNear(b.recesses[i].center, a.recesses[i].center);
  for (std::size_t i = 0; i < a.cylinders.size(); ++i)
    expectNear(b.cylinders[i].axis_point, a.cylinders[i].axis_point);
  for (std::size_t i = 0; i < a.details.vertices.size(); ++i)
    expectNear(b.details.vertices[i].cast<double>(),
               a.details.vertices[i].cast<double>());
  for (std::size_t i = 0; i < a.trajectory.poses.size(); ++i)
    expectNear(b.trajectory.poses[i].translation(),
               a.trajectory.poses[i].translation());
  EXPECT_LT((b.up - T_b_a.linear() * a.up).norm(), tolerance);
}

TEST_F(OfficeViews, areMappedEquallyInEveryFrame)
{
  Eigen::Isometry3d frame(Eigen::Translation3d(3, -2, 1));
  frame.rotate(Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitZ()));
  frame.rotate(smallestRotation(-Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()));
  for (const bool adjusts : {false, true}) {
    CompactMap maps[2];
    for (const bool is_moved : {false, true}) {
      CompactMapping mapping;
      mapping.setAdjust(adjusts);
      for (std::size_t i = 0; i < views; ++i)
        mapping.addObservation(
            clouds_[i], is_moved ? frame * trajectory_.poses[i] : trajectory_.poses[i]);
      mapping.compute(maps[is_moved ? 1 : 0]);
    }
    ASSERT_GE(maps[0].planes.size(), 3U);
    expectMoved(frame, maps[0], maps[1]);
  }
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
  const auto run = [&](double bin_size, bool changed) {
    CompactMapping mapping;
    mapping.setFolder(folder.path("poses"));
    CompactMapping::Rectification rectification = mapping.getRectification();
    rectification.setBinSize(bin_size);
    mapping.setRectification(rectification);
    for (std::size_t i = 0; i < views; ++i)
      mapping.addObservation(clouds_[changed ? views - 1 - i : i]);
    std::pair<CompactMap, CompactMappingReport> result;
    mapping.compute(result.first);
    result.second = mapping.getReport();
    EXPECT_EQ(mapping.getOdometryTrajectory().poses.size(),
              result.first.trajectory.poses.size());
    return result;
  };
  const auto [first, first_report] = run(0.05, false);
  EXPECT_TRUE(first_report.odometry);
  EXPECT_TRUE(first_report.rectification);
  const auto [second, second_report] = run(0.05, false);
  EXPECT_FALSE(second_report.odometry);
  EXPECT_FALSE(second_report.rectification);
  EXPECT_THAT(second_report.remarks, Contains(HasSubstr("poses of an earlier run")));
  expectSame(first, second);
  const CompactMappingReport other = run(0.1, false).second;
  EXPECT_FALSE(other.odometry) << "its settings are the same";
  EXPECT_TRUE(other.rectification);
  EXPECT_TRUE(run(0.1, true).second.odometry) << "other observations";
}

/** Poses that are tilted and raised, as no rectification in the plane can mend. */
std::vector<Eigen::Isometry3d>
tilted(std::vector<Eigen::Isometry3d> poses)
{
  Eigen::Isometry3d drift = Eigen::Isometry3d::Identity();
  for (std::size_t i = 1; i < poses.size(); ++i) {
    drift.translate(Eigen::Vector3d(0, 0.03, 0));
    drift.rotate(Eigen::AngleAxisd(0.01, Eigen::Vector3d(1, 0, 0.5).normalized()));
    poses[i] = poses[i] * drift;
  }
  return poses;
}

TEST_F(OfficeViews, areAdjustedInSixDegreesOfFreedom)
{
  const std::vector<Eigen::Isometry3d> given = tilted(trajectory_.poses);
  const auto error = [](const std::vector<Eigen::Isometry3d>& poses) {
    double sum = 0;
    for (std::size_t i = 0; i < views; ++i)
      sum += (poses[i].translation() - trajectory_.poses[i].translation()).norm();
    return sum;
  };
  for (const bool rectifies : {false, true}) {
    const TemporaryFolder folder;
    const auto run = [&](bool adjusts, CompactMap& map) {
      CompactMapping mapping;
      mapping.setRectify(rectifies);
      mapping.setAdjust(adjusts);
      mapping.setFolder(folder.path("poses"));
      for (std::size_t i = 0; i < views; ++i)
        mapping.addObservation(clouds_[i], given[i]);
      mapping.compute(map);
      return mapping.getReport();
    };
    CompactMap map, again, off;
    const CompactMappingReport report = run(true, map);
    ASSERT_TRUE(report.adjustment);
    EXPECT_EQ(report.adjustment->outcome, AdjustmentOutcome::Adjusted)
        << report.adjustment->reason;
    EXPECT_LT(report.adjustment->thickness_after,
              0.5 * report.adjustment->thickness_before);
    EXPECT_LT(error(map.trajectory.poses), 0.3 * error(given)) << rectifies;
    const CompactMappingReport second = run(true, again);
    EXPECT_FALSE(second.adjustment) << "its poses are those of the earlier run";
    expectSame(map, again);
    EXPECT_FALSE(run(false, off).adjustment);
    EXPECT_GT(error(off.trajectory.poses), 0.5 * error(given)) << "is off by default";
  }
}

TEST_F(OfficeViews, thatFitAreNotAdjusted)
{
  CompactMapping mapping;
  mapping.setRectify(false);
  mapping.setAdjust(true);
  for (std::size_t i = 0; i < views; ++i)
    mapping.addObservation(clouds_[i], trajectory_.poses[i]);
  CompactMap map;
  mapping.compute(map);
  ASSERT_TRUE(mapping.getReport().adjustment);
  EXPECT_EQ(mapping.getReport().adjustment->outcome, AdjustmentOutcome::Kept);
  for (std::size_t i = 0; i < views; ++i)
    EXPECT_LT((map.trajectory.poses[i].matrix() - trajectory_.poses[i].matrix())
                  .cwiseAbs()
                  .maxCoeff(),
              1e-12);
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

/** Tells how many callbacks are registered. */
struct CountedGrabber : ActiveStereoGrabber {
  using ActiveStereoGrabber::ActiveStereoGrabber;

  template <typename PointT>
  int
  callbacks() const
  {
    return num_slots<PointCloudCallback<PointT>>();
  }
};

TEST(CompactMapping, takesTheCloudsWithNoiseOfAStereoGrabber)
{
  CountedGrabber grabber(std::make_shared<SimulatedRigGrabber>(
      standardScene("corridor"), std::vector<RgbImage>()));
  CompactMapping mapping;
  mapping.setInputGrabber(grabber);
  EXPECT_EQ(grabber.callbacks<PointXYZRGBSigma>(), 1);
  EXPECT_EQ(grabber.callbacks<PointXYZ>(), 0);
  EXPECT_EQ(grabber.callbacks<PointXYZRGB>(), 0);
  EXPECT_EQ(grabber.callbacks<PointXYZRGBA>(), 0);
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
  catch (const EmptyInputException& error) { // for views this small
    EXPECT_THAT(error.what(), HasSubstr("could be joined"));
  }
  EXPECT_EQ(mapping.getNumberOfObservations(), 2U);
}

} // namespace
} // namespace pcl::acmap::test
