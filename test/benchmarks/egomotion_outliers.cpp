#include "egomotion_matches.h"
#include "egomotion_tables.h"
#include "markdown_row.h"
#include "statistics.h"

#include <pcl/core/planar_pose.h>
#include <pcl/egomotion/correspondence_rejector_worst_out.h>
#include <pcl/egomotion/transformation_estimation_planar.h>

#include <cmath>

namespace pcl::acmap::bench {
namespace {

using Point = PointXYZRGB;

/** Result for some matches. */
struct PlanarResult {
  std::size_t kept = 0;
  PlanarAction action;
};

/** Accounts for noise along the ray, which grows with the square of the depth. */
double
weightOf(const Point& now, const Point& before)
{
  return 1 / (std::pow(now.z, 4) + std::pow(before.z, 4));
}

PlanarResult
planarMotion(const MatchedPair& pair, const Correspondences& matches)
{
  registration::CorrespondenceRejectorWorstOut rejector;
  rejector.setInputSource<Point>(pair.source);
  rejector.setInputTarget<Point>(pair.target);
  Correspondences kept;
  rejector.getRemainingCorrespondences(matches, kept);
  if (kept.empty())
    return {};
  std::vector<double> weights;
  for (const Correspondence& match : kept)
    weights.push_back(
        weightOf((*pair.source)[match.index_query], (*pair.target)[match.index_match]));
  registration::TransformationEstimationPlanar<Point, Point> estimation;
  estimation.setCorrespondenceWeights(weights);
  Eigen::Matrix4f motion;
  estimation.estimateRigidTransformation(*pair.source, *pair.target, kept, motion);
  const PlanarPose pose = planarPartOf(Eigen::Isometry3d(motion.cast<double>()));
  return {kept.size(), {pose.x, pose.z, pose.theta}};
}

Eigen::Vector3d
vectorOf(const PlanarAction& action)
{
  return {action.dx, action.dz, std::remainder(action.dtheta, 2 * M_PI)};
}

/** Root mean square of each component. */
Eigen::Vector3d
rmsOf(const std::vector<Eigen::Vector3d>& differences)
{
  Eigen::Vector3d squares = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& difference : differences)
    squares += difference.cwiseAbs2();
  return (squares / static_cast<double>(differences.size())).cwiseSqrt();
}

Eigen::Vector3d
foundAction(const MatchedPair& pair, const Correspondences& matches)
{
  return vectorOf(planarMotion(pair, matches).action);
}

Eigen::Vector3d
trueAction(const MatchedPair& pair)
{
  const PlanarPose truth = planarPartOf(pair.truth);
  return vectorOf({truth.x, truth.z, truth.theta});
}

/** \param[in] clean actions from all matches, without wrong ones
 * \param[in] noise standard deviations of their dx, dz (metres), dtheta (rad) */
void
printShare(const std::vector<MatchedPair>& pairs,
           const std::vector<Eigen::Vector3d>& clean,
           const Eigen::Vector3d& noise,
           double share)
{
  constexpr double percent = 100, centi = 100, degree = M_PI / 180;
  Random random(1);
  std::vector<Eigen::Vector3d> changes, losses, errors;
  std::vector<double> kept;
  std::size_t refused = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const SpoiltMatches matches = spoilt(pairs[i], share, random);
    const PlanarResult found = planarMotion(pairs[i], matches.all);
    refused += found.kept == 0 ? 1 : 0;
    if (found.kept == 0)
      continue;
    kept.push_back(static_cast<double>(found.kept));
    const Eigen::Vector3d action = vectorOf(found.action);
    const Eigen::Vector3d without = foundAction(pairs[i], matches.right);
    changes.push_back((action - without).cwiseQuotient(noise));
    losses.push_back((without - clean[i]).cwiseQuotient(noise));
    errors.push_back(action - trueAction(pairs[i]));
  }
  const Eigen::Vector3d change = rmsOf(changes), error = rmsOf(errors);
  MarkdownRow()
      .number(percent * share, 0)
      .count(pairs.size())
      .count(refused)
      .number(median(kept), 0)
      .atMost(change.x(), 1, 2)
      .atMost(change.y(), 1, 2)
      .atMost(change.z(), 1, 2)
      .number(rmsOf(losses).norm() / std::sqrt(3), 2)
      .number(centi * error.head<2>().norm(), 2)
      .number(error.z() / degree, 3)
      .print();
}

} // namespace

void
printEgomotionOutliers()
{
  constexpr double grain = 6;
  const EgomotionSequence sequence = driveThrough("corridor_drive", grain);
  std::vector<MatchedPair> pairs;
  for (std::size_t i = 0; i + 1 < sequence.clouds.size(); ++i)
    pairs.push_back(matchedPair(sequence, i));
  std::vector<Eigen::Vector3d> clean, off;
  for (const MatchedPair& pair : pairs) {
    clean.push_back(foundAction(pair, pair.matches));
    off.push_back(clean.back() - trueAction(pair));
  }
  printHead({"matches replaced, %",
             "pairs",
             "without a motion",
             "matches kept, median",
             "change by the wrong ones: of dx, rms, in its noise",
             "of dz",
             "of dtheta",
             "change by the loss of right ones, all three",
             "error of the place, rms, cm",
             "of the heading, degrees"});
  for (const double share : {0.0, 0.1, 0.2, 0.3, 0.4, 0.5})
    printShare(pairs, clean, rmsOf(off), share);
}

} // namespace pcl::acmap::bench
