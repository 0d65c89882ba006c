#include "refill.h"

#include "ball_visit.h"
#include "poll_pace.h"
#include "third_point.h"

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

/** \brief Maximum number of unused points around an unused one that are combined to a
 * first triangle. */
constexpr std::size_t largest_neighbourhood = 64;

} // namespace

Unfinished
Refill::run(Unfinished begun)
{
  // Edges that are not open now will be tried when they are opened.
  PollPace pace;
  for (const Side& side : begun.sides) {
    pace();
    if (mesh_.oppositeOf(side) >= 0)
      queue_.push_back(mesh_.asItRuns(side));
  }
  for (const Refusal& refusal : begun.refusals) {
    pace();
    if (mesh_.oppositeOf(refusal.side) >= 0)
      left_.refusals.push_back({mesh_.asItRuns(refusal.side), refusal.apex});
  }
  workOff();
  // Where no first triangle satisfies the tie rule, any empty sphere is accepted.
  for (const Ties ties : {Ties::Matter, Ties::DoNotMatter})
    for (const std::int32_t p1 : begun.points) {
      pace();
      if (!mesh_.isUsed(p1) && !startAt(p1, ties) && ties == Ties::DoNotMatter)
        left_.points.push_back(p1);
    }
  reconsider();
  return std::move(left_);
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
    PollPace pace;
    for (const Refusal& refusal : std::exchange(left_.refusals, {})) {
      pace();
      Edge* base = mesh_.findOpen(refusal.side);
      if (!base)
        continue;
      if (!closeWith(mesh_.propose(refusal.side, refusal.apex, base)))
        left_.refusals.push_back(refusal);
      workOff();
    }
  } while (mesh_.triangles().size() > before);
}

void
Refill::closeSide(const Side& side)
{
  Edge* base = mesh_.findOpen(side);
  if (!base)
    return;
  const SideFrame frame(tree_, size_, side.a, side.b, base->opposites);
  if (rule_ == DeWallRule::Dense) {
    closeSideDensely(side, base, frame);
    return;
  }
  findApexes(side, frame);
  for (const Apex& apex : apexes_) {
    const bool is_own = range_.contains(apex.index);
    const Proposal proposal =
        is_own ? mesh_.propose(side, apex.index, base) : Proposal{};
    if ((is_own && !fits(proposal)) ||
        !isSphereEmpty(tree_, {side.b, side.a, apex.index}, base->opposites))
      continue;
    if (is_own)
      close(proposal);
    else
      left_.sides.push_back(side);
    return;
  }
  if (is_at_wall_)
    left_.sides.push_back(side);
}

void
Refill::closeSideDensely(const Side& side, Edge* base, const SideFrame& frame)
{
  const std::int32_t apex = findApex(tree_, size_, frame, {});
  if (apex < 0)
    return;
  if (!range_.contains(apex))
    left_.sides.push_back(side);
  else if (!closeWith(mesh_.propose(side, apex, base)))
    left_.refusals.push_back({side, apex});
}

bool
Refill::closeWith(const Proposal& proposal)
{
  if (!fits(proposal))
    return false;
  close(proposal);
  return true;
}

void
Refill::close(const Proposal& proposal)
{
  mesh_.add(proposal);
  if (!proposal.at_a)
    queue_.push_back({proposal.side.a, proposal.apex});
  if (!proposal.at_b)
    queue_.push_back({proposal.apex, proposal.side.b});
}

bool
Refill::fits(const Proposal& proposal)
{
  const GrowingMesh::Verdict verdict = mesh_.judge(proposal);
  return verdict == GrowingMesh::Verdict::Fits ||
         verdict == GrowingMesh::Verdict::Doubtful;
}

/** A used apex is possible only at an open edge to one of the ends; for points outside
 * of the range it is unknown whether they are used. */
void
Refill::findApexes(const Side& side, const SideFrame& frame)
{
  unused_.find({side.a,
                frame.origin + 0.5 * frame.u,
                reachFromMiddle(frame),
                frame.outward.cast<float>()},
               found_);
  is_at_wall_ = false;
  for (const std::int32_t end : {side.a, side.b}) {
    // The fan at a wall may contain points of another task, or there may be several
    // fans.
    if (!range_.isWhole(tree_) && mesh_.arrays().is(end, VertexFlag::of_wall)) {
      is_at_wall_ = true;
      continue;
    }
    const std::int32_t other = mesh_.endOfFan(end, side);
    if (other != side.a && other != side.b)
      found_.push_back(other);
  }
  apexes_.clear();
  for (const std::int32_t i : found_) {
    const Eigen::Vector3d from_a = tree_.position(i) - frame.origin;
    if (!(from_a.dot(frame.outward) > 0))
      continue;
    const Apex apex = makeApex(i, frame.u, from_a);
    if (isApexAllowed(size_, frame, apex))
      apexes_.push_back(apex);
  }
  std::sort(apexes_.begin(), apexes_.end(), [&](const Apex& p, const Apex& q) {
    return isNearerApex(p, q, side.a, side.b, frame.u);
  });
}

bool
Refill::startAt(std::int32_t p1, Ties ties)
{
  const Eigen::Vector3d a = tree_.position(p1);
  const bool is_all_in_range =
      unused_.find({p1, a, size_.longest(p1), Eigen::Vector3f::Zero()}, found_);
  if (!is_all_in_range && ties == Ties::DoNotMatter)
    return false;
  std::vector<std::pair<double, std::int32_t>> unused;
  for (const std::int32_t i : found_) {
    const double squared = (tree_.position(i) - a).squaredNorm();
    if (i != p1 && range_.contains(i) && size_.allows(p1, i, squared))
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
      mesh_.addSeed({p1, p2, p3});
      const auto sides = mesh_.sidesOfLast();
      queue_.assign(sides.begin(), sides.end());
      workOff();
      return true;
    }
  return is_all_in_range;
}

Unfinished
affectedBy(const std::vector<GrownTriangle>& removed,
           const SizeConstraint& size,
           GrowingMesh& mesh)
{
  MeshArrays& arrays = mesh.arrays();
  std::vector<std::int32_t> near; // points whose open edges may be closed
  Unfinished affected;
  for (const GrownTriangle& triangle : removed)
    near.insert(near.end(), triangle.corners.begin(), triangle.corners.end());
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  PollPace pace;
  for (const std::int32_t corner : std::vector<std::int32_t>(near)) {
    pace();
    if (!arrays.isUsed(corner)) {
      affected.points.push_back(corner);
      double radius = size.longest(corner);
      visitBall(arrays.tree,
                corner,
                arrays.tree.position(corner),
                radius,
                [&](std::int32_t, std::int32_t first, std::int32_t end) {
                  for (std::int32_t i = first; i < end; ++i)
                    if (arrays.vertex(i).open_edges > 0)
                      near.push_back(i);
                });
    }
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  std::vector<std::pair<std::int32_t, std::int32_t>> edges; // lower end, higher end
  for (const std::int32_t low : near) {
    pace();
    for (const Side& side : mesh.openSides(low, low + 1)) {
      edges.emplace_back(low, std::max(side.a, side.b));
      for (const std::int32_t end : {side.a, side.b})
        edges.push_back(std::minmax(end, mesh.endOfFan(end, side)));
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const auto& [low, high] : edges)
    affected.sides.push_back(arrays.find(low, high)->ascending ? Side{low, high}
                                                               : Side{high, low});
  return affected;
}

} // namespace pcl::acmap::ACMAP_DEWALL
