#include "bad_clouds.h"
#include "face.h"

#include <pcl/mapping/entropy_rectification.h>
#include <pcl/mapping/map_entropy.h>
#include <pcl/mapping/map_levelling.h>
#include <pcl/mapping/plane_adjustment.h>
#include <pcl/pipeline/compact_mapping.h>
#include <pcl/pipeline/observation_merging.h>
#include <pcl/pipeline/sequence_adjustment.h>
#include <pcl/pipeline/sequence_alignment.h>
#include <pcl/pipeline/sequence_consolidation.h>
#include <pcl/pipeline/visual_odometry.h>
#include <pcl/texture/plane_texturing.h>

#include <algorithm>

namespace pcl::acmap::test {

namespace {

/** \param[in] set gives an object a good observation, and the cloud at the pose */
template <typename Class, typename Set>
Face<Class>&
givePosed(Face<Class>& face, const Set& set)
{
  return face
      .give("cloud",
            badClouds(),
            [=](Class& object, const Cloud::Ptr& cloud) {
              set(object, cloud, Eigen::Matrix4d::Identity());
            })
      .give("pose", badPoses(), [=](Class& object, const Eigen::Matrix4d& pose) {
        set(object, goodView().makeShared(), pose);
      });
}

template <typename Class>
void
setThreads(Class& object, unsigned threads)
{
  object.setNumberOfThreads(threads);
}

/** Two clouds with poses, of which the second one is bad.
 * \param[in] add (object, cloud, pose) */
template <typename Class, typename Add>
Face<Class>
posedFace(const std::string& name, const typename Face<Class>::Run& run, const Add& add)
{
  const Eigen::Matrix4d identity = Eigen::Matrix4d::Identity();
  const auto set = [=](Class& object, const Cloud::Ptr& cloud, const auto& pose) {
    object.clear();
    add(object, goodView().makeShared(), identity);
    add(object, cloud, pose);
  };
  Face<Class> face(
      name,
      [=](Class& object) {
        set(object, goodView().makeShared(), identity);
        object.setNumberOfThreads(1);
      },
      run);
  givePosed(face, set).common(setThreads<Class>);
  return face;
}

template <typename PointT>
struct AddTo {
  template <typename Class, typename Pose>
  void
  operator()(Class& object, const Cloud::Ptr& cloud, const Pose& pose) const
  {
    object.addPointCloud(as<PointT>(cloud), pose);
  }
};

template <typename Class>
Given
computed(Class& object)
{
  object.compute();
  return given(false, object.getReport());
}

Kinds<OdometryNoise>
badNoises()
{
  Kinds<OdometryNoise> kinds;
  for (const auto part : {&OdometryNoise::length, &OdometryNoise::turn_per_radian})
    for (const double value : odd_numbers)
      kinds.push_back({std::to_string(value), Answer::Any, [=] {
                         OdometryNoise noise;
                         noise.*part = value;
                         return noise;
                       }});
  return kinds;
}

void
addMaps(std::vector<BadCase>& cases)
{
  using Rectification = EntropyRectification<PointNormal>;
  posedFace<Rectification>(
      "EntropyRectification", computed<Rectification>, AddTo<PointNormal>())
      .give("noise",
            badNoises(),
            [](auto& object, const OdometryNoise& n) { object.setOdometryNoise(n); })
      .number("bin", &Rectification::setBinSize)
      .number("weight", &Rectification::setEntropyWeight)
      .number("mu", &Rectification::setProjectionWeight)
      .number("smoothing", &Rectification::setSmoothing)
      .addTo(cases);
  using Adjustment = PlaneAdjustment<PointXYZ>;
  posedFace<Adjustment>("PlaneAdjustment", computed<Adjustment>, AddTo<PointXYZ>())
      .give("noise",
            badNoises(),
            [](auto& object, const OdometryNoise& n) { object.setOdometryNoise(n); })
      .addTo(cases);
  using Levelling = MapLevelling<PointNormal>;
  posedFace<Levelling>("MapLevelling", computed<Levelling>, AddTo<PointNormal>())
      .addTo(cases);
}

void
addEntropy(std::vector<BadCase>& cases)
{
  using Class = MapEntropy<PointXYZ>;
  const auto set = [](Class& object, const Cloud::Ptr& cloud, const PlanarPose& pose) {
    object.clear();
    object.addPointCloud(goodView().makeShared());
    object.addPointCloud(cloud, pose);
  };
  Face<Class> face(
      "MapEntropy",
      [=](Class& object) {
        set(object, goodView().makeShared(), {});
        object.setNumberOfThreads(1);
      },
      [](Class& object) {
        object.compute();
        return given(false, object.getReport());
      });
  Kinds<PlanarPose> poses;
  for (const double value : odd_numbers)
    poses.insert(poses.end(),
                 {{"x " + std::to_string(value),
                   Answer::Any,
                   [=] {
                     return PlanarPose{value, 0, 0};
                   }},
                  {"theta " + std::to_string(value), Answer::Any, [=] {
                     return PlanarPose{0, 0, value};
                   }}});
  face.give("cloud",
            badClouds(),
            [=](Class& object, const Cloud::Ptr& cloud) { set(object, cloud, {}); })
      .give("pose",
            poses,
            [=](Class& object, const PlanarPose& pose) {
              set(object, goodView().makeShared(), pose);
            })
      .number("bin", &Class::setBinSize)
      .number("smoothing", &Class::setSmoothing)
      .number("mu", &Class::setProjectionWeight)
      .common(setThreads<Class>)
      .addTo(cases);
}

void
addTexturing(std::vector<BadCase>& cases)
{
  using Class = PlaneTexturing<PointXYZRGB>;
  const auto set =
      [](Class& object, const Cloud::Ptr& cloud, const Eigen::Matrix4d& pose) {
        object.clearObservations();
        object.addObservation(as<PointXYZRGB>(cloud), pose);
      };
  const Eigen::Matrix4d identity = Eigen::Matrix4d::Identity();
  Face<Class> face(
      "PlaneTexturing",
      [=](Class& object) {
        object.setPlanes({goodPlane()});
        set(object, goodView().makeShared(), identity);
        object.setNumberOfThreads(1);
      },
      [](Class& object) {
        CompactMap map;
        object.texture(map);
        return given(map.charts.empty(), object.getReport());
      });
  givePosed(face, set)
      .give("planes",
            badPlanes(),
            [](Class& object, const std::vector<PlanePatch>& planes) {
              object.setPlanes(planes);
            })
      .give("planes",
            badPolygons(),
            [](Class& object, const std::vector<PlanePatch>& planes) {
              object.setPlanes(planes);
            })
      .number("texel size", &Class::setTexelSize)
      .number("distance", &Class::setMaximumDistance)
      .number("texture size", &Class::setMaximumTextureSize)
      .number("fill distance", &Class::setFillDistance)
      .common(setThreads<Class>)
      .addTo(cases);
}

using FilePtr = std::shared_ptr<const PointCloudFile>;

FilePtr
fileOf(const PCLPointCloud2::Ptr& rows)
{
  if (!rows)
    return nullptr;
  const auto file = std::make_shared<PointCloudFile>();
  file->cloud = *rows;
  return file;
}

void
addCompactMapping(std::vector<BadCase>& cases)
{
  using Class = CompactMapping;
  const auto set = [](Class& object, const FilePtr& file, const Eigen::Matrix4d& pose) {
    Eigen::Matrix4d before = Eigen::Matrix4d::Identity();
    before(0, 3) = 0.01;
    object.clear();
    object.addObservation(as<PointXYZRGB>(goodView().makeShared()), before);
    object.addObservation(file, acmap::RigidMotion(pose));
  };
  const auto good = [] { return fileOf(asRows(goodView().makeShared())); };
  const Eigen::Matrix4d identity = Eigen::Matrix4d::Identity();
  Face<Class> face(
      "CompactMapping",
      [=](Class& object) {
        set(object, good(), identity);
        object.setNumberOfThreads(1);
      },
      [](Class& object) {
        CompactMap map;
        object.compute(map);
        const bool is_partial =
            object.getReport().merging.points < 2 * goodView().size();
        return Given{map.planes.empty(),
                     is_partial || given(false, object.getReport()).is_told};
      });
  face.give("file",
            badRows(),
            [=](Class& object, const PCLPointCloud2::Ptr& rows) {
              set(object, fileOf(rows), identity);
            })
      .give("cloud",
            badClouds(),
            [=](Class& object, const Cloud::Ptr& cloud) {
              object.clear();
              object.addObservation(as<PointXYZRGB>(goodView().makeShared()), identity);
              object.addObservation(as<PointXYZRGB>(cloud), identity);
            })
      .give("pose",
            badPoses(),
            [=](Class& object, const Eigen::Matrix4d& pose) {
              set(object, good(), pose);
            })
      .number("interval", &Class::setProvisionalInterval)
      .common(setThreads<Class>)
      .addTo(cases);
}

/** A class whose input is a sequence, with its observations. */
template <typename ClassT>
struct SequenceRun {
  ClassT object;
  std::vector<FilePtr> files;
  Trajectory trajectory;

