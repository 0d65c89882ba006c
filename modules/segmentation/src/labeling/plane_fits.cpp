#include "labeling/plane_fits.h"

#include <Eigen/Geometry>

#include <cmath>

namespace pcl::acmap::labeling {
namespace {

constexpr double guess_weight = 1 / (0.0175 * 0.0175); // one degree, radians

/** Are there enough points for a fit? All of them may be outside of the gate. */
bool
canBeFitted(const PlaneSums& sums)
{
  constexpr std::size_t min_points = 3;
  return sums.points >= min_points && sums.best().matrix(2, 2) > 0;
}

/** Adds a guessed normal as a prior of the slopes. */
void
addGuess(const Eigen::Vector3d& guess, const PlanePatch& patch, FitSums& sums)
{
  const double along = guess.dot(patch.coefficients.head<3>());
  const Eigen::Vector2d slopes(-guess.dot(patch.axis_u) / along,
                               -guess.dot(patch.axis_v) / along);
  sums.matrix.topLeftCorner<2, 2>() += guess_weight * Eigen::Matrix2d::Identity();
  sums.right.head<2>() += guess_weight * slopes;
}

bool
needsGuess(const PlaneSums& sums, const KnownPlane& plane)
{
  constexpr double max_tilt =
      0.1; // radians; beyond it the points do not determine the tilt
  return plane.trust == PlaneTrust::Strip || !knowsTilt(sums.best(), max_tilt);
}

FitSums
withGuess(const PlaneSums& sums, const KnownPlane& plane, const Eigen::Vector3d& guess)
{
  FitSums fit = sums.best();
  if (needsGuess(sums, plane))
    addGuess(guess, plane.patch, fit);
  return fit;
}

/** Half sides of a rectangle with the variances of the points: a half side h has the
 * variance h^2 / 3. */
Eigen::Vector2d
halfSize(const FitSums& sums)
{
  const Eigen::Matrix3d mean = sums.matrix / sums.matrix(2, 2);
  const Eigen::Array2d variances =
      mean.diagonal().head<2>().array() - mean.col(2).head<2>().array().square();
  return (3 * variances.max(0.0)).sqrt();
}

/** Number of independent points that would determine the offset equally well; for
 * points without noise it is their number. */
double
effectiveSupport(const PlanePatch& patch, double count)
{
  const double square = patch.rms * patch.rms;
  const double variance = patch.covariance(2, 2);
  return count * variance <= square ? count : square / variance;
}

} // namespace

void
fitPlanes(const std::vector<PlaneSums>& sums,
          const std::vector<Eigen::Vector3d>& guesses,
          std::vector<KnownPlane>& planes)
{
  for (std::size_t p = 0; p < planes.size(); ++p) {
    if (!canBeFitted(sums[p]))
      continue;
    const FitSums fit = withGuess(sums[p], planes[p], guesses[p]);
    moveToFit(fit, planes[p].patch);
    setFrame(sums[p].best(), planes[p].patch);
  }
}

void
centerFrames(std::vector<PlaneSums>& sums, std::vector<KnownPlane>& planes)
{
  for (std::size_t p = 0; p < planes.size(); ++p) {
    if (!canBeFitted(sums[p]))
      continue;
    const PlanePatch before = planes[p].patch;
    setFrame(sums[p].best(), planes[p].patch);
    for (FitSums* fit : {&sums[p].fit, &sums[p].clean})
      *fit = movedSums(*fit, before, planes[p].patch);
  }
}

void
finishPlanes(const std::vector<PlaneSums>& sums,
             const std::vector<Eigen::Vector3d>& guesses,
             std::vector<KnownPlane>& planes)
{
  for (std::size_t p = 0; p < planes.size(); ++p) {
    PlanePatch& patch = planes[p].patch;
    patch.support = sums[p].points;
    patch.covariance.setConstant(std::nan(""));
    if (!canBeFitted(sums[p]))
      continue;
    const FitSums fit = withGuess(sums[p], planes[p], guesses[p]);
    const double guess = needsGuess(sums[p], planes[p]) ? guess_weight : 0;
    const double count = static_cast<double>(sums[p].points);
    planes[p].half_size = halfSize(sums[p].fit);
    const Eigen::Vector3d solution = moveToFit(fit, patch);
    patch.covariance = clusteredCovariance(fit, guess, solution, sums[p].clusters);
    patch.rms = std::sqrt(sums[p].squares / count);
    patch.effective_support = effectiveSupport(patch, count);
  }
}

} // namespace pcl::acmap::labeling
