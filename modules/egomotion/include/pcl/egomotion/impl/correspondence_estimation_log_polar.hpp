#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/arguments.h>
#include <pcl/egomotion/correspondence_estimation_log_polar.h>
#include <pcl/egomotion/impl/camera_image.h>

#include <numeric>
#include <string>
#include <utility>

namespace pcl {
namespace acmap {

/** \brief Keypoints of one cloud, with their points and patches. */
struct MatchedSide {
  std::vector<std::int32_t> pixels;
  std::vector<Eigen::Vector3f> points; ///< metres
  LogPolarPatches patches;
};

/** \param[in] indices the keypoints; if nullptr, they are detected */
template <typename PointT>
MatchedSide
matchedSideOf(const PointCloud<PointT>& cloud,
              const Indices* indices,
              const LogPolarSettings& settings)
{
  const GreyImage image = brightnessOf(cloud);
  MatchedSide side;
  if (indices) {
    for (const index_t index : *indices)
      if (isXYZFinite(cloud[index]))
        side.pixels.push_back(index);
  }
  else {
    Indices all(cloud.size());
    std::iota(all.begin(), all.end(), 0);
    KeypointSettings keypoints;
    keypoints.threads = settings.threads;
    KeypointCounts counts;
    side.pixels = gradientMaxima(image, placesIn(cloud, all), keypoints, counts);
  }
  for (const std::int32_t pixel : side.pixels)
    side.points.push_back(cloud[pixel].getVector3fMap());
  side.patches = logPolarPatches(image, side.pixels, settings);
  return side;
}

/** \brief Adds a remark if a run gives no match. */
inline void
remark(registration::LogPolarReport& report)
{
  if (report.matches > 0)
    return;
  const auto tell = [&](const char* side, std::size_t keypoints, std::size_t patches) {
    if (keypoints == 0)
      report.remarks.push_back(std::string("no keypoint of the ") + side +
                               " has a place");
    else if (patches == 0)
      report.remarks.push_back("all " + std::to_string(keypoints) +
                               " keypoints of the " + side +
                               " lie too near the border or lack contrast");
  };
  tell("source", report.source_keypoints, report.source_patches);
  tell("target", report.target_keypoints, report.target_patches);
  if (report.remarks.empty())
    report.remarks.push_back("no pair of patches is strong, distinct and mutual");
}

/** \brief Fills the report with the numbers of keypoints, patches and matches. */
inline void
fill(registration::LogPolarReport& report,
     const MatchedSide& source,
     const MatchedSide& target,
     const MatchCounts& counts,
     std::size_t matches)
{
  report.source_keypoints = source.pixels.size();
  report.target_keypoints = target.pixels.size();
  report.source_patches = source.patches.pixels.size();
  report.target_patches = target.patches.pixels.size();
  report.weak = counts.weak;
  report.ambiguous = counts.ambiguous;
  report.one_sided = counts.one_sided;
  report.matches = matches;
  remark(report);
}

} // namespace acmap

namespace registration {

template <typename PointSource, typename PointTarget, typename Scalar>
CorrespondenceEstimationLogPolar<PointSource, PointTarget, Scalar>::
    CorrespondenceEstimationLogPolar()
{
  corr_name_ = "CorrespondenceEstimationLogPolar";
}

template <typename PointSource, typename PointTarget, typename Scalar>
void
CorrespondenceEstimationLogPolar<PointSource, PointTarget, Scalar>::setGrid(int rings,
                                                                            int sectors)
{
  acmap::requireInRange("rings", rings, 2, 64, "rings");
  acmap::requireInRange("sectors", sectors, 4, 128, "sectors");
  acmap::requireInRange(
      "rings", rings, settings_.ring_shifts + 2, 64, "with the shifts that are set");
  acmap::requireInRange("sectors",
                        sectors,
                        2 * settings_.sector_shifts,
                        128,
                        "with the shifts that are set");
  settings_.rings = rings;
  settings_.sectors = sectors;
}

template <typename PointSource, typename PointTarget, typename Scalar>
void
CorrespondenceEstimationLogPolar<PointSource, PointTarget, Scalar>::setRadii(
    float inner, float outer)
{
  acmap::requireInRange("inner radius", inner, 0.5, 200, "px");
  acmap::requireInRange("outer radius", outer, 0.5, 200, "px");
  if (!(outer > inner))
    acmap::refuseArgument("outer radius", outer, "above the inner, in px");
  settings_.inner = inner;
  settings_.outer = outer;
}

template <typename PointSource, typename PointTarget, typename Scalar>
void
CorrespondenceEstimationLogPolar<PointSource, PointTarget, Scalar>::setMinimumScore(
    float score)
{
  acmap::requireInRange("minimum score", score, -1, 1, "(Pearson coefficient)");
  settings_.min_score = score;
}

template <typename PointSource, typename PointTarget, typename Scalar>
void
CorrespondenceEstimationLogPolar<PointSource, PointTarget, Scalar>::setMaximumAmbiguity(
    float ambiguity)
{
  acmap::requireInRange("maximum ambiguity", ambiguity, 0, 1, "(no unit)");
  settings_.max_ambiguity = ambiguity;
}

template <typename PointSource, typename PointTarget, typename Scalar>
void
CorrespondenceEstimationLogPolar<PointSource, PointTarget, Scalar>::setMinimumContrast(
    float contrast)
{
  acmap::requireInRange("minimum contrast", contrast, 0, 128, "grey levels");
  settings_.min_contrast = contrast;
}

template <typename PointSource, typename PointTarget, typename Scalar>
void
CorrespondenceEstimationLogPolar<PointSource, PointTarget, Scalar>::setMaximumShifts(
    int rings, int sectors)
{
  acmap::requireInRange("ring shifts", rings, 0, settings_.rings - 2, "rings");
  acmap::requireInRange("sector shifts", sectors, 0, settings_.sectors / 2, "sectors");
  settings_.ring_shifts = rings;
  settings_.sector_shifts = sectors;
}

template <typename PointSource, typename PointTarget, typename Scalar>
void
CorrespondenceEstimationLogPolar<PointSource, PointTarget, Scalar>::
    setMaximumImageDistance(float pixels)
{
  if (!(pixels > 0))
    acmap::refuseArgument("maximum image distance", pixels, "above 0 px");
  image_distance_ = pixels;
}

template <typename PointSource, typename PointTarget, typename Scalar>
void
CorrespondenceEstimationLogPolar<PointSource, PointTarget, Scalar>::
    determineCorrespondences(Correspondences& correspondences, double max_distance)
{
  acmap::requireImage<PointSource>(input_, indices_.get());
  acmap::requireImage<PointTarget>(target_, target_indices_.get());
  if (!(max_distance > 0))
    acmap::refuseArgument("maximum distance", max_distance, "above 0 m");
  LogPolarReport report;
  acmap::StepTimer timer(report);
  const acmap::MatchedSide source =
      acmap::matchedSideOf(*input_, indices_.get(), settings_);
  const acmap::MatchedSide target =
      acmap::matchedSideOf(*target_, target_indices_.get(), settings_);
  timer.finish("patches");
  acmap::MatchGate gate;
  gate.image_distance = image_distance_;
  if (max_distance < std::numeric_limits<float>::max())
    gate.distance = static_cast<float>(max_distance);
  acmap::MatchCounts counts;
  const std::vector<acmap::PatchMatch> matches = acmap::matchPatches(source.patches,
                                                                     target.patches,
                                                                     source.points,
                                                                     target.points,
                                                                     gate,
                                                                     settings_,
                                                                     counts);
  timer.finish("matching");

  Correspondences found;
  std::vector<float> scores;
  for (const acmap::PatchMatch& match : matches) {
    const auto from = static_cast<std::size_t>(match.source);
    const auto to = static_cast<std::size_t>(match.target);
    found.emplace_back(source.pixels[from],
                       target.pixels[to],
                       (source.points[from] - target.points[to]).squaredNorm());
    scores.push_back(match.score);
  }
  acmap::fill(report, source, target, counts, found.size());
  correspondences = std::move(found);
  scores_ = std::move(scores);
  report_ = std::move(report);
}

template <typename PointSource, typename PointTarget, typename Scalar>
void
CorrespondenceEstimationLogPolar<PointSource, PointTarget, Scalar>::
    determineReciprocalCorrespondences(Correspondences& correspondences,
                                       double max_distance)
{
  determineCorrespondences(correspondences, max_distance);
}

template <typename PointSource, typename PointTarget, typename Scalar>
auto
CorrespondenceEstimationLogPolar<PointSource, PointTarget, Scalar>::clone() const ->
    typename Base::Ptr
{
  return typename Base::Ptr(new CorrespondenceEstimationLogPolar(*this));
}

} // namespace registration
} // namespace pcl

#define PCL_INSTANTIATE_CorrespondenceEstimationLogPolar(T) \
  template class ACMAP_EXPORT pcl::registration::CorrespondenceEstimationLogPolar<T>;
