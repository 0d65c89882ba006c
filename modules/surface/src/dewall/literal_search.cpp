#include "literal_search.h"

#include "ball_visit.h"

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

SourcePoints
pointsOf(const PointTree& all, const std::vector<std::int32_t>& members)
{
  SourcePoints points;
  points.reserve(members.size());
  for (const std::int32_t i : members)
    points.push_back(
        {{all.coordinates(0)[i], all.coordinates(1)[i], all.coordinates(2)[i]}, i});
  return points;
}

/** \brief Distance from the middle of the edge within which all smaller circles through
 * its ends lie. */
double
reachOfSmaller(const SideFrame& frame, const Apex& apex)
{
  const double cotangent = std::abs(apex.dot) / apex.cross;
  return frame.half_length * (cotangent + std::sqrt(1 + cotangent * cotangent));
}

/** \brief Keeps the point with the smallest circle among points that are tested one by
 * one. */
class SmallestCircle {
public:
  explicit SmallestCircle(const SideFrame& frame,
                          std::int32_t name_a,
                          std::int32_t name_b)
  : frame_(frame)
  , name_a_(name_a)
  , name_b_(name_b)
  {}

  /** \brief Returns true if the point is the best one so far. */
  bool
  consider(std::int32_t i, std::int32_t name, const Eigen::Vector3d& position)
  {
    const Apex apex = makeApex(name, frame_.u, position - frame_.origin);
    const double longest = std::max(
        frame_.u.squaredNorm(),
        std::max(apex.from_a.squaredNorm(), (apex.from_a - frame_.u).squaredNorm()));
    if (apex.cross <= min_sine * longest ||
        (frame_.hasHalfSpace() && apex.from_a.dot(frame_.outward) <= 0) ||
        (index_ >= 0 && !hasSmallerCircle(apex, best_, name_a_, name_b_, frame_.u)))
      return false;
    best_ = apex;
    index_ = i;
    return true;
  }

  std::int32_t
  index() const
  {
    return index_;
  }

  const Apex&
  best() const
  {
    return best_;
  }

private:
  const SideFrame& frame_;
  const std::int32_t name_a_, name_b_;
  Apex best_;
  std::int32_t index_ = -1;
};

} // namespace

LiteralPoints::LiteralPoints(const PointTree& all,
                             const SizeConstraint& size,
                             const std::vector<std::int32_t>& members)
: all_(all)
, size_(size)
, own_(pointsOf(all, members))
{}

std::optional<std::array<std::int32_t, 3>>
LiteralPoints::findFirstTriangle(const SplittingPlane& alpha) const
{
  const double offset = coordinate(alpha.point, alpha.axis);
  const auto distance = [&](std::int32_t i) {
    return std::abs(coordinate(i, alpha.axis) - offset);
  };
  std::vector<std::int32_t> near; // the others have no near enough p2
  for (std::int32_t i = 0; i < own_.size(); ++i)
    if (distance(i) <= longest(i))
      near.push_back(i);
  std::sort(near.begin(), near.end(), [&](std::int32_t i, std::int32_t j) {
    return distance(i) != distance(j) ? distance(i) < distance(j)
                                      : source(i) < source(j);
  });
  for (const std::int32_t p1 : near) {
    const std::int32_t p2 = nearestAcross(p1, alpha);
    if (p2 < 0 || !isNearEnough(p1, p2))
      continue;
    const SideFrame frame(own_, std::min(longest(p1), longest(p2)), p1, p2);
    const std::int32_t p3 = acceptedThird(frame);
    if (p3 >= 0)
      return std::array<std::int32_t, 3>{p1, p2, p3};
  }
  return std::nullopt;
}

std::int32_t
LiteralPoints::findTriangle(const TriangleSide& side) const
{
  return acceptedThird(SideFrame(
      own_, std::min(longest(side.a), longest(side.b)), side.a, side.b, side.opposite));
}

bool
LiteralPoints::isNearEnough(std::int32_t i, std::int32_t j) const
{
  return size_.allows(own_.source(i),
                      own_.source(j),
                      (own_.position(i) - own_.position(j)).squaredNorm());
}

std::int32_t
LiteralPoints::nearestAcross(std::int32_t p1, const SplittingPlane& alpha) const
{
  const Eigen::Vector3d centre = own_.position(p1);
  const bool is_left = isLeft(p1, alpha);
  double radius = longest(p1);
  double minimum = radius * radius;
  std::int32_t best = -1;
  visitBall(own_, p1, centre, radius, [&](auto, std::int32_t first, std::int32_t end) {
    for (std::int32_t i = first; i < end; ++i) {
      const double squared = (own_.position(i) - centre).squaredNorm();
      const bool is_nearer =
          squared < minimum ||
          (squared == minimum && (best < 0 || source(i) < source(best)));
      if (!is_nearer || isLeft(i, alpha) == is_left)
        continue;
      best = i;
      minimum = squared;
      radius = std::sqrt(squared);
    }
  });
  return best;
}

bool
LiteralPoints::isAccepted(std::int32_t a, std::int32_t b, std::int32_t p3) const
{
  return isNearEnough(a, p3) && isNearEnough(b, p3) && isSphereEmpty(own_, {b, a, p3});
}

std::int32_t
LiteralPoints::acceptedThird(const SideFrame& frame) const
{
  // Points that are out of reach would be refused. They matter only if their circle is
  // smaller than that of an accepted one, which is a long thin triangle then.
  const double reach = reachFromMiddle(frame);
  const std::int32_t p3 = smallestCircle(frame, reach);
  if (p3 < 0 || !isAccepted(frame.a, frame.b, p3))
    return -1;
  const double of_smaller =
      reachOfSmaller(frame, makeApex(p3, frame.u, own_.position(p3) - frame.origin));
  return of_smaller <= reach || smallestCircle(frame, of_smaller) == p3 ? p3 : -1;
}

std::int32_t
LiteralPoints::smallestCircle(const SideFrame& frame, double reach) const
{
  if (!frame.hasHalfSpace() || !isWithinFloats(frame.half_length))
    return smallestCircleOneByOne(frame, reach);
  ApexQuery query = apexQuery(own_, frame);
  query.reach = static_cast<float>(reach);
  SearchHits hits;
  findCircleCandidates(own_.cells(), query, hits);
  if (hits.count > SearchHits::capacity)
    return smallestCircleOneByOne(frame, reach);
  SmallestCircle smallest(frame, source(frame.a), source(frame.b));
  for (std::int32_t i = 0; i < hits.count; ++i)
    smallest.consider(
        hits.index[i], source(hits.index[i]), own_.position(hits.index[i]));
  return smallest.index();
}

std::int32_t
LiteralPoints::smallestCircleOneByOne(const SideFrame& frame, double reach) const
{
  SmallestCircle smallest(frame, source(frame.a), source(frame.b));
  double radius = reach;
  const auto visit = [&](std::int32_t, std::int32_t first, std::int32_t end) {
    for (std::int32_t i = first; i < end; ++i)
      if (i != frame.a && i != frame.b &&
          smallest.consider(i, source(i), own_.position(i)))
        radius = std::min(radius, reachOfSmaller(frame, smallest.best()));
  };
  visitBall(own_, frame.a, frame.origin + 0.5 * frame.u, radius, visit);
  return smallest.index();
}

} // namespace pcl::acmap::ACMAP_DEWALL
