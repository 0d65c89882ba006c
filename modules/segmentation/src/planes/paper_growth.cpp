#include "planes/paper_growth.h"

#include "planes/unreached_points.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap::planes {

namespace {

/** The points of the hypotheses; NaN for a point without a normal. */
LargeVector<Eigen::Vector3d>
pointsOfHypotheses(const CellGraph& graph)
{
  LargeVector<Eigen::Vector3d> points = graph.points;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!graph.hasNormal(i))
      points[i].setConstant(std::numeric_limits<double>::quiet_NaN());
  return points;
}

/** Is it a plane, or do the points lie on one line, within a thousandth of its
 * length? */
bool
definesPlane(const PlaneFit& fit)
{
  constexpr double squared_width = 1e-6;
  return fit.count >= 3 && fit.variances[1] > squared_width * fit.variances[2];
}

/** Tests one hypothesis after the other. */
class PaperGrowth {
public:
  PaperGrowth(const CellGraph& graph,
              const PaperThresholds& thresholds,
              PlaneClusteringReport& report)
  : graph_(graph)
  , thresholds_(thresholds)
  , report_(report)
  , points_(pointsOfHypotheses(graph))
  , is_closed_(points_.size(), false)
  , open_(points_, thresholds.member_distance)
  {}

  /** Is it a hypothesis that supports no plane so far? */
  bool
  isOpen(std::int32_t i) const
  {
    return !is_closed_[static_cast<std::size_t>(i)] &&
           points_[static_cast<std::size_t>(i)].allFinite();
  }

  /** Adds the plane of a hypothesis if it has enough supporters. */
  void
  test(std::int32_t i, std::vector<GrownPlane>& planes)
  {
    ++report_.tested_hypotheses;
    GrownPlane plane = planeOf(i);
    open_.restore();
    const std::size_t supporters = plane.members.size() - 1; // without i itself
    if (supporters <= thresholds_.support || areCoincident(plane.members))
      return;
    for (const std::int32_t member : plane.members) {
      open_.remove(member);
      is_closed_[static_cast<std::size_t>(member)] = true;
    }
    plane.area = graph_.areaOf(plane.members);
    planes.push_back(std::move(plane));
  }

private:
  const Eigen::Vector3d&
  point(std::int32_t i) const
  {
    return graph_.points[static_cast<std::size_t>(i)];
  }

  const Eigen::Vector3f&
  normal(std::int32_t i) const
  {
    return graph_.normals[static_cast<std::size_t>(i)];
  }

  /** If all points coincide, there is no plane to estimate. */
  bool
  areCoincident(const std::vector<std::int32_t>& members) const
  {
    return std::all_of(members.begin(), members.end(), [&](std::int32_t member) {
      return point(member) == point(members.front());
    });
  }

  /** All hypotheses j other than i within W_d of new members and W_n of n_i become
   * candidates, in their order. */
  void
  collectCandidates(std::int32_t i, const std::int32_t* first, const std::int32_t* last)
  {
    const Eigen::Vector3d front = normal(i).cast<double>();
    const auto qualifies = [&](std::int32_t j) {
      return normal(j).cast<double>().dot(front) > thresholds_.cosine;
    };
    for (; first != last; ++first)
      open_.reachNear(
          *first, qualifies, [&](std::int32_t j) { candidates_.push_back(j); });
    std::sort(candidates_.begin(), candidates_.end());
  }

