#include "naive_growth.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {
namespace {

/** Estimates the parameters by least squares, unless the members lie on a line. */
void
reestimate(const NaiveHypotheses& all, const Eigen::Vector3d& front, NaivePlane& plane)
{
  Eigen::MatrixX3d places(plane.members.size(), 3);
  for (std::size_t k = 0; k < plane.members.size(); ++k)
    places.row(static_cast<Eigen::Index>(k)) =
        all.points[static_cast<std::size_t>(plane.members[k])].transpose();
  const Eigen::Vector3d mean = places.colwise().mean();
  const Eigen::MatrixX3d off = places.rowwise() - mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(off.transpose() * off);
  if (!(solver.eigenvalues()[1] > 1e-6 * solver.eigenvalues()[2]))
    return;
  plane.normal = solver.eigenvectors().col(0);
  if (plane.normal.dot(front) < 0)
    plane.normal = -plane.normal;
  plane.offset = -plane.normal.dot(mean);
}

/** Is p_j within W_d of p_i, which is the first member, or of any of them?
 * \param[in] members that are asked, the first ones */
bool
isNear(const NaiveHypotheses& all,
       std::size_t j,
       const NaivePlane& plane,
       std::size_t members,
       const NaiveThresholds& limits)
{
  const auto first = plane.members.begin();
  return std::any_of(
      first,
      first + static_cast<std::ptrdiff_t>(limits.by_members ? members : 1),
      [&](std::int32_t member) {
        return (all.points[j] - all.points[static_cast<std::size_t>(member)]).norm() <
               limits.member_distance;
      });
}

/** Does hypothesis j, if it is near enough, support hypothesis i, whose plane is as known
 * so far? */
bool
supports(const NaiveHypotheses& all,
         std::size_t j,
         std::size_t i,
         const NaivePlane& plane,
         const NaiveThresholds& limits)
{
  return all.normals[j].dot(all.normals[i]) > std::cos(limits.angle) &&
         std::abs(plane.normal.dot(all.points[j]) + plane.offset) <
             limits.plane_distance;
}

} // namespace

NaiveGrowth
growNaively(const NaiveHypotheses& all,
            const NaiveThresholds& limits,
            const std::vector<std::int32_t>& order)
{
  NaiveGrowth growth;
  std::vector<bool> is_used(all.points.size(), false);
  for (const std::int32_t hypothesis : order) {
    const auto i = static_cast<std::size_t>(hypothesis);
    if (is_used[i])
      continue;
    ++growth.tested;
    NaivePlane plane{all.normals[i], -all.normals[i].dot(all.points[i]), {hypothesis}};
    std::vector<bool> is_member(all.points.size(), false);
    for (std::size_t before = 0; before < plane.members.size();) {
      before = plane.members.size();
      for (std::size_t j = 0; j < all.points.size(); ++j) {
        if (j == i || is_used[j] || is_member[j] ||
            !supports(all, j, i, plane, limits) ||
            !isNear(all, j, plane, before, limits))
          continue;
        is_member[j] = true;
        plane.members.push_back(static_cast<std::int32_t>(j));
        reestimate(all, all.normals[i], plane);
        ++growth.reestimations;
      }
    }
    if (plane.members.size() - 1 <= limits.support) // without i itself
      continue;
    std::sort(plane.members.begin(), plane.members.end());
    for (const std::int32_t member : plane.members)
      is_used[static_cast<std::size_t>(member)] = true;
    growth.planes.push_back(std::move(plane));
  }
  return growth;
}

} // namespace pcl::acmap::test
