#include "labeling/verdicts.h"

#include <Eigen/LU>

#include <cmath>
#include <optional>

namespace pcl::acmap::labeling {
namespace {

/** Covariance of the weighted fit, assuming independent points. */
Eigen::Matrix3d
covarianceOf(const FitSums& sums)
{
  return sums.matrix.inverse();
}

bool
isRefuted(const PlaneSums& sums, const KnownPlane& plane)
{
  constexpr std::size_t min_points = 20;
  constexpr double max_chi = 1.5;     // it is 1 if the noise is as expected
  constexpr double max_strip_chi = 2; // its points include those of rounded edges
  constexpr double max_tilt = 0.035;  // radians, one standard deviation
  constexpr double min_share = 0.2;   // of the points in voxels of its hypotheses
  if (sums.points < 3 || static_cast<double>(sums.points) <
                             min_share * static_cast<double>(sums.points_at_home))
    return true;
  const double chi = std::sqrt(sums.chi / static_cast<double>(sums.points));
  if (plane.trust == PlaneTrust::Sure)
    return !(chi <= 2 * max_chi);
  const double maximum = plane.trust == PlaneTrust::Strip ? max_strip_chi : max_chi;
  if (sums.points < min_points || !(chi <= maximum))
    return true;
  return plane.trust == PlaneTrust::Small && !knowsTilt(sums.best(), max_tilt);
}

/** Standard deviation of the position of a plane at a point, along the normal,
 * metres. */
double
deviationAt(const PlaneSums& sums,
            const PlanePatch& patch,
            const Eigen::Vector3d& point)
{
  const Eigen::Vector3d from_center = point - patch.center;
  const Eigen::Vector3d terms(
      from_center.dot(patch.axis_u), from_center.dot(patch.axis_v), 1.0);
  return std::sqrt(terms.dot(covarianceOf(sums.best()) * terms));
}

/** Additional deviation of the points of a patch if they are assigned to another plane
 * instead of their own: root mean square. */
double
deviation(const PlaneSums& sums, const PlanePatch& patch, const PlanePatch& from)
{
  const Eigen::Vector3d normal = from.coefficients.head<3>();
  const double offset = normal.dot(patch.center) + from.coefficients[3];
  const FitSums& fit = sums.best();
  const double u = normal.dot(patch.axis_u), v = normal.dot(patch.axis_v);
  return std::sqrt(offset * offset +
                   (u * u * fit.matrix(0, 0) + v * v * fit.matrix(1, 1)) /
                       fit.matrix(2, 2));
}

/** \return 0 if the part is within the permitted deviation of the whole; its offset if
 * that is larger but due to pose errors; nothing if it is not a part */
std::optional<double>
driftOfPart(std::size_t part,
            std::size_t whole,
            const std::vector<PlaneSums>& sums,
            const ViewSteps& steps,
            const std::vector<KnownPlane>& planes,
            double distance,
            double cosine)
{
  const PlanePatch& a = planes[part].patch;
  const PlanePatch& b = planes[whole].patch;
  if (a.coefficients.head<3>().dot(b.coefficients.head<3>()) < cosine)
    return std::nullopt;
  const double unsure = deviationAt(sums[whole], b, a.center);
  if (!(unsure <= distance))
    return std::nullopt; // the plane is too uncertain so far from its points
  const double own = std::sqrt(covarianceOf(sums[part].best())(2, 2));
  const double gap = deviation(sums[part], a, b);
  if (gap < distance + 2 * (own + unsure))
    return 0;
  if (gap < max_drift &&
      steps.ruleOut(gap, std::hypot(distance, planes[whole].warp), part, whole))
    return gap;
  return std::nullopt;
}

} // namespace

Verdicts
judge(const std::vector<PlaneSums>& sums,
      const ViewSteps& steps,
      const std::vector<std::int32_t>& shadows,
      const std::vector<KnownPlane>& planes,
      double distance,
      double cosine)
{
  Verdicts verdicts;
  verdicts.kept_as.assign(planes.size(), -1);
  verdicts.drift.assign(planes.size(), 0);
  for (std::size_t p = 0; p < planes.size(); ++p) {
    if (isRefuted(sums[p], planes[p])) {
      ++verdicts.refuted;
      continue;
    }
    verdicts.kept_as[p] = static_cast<std::int32_t>(p);
    for (std::size_t whole = 0; whole < p; ++whole) {
      if (verdicts.kept_as[whole] != static_cast<std::int32_t>(whole))
        continue;
      const std::optional<double> drift =
          shadows[p] == static_cast<std::int32_t>(whole)
              ? 0.0
              : driftOfPart(p, whole, sums, steps, planes, distance, cosine);
      if (!drift)
        continue;
      verdicts.kept_as[p] = static_cast<std::int32_t>(whole);
      verdicts.drift[whole] = std::max(verdicts.drift[whole], *drift);
      ++verdicts.merged;
      break;
    }
  }
  return verdicts;
}

} // namespace pcl::acmap::labeling
