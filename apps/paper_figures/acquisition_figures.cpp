#include "figures.h"

#include "active_stereo/stereo_observation.h"
#include "figure_sheet.h"
#include "figure_views.h"
#include "session_shots.h"

#include <pcl/conversions.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

// thresholds for a single shot, above what the noise of the cameras reaches by chance
constexpr double min_texture = 2; // grey levels
constexpr double min_correlation = 0.5;

/** Computes disparities as pcl_active_stereo does. */
class Acquisition {
public:
  Acquisition(const std::string& session, unsigned threads)
  : shots_(session, threads)
  , range_(disparitiesBetween(shots_.rig(), options_.nearest, options_.farthest))
  , threads_(threads)
  {}

  const SessionShots&
  shots() const
  {
    return shots_;
  }

  MadeObservation
  together(const ObservationShots& shots, const std::string& method) const
  {
    StereoOptions options = options_;
    options.method = method;
    return ShotFusion(shots_.rig(), options, threads_)
        .make(shots, [](double, const std::string&) { return true; });
  }

  DisparityImage
  ofOne(const TrinocularFrame& shot) const
  {
    TrinocularMatching matching;
    matching.setInputRig(shots_.rig());
    matching.setXOffset(range_.least);
    matching.setMaxDisparity(range_.count);
    matching.setNumberOfThreads(threads_);
    // also for the shot without a pattern, which would otherwise be filled with guesses
    matching.setPeakFilter(min_texture);
    matching.setCorrelationThreshold(min_correlation);
    MatchedDisparity matched;
    matching.match(shot, matched);
    return matched.disparity;
  }

private:
  StereoOptions options_;
  SessionShots shots_;
  SearchRange range_;
  unsigned threads_;
};

/** The ends of the colour scale: the range of nearly all disparities. */
struct ColorRange {
  float least = 0, most = 1; // px

  explicit ColorRange(const DisparityImage& disparity)
  {
    std::vector<float> found;
    for (const float value : disparity.values)
      if (std::isfinite(value))
        found.push_back(value);
    if (found.empty())
      return;
    std::sort(found.begin(), found.end());
    const std::size_t cut = found.size() / 100;
    least = found[cut];
    most = std::max(found[found.size() - 1 - cut], least + 1e-3f);
  }

  RgbImage
  of(const DisparityImage& disparity) const
  {
    return coloredDisparity(disparity, least, most);
  }
};

RgbImage
reference(const TrinocularFrame& shot)
{
  return lightened(rgbOf(shot.image(RigCamera::Reference)));
}

RgbImage
modelOf(const MadeObservation& made, const FigureEye& eye, const OutputFolder& folder)
{
  PCLPointCloud2 cloud;
  toPCLPointCloud2(made.cloud, cloud);
  lighten(cloud);
  return drawn(folder, [&](const std::string& path) {
    saveSnapshot(path, cloud, surfaceOf(made.cloud), viewFrom(eye));
  });
}

RgbImage
fusionFigure(const Acquisition& acquisition,
             const FigurePlan& plan,
             const OutputFolder& folder)
{
  const ObservationShots shots = acquisition.shots().of(plan.fusion.observation);
  const MadeObservation median = acquisition.together(shots, "median");
  const MadeObservation all = acquisition.together(shots, "spacetime");
  const ColorRange colors(all.matched.disparity);
  std::vector<std::int32_t> shown = {TrinocularFrame::no_pattern};
  for (const std::size_t pattern : plan.patterns)
    shown.push_back(static_cast<std::int32_t>(pattern));
  std::vector<RgbImage> images, disparities;
  for (const std::int32_t pattern : shown) {
    const TrinocularFrame& shot = shotUnder(shots, pattern);
    images.push_back(reference(shot));
    disparities.push_back(colors.of(acquisition.ofOne(shot)));
  }
  return sheetOf({images,
                  disparities,
                  {colors.of(median.matched.disparity),
                   colors.of(all.matched.disparity),
                   modelOf(all, plan.fusion.eye, folder)}},
                 plan.width);
}

RgbImage
examplesFigure(const Acquisition& acquisition,
               const FigurePlan& plan,
               const OutputFolder& folder)
{
  std::vector<std::vector<RgbImage>> rows;
  for (const ObservationFigure& example : plan.acquisitions) {
    const ObservationShots shots = acquisition.shots().of(example.observation);
    const MadeObservation made = acquisition.together(shots, "spacetime");
    rows.push_back({reference(shotUnder(shots, TrinocularFrame::no_pattern)),
                    ColorRange(made.matched.disparity).of(made.matched.disparity),
                    modelOf(made, example.eye, folder)});
  }
  return sheetOf(rows, plan.width);
}

} // namespace

void
drawAcquisitions(const std::string& session,
                 const FigurePlan& plan,
                 unsigned threads,
                 const OutputFolder& folder)
{
  const Acquisition acquisition(session, threads);
  savePng(folder.path("fig2.png"),
          withFewLevels(fusionFigure(acquisition, plan, folder)));
  savePng(folder.path("fig3.png"),
          withFewLevels(examplesFigure(acquisition, plan, folder)));
}

} // namespace pcl::acmap