  /** The plane of hypothesis i and its supporters: each candidate within W_t of the
   * plane supports it, and the plane is estimated again with each of them, until none
   * of the others does. Lengths are relative to p_i. */
  GrownPlane
  planeOf(std::int32_t i)
  {
    candidates_.clear();
    open_.reach(i);
    const Eigen::Vector3d front = normal(i).cast<double>().normalized();
    Plane plane{front, 0};
    Moments moments = momentsOf(Eigen::Vector3d::Zero());
    GrownPlane grown;
    grown.members.push_back(i);
    std::vector<std::int32_t>& members = grown.members;
    for (std::size_t asked = 0; asked < members.size();) {
      if (asked == 0 || thresholds_.reach == SupporterReach::Members)
        collectCandidates(i, members.data() + asked, members.data() + members.size());
      asked = members.size();
      std::size_t left = 0;
      for (const std::int32_t j : candidates_) {
        const Eigen::Vector3d way = point(j) - point(i);
        if (std::abs(plane.distance(way)) >= thresholds_.plane_distance) {
          candidates_[left++] = j;
          continue;
        }
        members.push_back(j);
        moments += momentsOf(way);
        ++report_.reestimations;
        const PlaneFit fit = fitPlane(moments);
        if (definesPlane(fit))
          plane = planeThrough(fit, front);
      }
      candidates_.resize(left);
    }
    const Eigen::Vector3d& origin = point(i);
    plane.offset -= plane.normal.dot(origin);
    grown.plane = plane;
    grown.moments.addShifted(moments, origin.x(), origin.y(), origin.z());
    return grown;
  }

  const CellGraph& graph_;
  PaperThresholds thresholds_;
  PlaneClusteringReport& report_;
  LargeVector<Eigen::Vector3d> points_; ///< \ref pointsOfHypotheses
  std::vector<bool> is_closed_;         ///< supports a plane
  UnreachedPoints open_;                ///< by the plane that is grown
  std::vector<std::int32_t> candidates_;
};

} // namespace

std::vector<GrownPlane>
growAsPaper(const CellGraph& graph,
            const std::vector<std::int32_t>& hypotheses,
            const PaperThresholds& thresholds,
            const Progress& progress,
            PlaneClusteringReport& report)
{
  constexpr std::size_t parts = 100;
  constexpr double share_of_growth = 0.85; // of all steps of the clustering
  PaperGrowth growth(graph, thresholds, report);
  std::vector<GrownPlane> planes;
  std::size_t told = 0;
  for (std::size_t h = 0; h < hypotheses.size(); ++h) {
    if (h * parts >= told * hypotheses.size())
      progress.tell(share_of_growth * static_cast<double>(told++) / parts, "growing");
    if (growth.isOpen(hypotheses[h]))
      growth.test(hypotheses[h], planes);
  }
  return planes;
}

void
describeFit(const CellGraph& graph, const GrownPlane& grown, KnownPlane& known)
{
  PlanePatch& patch = known.patch;
  double squares = 0;
  for (const std::int32_t member : grown.members)
    squares += std::pow(
        grown.plane.distance(graph.points[static_cast<std::size_t>(member)]), 2);
  const double count = grown.moments.count;
  patch.rms = std::sqrt(squares / count);
  patch.covariance.setConstant(std::numeric_limits<double>::quiet_NaN());
  patch.effective_support = patch.covariance(0, 0);
  const PlaneFit fit = fitPlane(grown.moments);
  if (!definesPlane(fit) || count <= 3)
    return;
  const Eigen::Vector3d normal = patch.coefficients.head<3>();
  patch.axis_v = normal.cross(fit.long_axis).normalized();
  patch.axis_u = patch.axis_v.cross(normal);
  const double variance = squares / (count - 3); // three parameters were estimated
  const Eigen::Vector3d variances =
      variance / count * Eigen::Vector3d(1 / fit.variances[2], 1 / fit.variances[1], 1);
  if (variances.allFinite()) {
    patch.covariance = variances.asDiagonal();
    patch.effective_support = count;
  }
  known.half_size = (3 * fit.variances.reverse().head<2>()).cwiseSqrt();
}

} // namespace pcl::acmap::planes

double
pcl::acmap::secondsOfPaperGrowth(const PointView& points, double member_distance)
{
  constexpr std::size_t samples = 200;
  constexpr double seconds_per_pair = 2e-9;
  const std::size_t step = 1 + points.size() / samples;
  double pairs = 0, sampled = 0;
  for (std::size_t i = 0; i < points.size(); i += step, ++sampled)
    for (std::size_t k = 0; k < points.size(); ++k)
      pairs += (points[i] - points[k]).squaredNorm() <
               static_cast<float>(member_distance * member_distance);
  return seconds_per_pair * pairs * static_cast<double>(points.size()) /
         std::max(1.0, sampled);
}