  void
  set(const FilePtr& second)
  {
    files = {fileOf(asRows(goodView().makeShared())), second};
    trajectory.stamps = {0, 1};
    trajectory.poses.assign(2, Eigen::Isometry3d::Identity());
    trajectory.poses[1].translation().x() = 0.01;
  }

  ObservationSequence
  sequence() const
  {
    return ObservationSequence(files, trajectory);
  }
};

template <typename ClassT>
Face<SequenceRun<ClassT>>
sequenceFace(
    const std::string& name,
    const typename Face<SequenceRun<ClassT>>::Run& run,
    const typename Face<SequenceRun<ClassT>>::Change& good = [](SequenceRun<ClassT>&) {
    })
{
  using Class = SequenceRun<ClassT>;
  Face<Class> face(
      name,
      [=](Class& state) {
        state.set(fileOf(asRows(goodView().makeShared())));
        state.object.setNumberOfThreads(1);
        good(state);
      },
      run);
  face.give("file",
            badRows(),
            [](Class& state, const PCLPointCloud2::Ptr& rows) {
              state.set(fileOf(rows));
            })
      .give("pose",
            badPoses(),
            [](Class& state, const Eigen::Matrix4d& pose) {
              state.trajectory.poses[1].matrix() = pose;
            })
      .common([](Class& state, unsigned n) { state.object.setNumberOfThreads(n); });
  return face;
}

/** Tells a pair that points are missing, or that it has no motion? */
bool
isPartial(const VisualOdometryResult& result)
{
  return std::any_of(
      result.pairs.begin(), result.pairs.end(), [](const OdometryPair& pair) {
        return !pair.estimate || pair.report.source_points < goodView().size() ||
               pair.report.target_points < goodView().size();
      });
}

/** The points of two views are counted where some are missing. */
template <typename Report>
Given
counted(const Report& report)
{
  return {report.points == 0,
          report.points < 2 * goodView().size() || given(false, report).is_told};
}

void
addSequences(std::vector<BadCase>& cases)
{
  using Odometry = SequenceRun<VisualOdometry>;
  sequenceFace<VisualOdometry>("VisualOdometry", [](Odometry& state) {
    const VisualOdometryResult result = state.object.compute(state.sequence());
    return Given{false, isPartial(result) || !state.object.getReport().remarks.empty()};
  }).addTo(cases);
  using Merging = SequenceRun<ObservationMerging>;
  sequenceFace<ObservationMerging>("ObservationMerging", [](Merging& state) {
    MergedCloud merged;
    state.object.compute(state.sequence(), merged);
    return counted(state.object.getReport());
  }).addTo(cases);
  using Consolidation = SequenceRun<SequenceConsolidation>;
  sequenceFace<SequenceConsolidation>("SequenceConsolidation",
                                      [](Consolidation& state) {
                                        ConsolidatedObservations result;
                                        state.object.compute(state.sequence(), result);
                                        return counted(state.object.getReport());
                                      })
      .addTo(cases);
  using Adjustment = SequenceRun<SequenceAdjustment>;
  sequenceFace<SequenceAdjustment>("SequenceAdjustment", [](Adjustment& state) {
    Trajectory trajectory;
    state.object.compute(state.sequence(), trajectory);
    return given(trajectory.poses.empty(), state.object.getReport());
  }).addTo(cases);
  using Alignment = SequenceRun<SequenceAlignment>;
  sequenceFace<SequenceAlignment>(
      "SequenceAlignment",
      [](Alignment& state) {
        state.object.align(state.sequence());
        const SequenceAlignmentReport& report = state.object.getReport();
        return Given{false,
                     report.revisits.points < 4 * goodView().size() ||
                         given(false, report).is_told};
      },
      [](Alignment& state) { state.object.setInputTarget(state.sequence()); })
      .addTo(cases);
}

} // namespace

void
addMapCases(std::vector<BadCase>& cases)
{
  addMaps(cases);
  addEntropy(cases);
  addTexturing(cases);
  addCompactMapping(cases);
  addSequences(cases);
}

} // namespace pcl::acmap::test
