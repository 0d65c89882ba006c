#include "refill.h"

#include "seed_test.h"

namespace pcl::acmap::dewall {

namespace {

/** \brief So many unused points round an unused one are combined to a first triangle. */
constexpr std::size_t largest_neighbourhood = 64;

} // namespace

Refill::Refill(const PointTree& tree,
               const SizeConstraint& size,
               DeWallRule rule,
               GrowingMesh& mesh,
               std::function<void()> tick)
: tree_(tree)
, size_(size)
, rule_(rule)
, mesh_(mesh)
, tick_(std::move(tick))
, rim_(static_cast<std::size_t>(tree.size()), {-1, -1, -1})
, unused_(static_cast<std::size_t>(tree.nodeCount()))
, counted_(static_cast<std::size_t>(tree.size()))
{
  queue_ = mesh_.openSides();
  for (const Side& side : queue_)
    turnEdge(side.a, side.b);
  for (std::int32_t i = 0; i < tree_.size(); ++i) {
    if (mesh_.isUsed(i))
      counted_[static_cast<std::size_t>(i)] = true;
    else
      for (std::int32_t n = tree_.leafOf(i); n >= 0; n = tree_.node(n).parent)
        ++unused_[static_cast<std::size_t>(n)];
  }
}

void
Refill::run()
{
  workOff();
  // Where first triangles that keep the tie rule have failed, any empty sphere will do.
  for (const Ties ties : {Ties::Matter, Ties::DoNotMatter})
    for (std::int32_t p1 = 0; p1 < tree_.size(); ++p1)
      if (!mesh_.isUsed(p1))
        startAt(p1, ties);
  reconsider();
}

void
Refill::workOff()
{
  for (std::size_t next = 0; next < queue_.size(); ++next) {
    const Side side = queue_[next];
    closeSide(side);
    tick_();
  }
  queue_.clear();
}

void
Refill::reconsider()
{
  std::size_t before = 0;
  do {
    before = mesh_.triangles().size();
    for (const Refusal& refusal : std::exchange(refused_, {})) {
      if (mesh_.oppositeOf(refusal.side) < 0)
        continue;
      if (!closeWith(refusal.side, refusal.apex))
        refused_.push_back(refusal);
      workOff();
    }
  } while (mesh_.triangles().size() > before);
}

void
Refill::closeSide(const Side& side)
{
  const std::int32_t opposite = mesh_.oppositeOf(side);
  if (opposite < 0)
    return;
  const SideFrame frame(tree_, side.a, side.b, opposite);
  if (rule_ == DeWallRule::Dense) {
    const std::int32_t apex =
        findApex(tree_, size_, frame, [](std::int32_t) { return true; });
    if (apex >= 0 && !closeWith(side, apex))
      refused_.push_back({side, apex});
    return;
  }
  for (const std::int32_t apex : apexesByDistance(side, frame))
    if (fits(side, apex) && isSphereEmpty(tree_, {side.b, side.a, apex})) {
      closeWith(side, apex);
      return;
    }
}

bool
Refill::closeWith(const Side& side, std::int32_t apex)
{
  if (!fits(side, apex))
    return false;
  mesh_.add(side, apex, TriangleMesh::no_wall);
  noteLastTriangle();
  for (const Side& made : {Side{side.a, apex}, Side{apex, side.b}})
    if (mesh_.oppositeOf(made) >= 0)
      queue_.push_back(made);
  return true;
}

bool
Refill::fits(const Side& side, std::int32_t apex)
{
  const GrowingMesh::Verdict verdict = mesh_.judge(side, apex);
  return verdict == GrowingMesh::Verdict::Fits ||
         verdict == GrowingMesh::Verdict::Doubtful;
}

/** A used apex fits only beside an open edge to one of the side's ends. */
std::vector<std::int32_t>
Refill::apexesByDistance(const Side& side, const SideFrame& frame) const
{
  std::vector<std::int32_t> points =
      unusedWithin(reachFromMiddle(size_, frame), frame.origin + 0.5 * frame.u, side.a);
  for (const std::int32_t end : {side.a, side.b})
    for (const std::int32_t i : rim_[static_cast<std::size_t>(end)])
      if (i >= 0 && i != side.a && i != side.b)
        points.push_back(i);
  std::vector<Apex> apexes;
  for (const std::int32_t i : points) {
    const Apex apex = makeApex(i, frame.u, tree_.position(i) - frame.origin);
    if (isApexAllowed(size_, frame, apex))
      apexes.push_back(apex);
  }
  std::sort(apexes.begin(), apexes.end(), [&](const Apex& p, const Apex& q) {
    return isNearerApex(p, q, side.a, side.b, frame.u);
  });
  std::vector<std::int32_t> result;
  for (const Apex& apex : apexes)
    result.push_back(apex.index);
  return result;
}

std::vector<std::int32_t>
Refill::unusedWithin(double radius,
                     const Eigen::Vector3d& centre,
                     std::int32_t start) const
{
  std::vector<std::int32_t> result;
  const auto keep = [&](const PointTree::Node& node) {
    return unused_[static_cast<std::size_t>(tree_.numberOf(node))] > 0;
  };
  const auto visit = [&](const PointTree::Node& leaf) {
    for (std::int32_t i = leaf.begin; i < leaf.end; ++i)
      if (!mesh_.isUsed(i))
        result.push_back(i);
  };
  tree_.visitBall(start, centre, radius, keep, visit);
  return result;
}

void
Refill::startAt(std::int32_t p1, Ties ties)
{
  const Eigen::Vector3d a = tree_.position(p1);
  std::vector<std::pair<double, std::int32_t>> unused;
  for (const std::int32_t i : unusedWithin(size_.longest(p1), a, p1)) {
    const double squared = (tree_.position(i) - a).squaredNorm();
    if (i != p1 && size_.allows(p1, i, squared))
      unused.emplace_back(squared, i);
  }
  std::sort(unused.begin(), unused.end());
  unused.resize(std::min(unused.size(), largest_neighbourhood));
  for (std::size_t j = 1; j < unused.size(); ++j)
    for (std::size_t i = 0; i < j; ++i) {
      const std::int32_t p2 = unused[i].second, p3 = unused[j].second;
      const Eigen::Vector3d b = tree_.position(p2), c = tree_.position(p3);
      if (!size_.allows(p2, p3, (b - c).squaredNorm()) || isDegenerate(a, b, c) ||
          !(ties == Ties::Matter ? isFirstTriangle(tree_, size_, {p1, p2, p3})
                                 : isSphereEmpty(tree_, {p1, p2, p3})))
        continue;
      mesh_.addSeed({p1, p2, p3}, TriangleMesh::no_wall);
      noteLastTriangle();
      queue_ = mesh_.sidesOfLast();
      workOff();
      return;
    }
}

void
Refill::noteLastTriangle()
{
  for (const Side& side : mesh_.sidesOfLast()) {
    turnEdge(side.a, side.b);
    if (counted_[static_cast<std::size_t>(side.a)])
      continue;
    counted_[static_cast<std::size_t>(side.a)] = true;
    for (std::int32_t n = tree_.leafOf(side.a); n >= 0; n = tree_.node(n).parent)
      --unused_[static_cast<std::size_t>(n)];
  }
}

/** An edge that was closed or not there becomes open, an open one closed. */
void
Refill::turnEdge(std::int32_t a, std::int32_t b)
{
  const auto turn = [&](std::int32_t at, std::int32_t other) {
    std::array<std::int32_t, 3>& open = rim_[static_cast<std::size_t>(at)];
    const auto known = std::find(open.begin(), open.end(), other);
    if (known != open.end())
      *known = -1;
    else
      *std::find(open.begin(), open.end(), -1) = other;
  };
  turn(a, b);
  turn(b, a);
}

} // namespace pcl::acmap::dewall
