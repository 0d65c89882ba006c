#pragma once

#include "shot_contract.h"
#include "stereo_matches.h"

#include <pcl/egomotion/correspondence_rejector_worst_out.h>
#include <pcl/point_types.h>

#include <limits>

namespace pcl::acmap::test {

/** \brief The output consists of the indices of the remaining matches. */
struct WorstOutTraits : CommonTraits<registration::CorrespondenceRejectorWorstOut> {
  static constexpr const char* header =
      "egomotion/include/pcl/egomotion/correspondence_rejector_worst_out.h";
  using Output = std::vector<int>;

  static PointCloud<PointXYZ>::Ptr
  cloudOf(const std::vector<Eigen::Vector3f>& places)
  {
    PointCloud<PointXYZ>::Ptr cloud(new PointCloud<PointXYZ>);
    for (const Eigen::Vector3f& place : places)
      cloud->emplace_back(place.x(), place.y(), place.z());
    return cloud;
  }

  static void
  run(Class& object, int which, Output& output)
  {
    StereoMatchSettings scene;
    scene.right = scene.wrong = 50;
    scene.seed = static_cast<std::uint64_t>(which + 1);
    const StereoMatches made = stereoMatches(scene);
    object.setInputSource<PointXYZ>(cloudOf(made.source));
    object.setInputTarget<PointXYZ>(cloudOf(made.target));
    reject(object, 100, output);
  }

  static void
  reject(Class& object, int matches, Output& output)
  {
    Correspondences given, remaining;
    for (int i = 0; i < matches; ++i)
      given.emplace_back(i, i, 0.0F);
    object.getRemainingCorrespondences(given, remaining);
    output.clear();
    for (const Correspondence& match : remaining)
      output.push_back(match.index_query);
  }

  static Output
  sentinel()
  {
    return {-42};
  }

  static Calls
  refusedCalls()
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {{[](Class& o) { o.setMaximumDistortion(0.9); },
             {"distortion", "0.9", "[1, 1000]"}},
            {[=](Class& o) { o.setMaximumDistortion(nan); }, {"distortion", "nan"}},
            {[](Class& o) { o.setMinimumDistance(-1); },
             {"distance", "-1", "[0, 1e+06]", " m"}},
            {[=](Class& o) { o.setMinimumDistance(nan); }, {"distance", "nan"}},
            {[](Class& o) { o.setMinimumMatches(2); }, {"matches", "2", "[3, 1e+06]"}},
            {[](Class& o) { o.setSampleSize(9); },
             {"sample", "9", "[10, 1e+06]", "matches"}},
            {[](Class& o) { o.setSampleSize(std::size_t(-1)); },
             {"sample", "[10, 1e+06]"}}};
  }

  static std::vector<RefusedRun<Class, Output>>
  refusedRuns()
  {
    return {{"no clouds", [](Class& o, Output& output) { reject(o, 9, output); }},
            {"no target",
             [](Class& o, Output& output) {
               o.setInputSource<PointXYZ>(cloudOf({{1, 2, 3}}));
               reject(o, 1, output);
             }},
            {"an index outside", [](Class& o, Output& output) {
               o.setInputSource<PointXYZ>(cloudOf({{1, 2, 3}}));
               o.setInputTarget<PointXYZ>(cloudOf({{1, 2, 3}}));
               reject(o, 2, output);
             }}};
  }

  static std::string
  parameters(const Class& object)
  {
    std::ostringstream words;
    words << object.getMaximumDistortion() << ' ' << object.getMinimumDistance() << ' '
          << object.getMinimumMatches() << ' ' << object.getSampleSize();
    return words.str();
  }
};

} // namespace pcl::acmap::test
