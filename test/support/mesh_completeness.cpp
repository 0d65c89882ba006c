#include "mesh_completeness.h"

#include "face_edges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace pcl::acmap::test {
namespace {

/** Tests if a triangle can be added to a mesh. */
class Extension {
public:
  Extension(const Points& points, const Triangles& mesh, const CompletenessRule& rule)
  : points_(points)
  , rule_(rule)
  , mesh_(mesh)
  , edges_(edgesOf(mesh))
  , around_(facesAroundVertices(mesh, points.size()))
  , components_(mesh.size())
  {
    for (Triangle face : mesh) {
      std::sort(face.begin(), face.end());
      faces_.insert(face);
    }
    for (const auto& [edge, uses] : edges_)
      for (const EdgeUse& use : uses)
        components_.unite(uses.front().face, use.face);
  }

  const EdgeMap&
  edges() const
  {
    return edges_;
  }

  bool
  isUsed(std::int32_t point) const
  {
    return !around_[point].empty();
  }

  /** Checks size and shape only. */
  bool
  isWellFormed(const Triangle& t) const
  {
    for (int i = 0; i < 3; ++i)
      if (!points_[t[i]].allFinite())
        return false;
    for (int i = 0; i < 3; ++i)
      if (!rule_.edge_allowed(t[i], t[(i + 1) % 3]))
        return false;
    return areaRatio(points_[t[0]], points_[t[1]], points_[t[2]]) >=
           rule_.min_area_ratio;
  }

  /** Returns true if no point is inside the sphere by more than the slack. */
  bool
  hasEmptySphere(const Triangle& t) const
  {
    const SmallestSphere sphere =
        smallestCircumsphere(points_[t[0]], points_[t[1]], points_[t[2]]);
    const double limit = sphere.radius * (1 - rule_.sphere_slack);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const auto index = static_cast<std::int32_t>(i);
      if (index != t[0] && index != t[1] && index != t[2] &&
          (points_[i] - sphere.center).norm() < limit)
        return false;
    }
    return true;
  }

  /** Returns true if the mesh with this triangle satisfies all topological
   * guarantees. */
  bool
  canTake(const Triangle& t)
  {
    Triangle sorted = t;
    std::sort(sorted.begin(), sorted.end());
    return faces_.count(sorted) == 0 && edgesCanTake(t) && keepsOneFan(t);
  }

private:
  /** No edge gets three faces or a sharp fold, and all touched components can be
   * oriented consistently. */
  bool
  edgesCanTake(const Triangle& t)
  {
    std::map<std::size_t, bool> flips;
    for (int i = 0; i < 3; ++i) {
      const std::int32_t a = t[i];
      const std::int32_t b = t[(i + 1) % 3];
      const auto found = edges_.find(makeEdge(a, b));
      if (found == edges_.end())
        continue;
      if (found->second.size() > 1)
        return false;
      const EdgeUse& use = found->second.front();
      if (turnAngle(
              points_[a], points_[b], points_[use.apex], points_[t[(i + 2) % 3]]) >
          rule_.turn_limit - rule_.turn_slack)
        return false;
      const bool flip = use.forward == (a < b);
      const auto [known, is_new] = flips.emplace(components_.find(use.face), flip);
      if (!is_new && known->second != flip)
        return false;
    }
    return true;
  }

  bool
  keepsOneFan(const Triangle& t)
  {
    mesh_.push_back(t);
    const bool one = std::all_of(t.begin(), t.end(), [&](std::int32_t corner) {
      std::vector<std::size_t> around = around_[corner];
      around.push_back(mesh_.size() - 1);
      return countFans(mesh_, around, corner) == 1;
    });
    mesh_.pop_back();
    return one;
  }

  const Points& points_;
  const CompletenessRule& rule_;
  Triangles mesh_;
  EdgeMap edges_;
  std::vector<std::vector<std::size_t>> around_;
  FaceSets components_;
  std::set<Triangle> faces_;
};

template <typename Wanted>
void
forAllTriples(std::size_t size,
              const EdgeAllowed& edge_allowed,
              const Points& points,
              const Wanted& visit)
{
  const auto allowed = [&](std::int32_t a, std::int32_t b) {
    return points[a].allFinite() && points[b].allFinite() && edge_allowed(a, b);
  };
  const auto count = static_cast<std::int32_t>(size);
  for (std::int32_t a = 0; a < count; ++a)
    for (std::int32_t b = a + 1; b < count; ++b)
      if (allowed(a, b))
        for (std::int32_t c = b + 1; c < count; ++c)
          if (allowed(a, c) && allowed(b, c))
            visit(Triangle{a, b, c});
}

