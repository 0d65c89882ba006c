#include "bad_clouds.h"
#include "face.h"

#include <pcl/egomotion/correspondence_estimation_log_polar.h>
#include <pcl/egomotion/correspondence_rejector_worst_out.h>
#include <pcl/egomotion/gradient_maximum_keypoint.h>
#include <pcl/egomotion/revisit_detection.h>
#include <pcl/egomotion/transformation_estimation_planar.h>
#include <pcl/egomotion/visual_egomotion.h>

namespace pcl::acmap::test {

namespace {

using Point = PointXYZRGB;
using View = Cloud::Ptr;

template <typename Class>
void
setIndicesOf(Class& object, const IndicesPtr& indices)
{
  object.setIndices(indices);
}

void
addKeypoints(std::vector<BadCase>& cases)
{
  using Class = GradientMaximumKeypoint<Point>;
  const auto set = [](Class& object, const View& view) {
    object.setInputCloud(as<Point>(view));
  };
  Face<Class> face(
      "GradientMaximumKeypoint",
      [=](Class& object) { set(object, goodView().makeShared()); },
      [](Class& object) {
        PointCloud<Point> keypoints;
        object.compute(keypoints);
        const GradientMaximumReport& report = object.getReport();
        return Given{keypoints.empty(),
                     !report.remarks.empty() || report.without_place > 0};
      });
  face.give("cloud", badClouds(), set)
      .give("indices", badIndices(goodView().size()), setIndicesOf<Class>)
      .number("gradient", &Class::setMinimumGradient)
      .number("keypoints", &Class::setMaximumKeypoints)
      .common([](Class& object, unsigned n) { object.setNumberOfThreads(n); })
      .addTo(cases);
}

void
addLogPolar(std::vector<BadCase>& cases)
{
  using Class = registration::CorrespondenceEstimationLogPolar<Point>;
  const auto set = [](Class& object, const View& view) {
    object.setInputSource(as<Point>(view));
  };
  Face<Class> face(
      "CorrespondenceEstimationLogPolar",
      [=](Class& object) {
        set(object, goodView().makeShared());
        object.setInputTarget(as<Point>(goodView().makeShared()));
        const auto some = std::make_shared<Indices>();
        for (index_t i = 0; i < 3072; i += 50)
          some->push_back(i);
        object.setIndicesSource(some);
        object.setIndicesTarget(some);
      },
      [](Class& object) {
        Correspondences matches;
        object.determineCorrespondences(matches);
        const auto& report = object.getReport();
        return Given{matches.empty(),
                     !report.remarks.empty() || report.source_keypoints < 62 ||
                         report.target_keypoints < 62};
      });
  face.give("cloud", badClouds(), set)
      .give("target",
            badClouds(),
            [](Class& object, const View& view) {
              object.setInputTarget(as<Point>(view));
            })
      .give("indices",
            badIndices(goodView().size()),
            [](Class& object, const IndicesPtr& i) { object.setIndicesSource(i); })
      .give("target indices",
            badIndices(goodView().size()),
            [](Class& object, const IndicesPtr& i) { object.setIndicesTarget(i); })
      .number("score", &Class::setMinimumScore)
      .number("ambiguity", &Class::setMaximumAmbiguity)
      .number("contrast", &Class::setMinimumContrast)
      .number("image distance", &Class::setMaximumImageDistance)
      .common([](Class& object, unsigned n) { object.setNumberOfThreads(n); })
      .addTo(cases);
}

void
addEgomotion(std::vector<BadCase>& cases)
{
  using Class = VisualEgomotion<PointXYZRGBSigma>;
  const auto set_source = [](Class& object, const View& view) {
    object.setInputSource(as<PointXYZRGBSigma>(view));
  };
  const auto set_target = [](Class& object, const View& view) {
    object.setInputTarget(as<PointXYZRGBSigma>(view));
  };
  const std::size_t points = goodView().size();
  Face<Class> face(
      "VisualEgomotion",
      [=](Class& object) {
        set_source(object, goodView().makeShared());
        set_target(object, goodView().makeShared());
        object.setNumberOfThreads(1);
      },
      [=](Class& object) {
        const bool is_found = object.compute().has_value();
        const EgomotionReport& report = object.getReport();
        const bool is_partial =
            report.source_points < points || report.target_points < points;
        return Given{!is_found, is_partial || given(false, report).is_told};
      });
  face.give("source", badClouds(), set_source)
      .give("target", badClouds(), set_target)
      .number("translation", &Class::setMaximumTranslation)
      .number("rotation", &Class::setMaximumRotation)
      .number("keypoints", &Class::setMaximumKeypoints)
      .common([](Class& object, unsigned n) { object.setNumberOfThreads(n); })
      .addTo(cases);
}

void
addRevisits(std::vector<BadCase>& cases)
{
  using Class = RevisitDetection<PointXYZRGBSigma>;
  const auto set = [](Class& object, const View& view) {
    object.clear();
    object.addPointCloud(as<PointXYZRGBSigma>(goodView().makeShared()));
    object.addPointCloud(as<PointXYZRGBSigma>(view));
  };
  Face<Class> face(
      "RevisitDetection",
      [=](Class& object) {
        object.setMinimumSeparation(1);
        set(object, goodView().makeShared());
        object.setNumberOfThreads(1);
      },
      [](Class& object) {
        object.compute();
        const RevisitReport& report = object.getReport();
        return Given{false,
                     report.points < 2 * goodView().size() ||
                         given(false, report).is_told};
      });
  face.give("cloud", badClouds(), set)
      .number("separation", &Class::setMinimumSeparation)
      .common([](Class& object, unsigned n) { object.setNumberOfThreads(n); })
      .addTo(cases);
}

Kinds<Correspondences>
badMatches(std::size_t points)
{
  const auto last = static_cast<index_t>(points - 1);
  const auto with = [=](index_t query, index_t match) {
    return [=] {
      Correspondences matches;
      for (index_t i = 0; i < last; i += 100)
        matches.emplace_back(i, i, 0.0F);
      matches.emplace_back(query, match, std::numeric_limits<float>::quiet_NaN());
      return matches;
    };
  };
  return {{"none", Answer::Any, [] { return Correspondences(); }},
          {"of a distance of NaN", Answer::Any, with(0, 0)},
          {"outside", Answer::Refused, with(0, last + 1)},
          {"outside of the source", Answer::Refused, with(last + 1, 0)},
          {"negative", Answer::Refused, with(-1, 0)},
          {"the most negative",
           Answer::Refused,
           with(0, std::numeric_limits<index_t>::min())}};
}

struct RejectorRun {
  registration::CorrespondenceRejectorWorstOut rejector;
  Correspondences matches;
};

void
addRejector(std::vector<BadCase>& cases)
{
  using Class = RejectorRun;
  const Kinds<Correspondences> matches = badMatches(goodView().size());
  Face<Class> face(
      "CorrespondenceRejectorWorstOut",
      [=](Class& run) {
        run.rejector.setInputSource<PointXYZ>(goodView().makeShared());
        run.rejector.setInputTarget<PointXYZ>(goodView().makeShared());
        run.matches = matches[1].make();
      },
      [](Class& run) {
        Correspondences kept;
        run.rejector.getRemainingCorrespondences(run.matches, kept);
        const auto& report = run.rejector.getReport();
        return Given{kept.empty(), !report.remarks.empty() || report.invalid > 0};
      });
  face.give("cloud",
            badClouds(),
            [](Class& run, const View& view) {
              run.rejector.setInputSource<PointXYZ>(view);
            })
      .give("rows",
            badRows(),
            [](Class& run, const PCLPointCloud2::Ptr& rows) {
              run.rejector.setTargetPoints(rows);
            })
      .give("matches",
            matches,
            [](Class& run, const Correspondences& given) { run.matches = given; })
      .common()
      .addTo(cases);
}

struct EstimationRun {
  registration::TransformationEstimationPlanar<PointXYZ, PointXYZ> estimation;
  View source;
  Correspondences matches;
};

void
addEstimation(std::vector<BadCase>& cases)
{
  using Class = EstimationRun;
  const Kinds<Correspondences> matches = badMatches(goodView().size());
  Kinds<Cloud::Ptr> clouds = badClouds();
  clouds.erase(clouds.begin()); // the parameter is a reference
  Face<Class> face(
      "TransformationEstimationPlanar",
      [=](Class& run) {
        run.source = goodView().makeShared();
        run.matches = matches[1].make();
      },
      [](Class& run) {
        Eigen::Matrix4f motion;
        if (!run.source)
          run.source.reset(new Cloud);
        run.estimation.estimateRigidTransformation(
            *run.source, goodView(), run.matches, motion);
        return Given{!motion.allFinite(), true}; // it has no report
      });
  face.give("matches",
            matches,
            [](Class& run, const Correspondences& given) { run.matches = given; })
      .give("cloud", clouds, [](Class& run, const View& view) { run.source = view; })
      .addTo(cases);
}

} // namespace

void
addViewCases(std::vector<BadCase>& cases)
{
  addKeypoints(cases);
  addLogPolar(cases);
  addEgomotion(cases);
  addRevisits(cases);
  addRejector(cases);
  addEstimation(cases);
}

} // namespace pcl::acmap::test
