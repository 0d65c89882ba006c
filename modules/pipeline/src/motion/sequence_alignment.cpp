#include "observations/locked_reader.h"

#include <pcl/core/exceptions.h>
#include <pcl/egomotion/revisit_detection.h>
#include <pcl/pipeline/sequence_alignment.h>

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace pcl {

namespace {

constexpr double degree = 3.14159265358979323846 / 180;

using Views = RevisitDetection<PointXYZRGBSigma>;

/** A motion between two maps, proposed by a place that both have seen. */
struct ProposedMotion {
  Eigen::Isometry3d T_target_source;
  Eigen::Vector3d place; ///< of the view, in the map of the source
};

/** \throws InputFileException if observations are no images */
void
addViews(const ObservationSequence& sequence,
         acmap::LockedReader& reader,
         Views& detection)
{
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    if (!acmap::isImage(sequence.load(i).file->cloud))
      throw InputFileException(sequence.path(i) +
                               ": places are recognised in organized observations with "
                               "colours only");
    detection.addPointCloudLoader(reader.loader<PointXYZRGBSigma>(i));
  }
}

bool
agree(const ProposedMotion& a, const ProposedMotion& b)
{
  constexpr double max_distance = 0.5, max_angle = 5 * degree; // metres
  for (const Eigen::Vector3d& place : {a.place, b.place})
    if ((a.T_target_source * place - b.T_target_source * place).norm() > max_distance)
      return false;
  return Eigen::AngleAxisd(a.T_target_source.linear().transpose() *
                           b.T_target_source.linear())
             .angle() < max_angle;
}

/** Those that agree with the one that has most of them; the first one of several. */
std::vector<ProposedMotion>
largestAgreement(const std::vector<ProposedMotion>& proposals)
{
  std::vector<ProposedMotion> largest;
  for (const ProposedMotion& proposal : proposals) {
    std::vector<ProposedMotion> agreeing;
    std::copy_if(proposals.begin(),
                 proposals.end(),
                 std::back_inserter(agreeing),
                 [&](const ProposedMotion& other) { return agree(proposal, other); });
    if (agreeing.size() > largest.size())
      largest = std::move(agreeing);
  }
  return largest;
}

/** The mean rotation, and the mean motion of the middle of the places. */
Eigen::Isometry3d
meanMotion(const std::vector<ProposedMotion>& motions)
{
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  for (const ProposedMotion& motion : motions) {
    sum += motion.T_target_source.linear();
    place += motion.place / static_cast<double>(motions.size());
  }
  Eigen::Vector3d moved = Eigen::Vector3d::Zero();
  for (const ProposedMotion& motion : motions)
    moved += motion.T_target_source * place / static_cast<double>(motions.size());
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(
      sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Isometry3d mean = Eigen::Isometry3d::Identity();
  mean.linear() = svd.matrixU() * svd.matrixV().transpose();
  mean.translation() = moved - mean.linear() * place;
  return mean;
}

/** The same motion in the xz plane, if its tilt may be an error of the places. */
Eigen::Isometry3d
inPlane(const Eigen::Isometry3d& motion)
{
  constexpr double max_tilt = 1 * degree;
  const Eigen::Vector3d up = motion.linear().col(1), ahead = motion.linear().col(2);
  if (std::acos(std::clamp(up.y(), -1.0, 1.0)) > max_tilt)
    return motion;
  Eigen::Isometry3d level = Eigen::Isometry3d::Identity();
  level.rotate(
      Eigen::AngleAxisd(std::atan2(ahead.x(), ahead.z()), Eigen::Vector3d::UnitY()));
  level.translation() = motion.translation();
  level.translation().y() = 0;
  return level;
}

} // namespace

std::optional<Eigen::Isometry3d>
SequenceAlignment::align(const ObservationSequence& source)
{
  if (!target_)
    throw acmap::InitFailed("there is no sequence to align with");
  const ObservationSequence& target = *target_;
  acmap::LockedReader target_reader(target), source_reader(source);
  Views detection;
  addViews(target, target_reader, detection);
  // empty views keep both sequences so far apart that only pairs of both are searched
  const std::size_t apart = std::max(target.size(), source.size());
  const auto nothing = std::make_shared<const PointCloud<PointXYZRGBSigma>>();
  for (std::size_t i = 0; i < apart; ++i)
    detection.addPointCloud(nothing);
  addViews(source, source_reader, detection);
  detection.setMinimumSeparation(apart);
  detection.setNumberOfThreads(threads_);
  detection.setProgressCallback(progress_);
  detection.compute();
  std::vector<ProposedMotion> proposals;
  for (const Revisit& revisit : detection.getRevisits()) {
    const Eigen::Isometry3d T_source_view =
        source.pose(revisit.later - target.size() - apart);
    proposals.push_back({target.pose(revisit.earlier) *
                             revisit.estimate.T_target_source * T_source_view.inverse(),
                         T_source_view.translation()});
  }
  const std::vector<ProposedMotion> agreeing = largestAgreement(proposals);
  SequenceAlignmentReport report;
  report.revisits = detection.getReport();
  report.places = proposals.size();
  report.agreeing = agreeing.size();
  report_ = std::move(report);
  if (agreeing.empty())
    return std::nullopt;
  const Eigen::Isometry3d motion = meanMotion(agreeing);
  return model_ == MotionModel::Planar ? inPlane(motion) : motion;
}

EstimatedPoses
extendedPoses(const ObservationSequence& joined,
              std::size_t earlier,
              SequenceAlignment& alignment,
              const std::optional<OdometryNoise>& noise)
{
  EstimatedPoses poses;
  poses.noise = noise;
  std::vector<std::size_t> later;
  Trajectory own;
  for (std::size_t i = 0; i < joined.size(); ++i) {
    poses.places.push_back(i);
    poses.trajectory.stamps.push_back(joined.stamp(i));
    poses.trajectory.poses.push_back(joined.pose(i));
    if (i < earlier)
      continue;
    later.push_back(i);
    own.stamps.push_back(joined.stamp(i));
    own.poses.push_back(joined.pose(i));
  }
  const std::optional<Eigen::Isometry3d> T_earlier_own =
      alignment.align(joined.withPoses(later, std::move(own)));
  if (!T_earlier_own)
    throw EmptyInputException(
        "no view sees a place of the map that is to be extended: of " +
        std::to_string(alignment.getReport().revisits.proposals) +
        " pairs of views that look alike, none fits in space");
  for (const std::size_t i : later)
    poses.trajectory.poses[i] = *T_earlier_own * poses.trajectory.poses[i];
  return poses;
}

} // namespace pcl
