#include "revisits/revisit_check.h"

#include "chain/egomotion_view.h"
#include "chain/estimate_from_pairs.h"
#include "revisits/depth_agreement.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::acmap {

namespace {

// Of wrong pairs, which look alike, at most nine of the matches agree by chance.
constexpr std::size_t min_inliers = 12;
constexpr double min_spread = 0.1;   // of the mean distance of the points
constexpr double min_overlap = 0.15; // share of the points
constexpr double max_contradicted = 0.05;

/** Standard deviation of places in the second of their principal directions, in units of
 * their mean distance: 0 for points on a line. */
double
spreadOf(const std::vector<FeaturePair>& pairs)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double distance = 0;
  for (const FeaturePair& pair : pairs) {
    mean += pair.target;
    distance += pair.target.norm();
  }
  const auto count = static_cast<double>(pairs.size());
  mean /= count;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const FeaturePair& pair : pairs)
    scatter += (pair.target - mean) * (pair.target - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter / count,
                                                              Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(solver.eigenvalues()[1], 0.0)) / (distance / count);
}

EgomotionSettings
settingsOfRevisits()
{
  EgomotionSettings settings;
  settings.model = MotionModel::Rigid;
  settings.solver = MotionSolver::ClosedForm;
  settings.max_translation = 1e6; // keypoints with descriptors need no bounds
  settings.max_rotation = M_PI;
  return settings;
}

} // namespace

bool
areConsistent(const std::vector<FeaturePair>& alike)
{
  if (alike.size() < min_inliers)
    return false;
  const std::vector<FeaturePair> pairs =
      consistentPairs(alike, settingsOfRevisits().worst_out);
  return pairs.size() >= min_inliers && spreadOf(pairs) >= min_spread;
}

std::optional<Revisit>
verifyRevisit(CameraView later,
              CameraView earlier,
              const std::vector<FeaturePair>& alike)
{
  const EgomotionSettings settings = settingsOfRevisits();
  completeSigmas(later);
  completeSigmas(earlier);
  const EgomotionView source = withoutFeatures(later, settings);
  const EgomotionView target = withoutFeatures(earlier, settings);
  EgomotionReport report;
  const EgomotionSolution solution =
      estimateFromPairs(source, target, alike, settings, report);
  if (!solution.estimate || report.inliers < min_inliers)
    return std::nullopt;
  const DepthAgreement depths =
      compareDepths(later, earlier, solution.estimate->T_target_source);
  if (depths.overlap < min_overlap || depths.contradicted > max_contradicted)
    return std::nullopt;
  Revisit revisit;
  revisit.estimate = *solution.estimate;
  revisit.matches = alike.size();
  revisit.inliers = report.inliers;
  revisit.overlap = depths.overlap;
  revisit.contradicted = depths.contradicted;
  return revisit;
}

} // namespace pcl::acmap
