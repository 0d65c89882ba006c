#pragma once

#include "painted_views.h"
#include "shot_contract.h"

#include <pcl/egomotion/correspondence_estimation_log_polar.h>

#include <limits>
#include <tuple>

namespace pcl::acmap::test {

/** \brief The output consists of matches: source, target, squared distance and
 * score. */
struct LogPolarTraits
: CommonTraits<registration::CorrespondenceEstimationLogPolar<PointXYZRGB>> {
  static constexpr const char* header =
      "egomotion/include/pcl/egomotion/correspondence_estimation_log_polar.h";
  using Output = std::vector<std::tuple<int, int, float, float>>;
  using CloudPtr = PointCloud<PointXYZRGB>::ConstPtr;

  static void
  match(Class& object, const CloudPtr& now, const CloudPtr& before, Output& output)
  {
    object.setInputSource(now);
    object.setInputTarget(before);
    Correspondences matches;
    object.determineCorrespondences(matches);
    output.clear();
    for (std::size_t i = 0; i < matches.size(); ++i)
      output.emplace_back(matches[i].index_query,
                          matches[i].index_match,
                          matches[i].distance,
                          object.getScores()[i]);
  }

  static void
  run(Class& object, int which, Output& output)
  {
    const Wallpaper paper(static_cast<std::uint64_t>(which));
    match(object, wallOf(paint(paper, {0.05})), wallOf(paint(paper)), output);
  }

  static Output
  sentinel()
  {
    return {{42, 43, 44.0F, 45.0F}};
  }

  static Calls
  refusedCalls()
  {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    return {
        {[](Class& o) { o.setGrid(1, 24); }, {"rings = 1 ", "[2, 64]"}},
        {[](Class& o) { o.setGrid(12, 200); }, {"sectors = 200 ", "[4, 128]"}},
        {[](Class& o) { o.setRadii(0.1F, 20); }, {"0.1", "[0.5, 200] px"}},
        {[](Class& o) { o.setRadii(5, 5); }, {"5", "above the inner", "px"}},
        {[=](Class& o) { o.setRadii(1, nan); }, {"nan", "[0.5, 200] px"}},
        {[](Class& o) { o.setMinimumScore(1.5F); }, {"1.5", "[-1, 1]"}},
        {[=](Class& o) { o.setMinimumScore(nan); }, {"nan", "[-1, 1]"}},
        {[](Class& o) { o.setMaximumAmbiguity(-0.5F); }, {"-0.5", "[0, 1]"}},
        {[](Class& o) { o.setMinimumContrast(-2); }, {"-2", "[0, 128] grey levels"}},
        {[](Class& o) { o.setMaximumShifts(11, 0); }, {"11", "[0, 10] rings"}},
        {[](Class& o) { o.setMaximumShifts(0, 13); }, {"13", "[0, 12] sectors"}},
        {[](Class& o) { o.setMaximumShifts(1, -1); }, {"-1", "[0, 12] sectors"}},
        {[](Class& o) { o.setMaximumImageDistance(0); }, {"= 0 ", "above 0 px"}},
        {[=](Class& o) { o.setMaximumImageDistance(nan); }, {"nan", "above 0 px"}}};
  }

  static std::vector<RefusedRun<Class, Output>>
  refusedRuns()
  {
    const auto wall = wallOf(paint(Wallpaper(1)));
    const PointCloud<PointXYZRGB>::Ptr row(new PointCloud<PointXYZRGB>(100, 1));
    return {{"no source",
             [=](Class& o, Output& output) { match(o, nullptr, wall, output); }},
            {"source no image",
             [=](Class& o, Output& output) { match(o, row, wall, output); }},
            {"target no image",
             [=](Class& o, Output& output) { match(o, wall, row, output); }}};
  }

  static std::string
  parameters(const Class& object)
  {
    const LogPolarSettings& settings = object.getSettings();
    std::ostringstream words;
    words << settings.rings << ' ' << settings.sectors << ' ' << settings.inner << ' '
          << settings.outer << ' ' << settings.min_contrast << ' ' << settings.min_score
          << ' ' << settings.max_ambiguity << ' ' << settings.ring_shifts << ' '
          << settings.sector_shifts << ' ' << object.getMaximumImageDistance() << ' '
          << object.getNumberOfThreads();
    return words.str();
  }
};

} // namespace pcl::acmap::test