/** Cotangent of the angle a-p-b: the smaller it is, the closer is p in Delaunay's
 * sense. */
double
signedDistance(const Eigen::Vector3d& a,
               const Eigen::Vector3d& b,
               const Eigen::Vector3d& p)
{
  const Eigen::Vector3d u = a - p;
  const Eigen::Vector3d v = b - p;
  return u.dot(v) / u.cross(v).norm();
}

/** The apexes that may be the Delaunay-nearest one beyond an open edge: one, or several
 * that tie; none if a candidate that may or may not be valid could be nearer. */
Triangles
nearestApexes(const Points& points,
              const Extension& extension,
              const CompletenessRule& rule,
              const Edge& edge,
              std::int32_t behind)
{
  constexpr double tie = 1e-5;
  double minimum = std::numeric_limits<double>::infinity();
  double min_doubtful = minimum;
  std::vector<std::pair<double, Triangle>> candidates;
  const Eigen::Vector3d& a = points[edge.first];
  const Eigen::Vector3d& b = points[edge.second];
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto p = static_cast<std::int32_t>(i);
    if (p == edge.first || p == edge.second || p == behind || !points[i].allFinite())
      continue;
    const double turn = turnAngle(a, b, points[behind], points[i]);
    const double limit = std::min(rule.turn_limit, M_PI / 2);
    if (turn > limit + rule.turn_slack || !rule.edge_allowed(edge.first, p) ||
        !rule.edge_allowed(edge.second, p))
      continue;
    const double distance = signedDistance(a, b, points[i]);
    const Triangle triangle{edge.first, edge.second, p};
    if (turn > limit - rule.turn_slack || !extension.isWellFormed(triangle)) {
      min_doubtful = std::min(min_doubtful, distance);
      continue;
    }
    candidates.emplace_back(distance, triangle);
    minimum = std::min(minimum, distance);
  }
  Triangles nearest;
  if (min_doubtful > minimum + tie)
    for (const auto& [distance, triangle] : candidates)
      if (distance <= minimum + tie)
        nearest.push_back(triangle);
  return nearest;
}

} // namespace

Triangles
missingUnderPaperRule(const Points& points,
                      const Triangles& mesh,
                      const CompletenessRule& rule)
{
  Extension extension(points, mesh, rule);
  Triangles missing;
  forAllTriples(points.size(), rule.edge_allowed, points, [&](const Triangle& t) {
    if (extension.isWellFormed(t) && extension.canTake(t) &&
        extension.hasEmptySphere(t))
      missing.push_back(t);
  });
  return missing;
}

Triangles
missingUnderDenseRule(const Points& points,
                      const Triangles& mesh,
                      const CompletenessRule& rule)
{
  Extension extension(points, mesh, rule);
  Triangles missing;
  for (const auto& [edge, uses] : extension.edges()) {
    if (uses.size() != 1)
      continue;
    const Triangles nearest =
        nearestApexes(points, extension, rule, edge, uses.front().apex);
    if (!nearest.empty() &&
        std::all_of(nearest.begin(), nearest.end(), [&](const Triangle& t) {
          return extension.canTake(t);
        }))
      missing.push_back(nearest.front());
  }
  forAllTriples(points.size(), rule.edge_allowed, points, [&](const Triangle& t) {
    const bool unused = std::none_of(t.begin(), t.end(), [&](std::int32_t corner) {
      return extension.isUsed(corner);
    });
    if (unused && extension.isWellFormed(t) && extension.hasEmptySphere(t))
      missing.push_back(t);
  });
  return missing;
}

double
turnAngle(const Eigen::Vector3d& a,
          const Eigen::Vector3d& b,
          const Eigen::Vector3d& p,
          const Eigen::Vector3d& q)
{
  const Eigen::Vector3d axis = (b - a).normalized();
  const Eigen::Vector3d to_p = (p - a) - axis * axis.dot(p - a);
  const Eigen::Vector3d to_q = (q - a) - axis * axis.dot(q - a);
  return std::atan2(to_p.cross(to_q).norm(), -to_p.dot(to_q));
}

std::string
describe(const Points& points, const Triangle& triangle)
{
  std::ostringstream text;
  text.precision(9);
  text << "triangle";
  for (const std::int32_t corner : triangle)
    text << ' ' << corner << " (" << points[corner].transpose() << ')';
  return text.str();
}

} // namespace pcl::acmap::test
