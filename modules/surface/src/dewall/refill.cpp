#include "refill.h"

#include "seed_test.h"

namespace pcl::acmap::dewall {

namespace {

/** \brief So many unused points round an unused one are combined to a first triangle.
 */
constexpr std::size_t largest_neighbourhood = 64;

} // namespace

bool
Refill::isEmpty(const std::array<std::int32_t, 3>& corners) const
{
  return isSphereEmpty(tree_,
                       smallestSphere(tree_.position(corners[0]),
                                      tree_.position(corners[1]),
                                      tree_.position(corners[2])),
                       corners);
}

void
Refill::run()
{
  std::size_t before = 0;
  do {
    before = mesh_.triangles().size();
    queue_ = mesh_.openSides();
    workOff();
  } while (rule_ == DeWallRule::Dense && mesh_.triangles().size() > before);
  for (std::int32_t p1 = 0; p1 < tree_.size(); ++p1)
    if (!mesh_.isUsed(p1))
      startAt(p1);
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
Refill::closeSide(const Side& side)
{
  const std::int32_t opposite = mesh_.oppositeOf(side);
  if (opposite < 0)
    return;
  for (const std::int32_t apex :
       fittingApexes(side, SideFrame(tree_, side.a, side.b, opposite))) {
    if (rule_ == DeWallRule::Paper && !isEmpty({side.b, side.a, apex}))
      continue;
    mesh_.add(side, apex, TriangleMesh::no_wall);
    for (const Side& made : {Side{side.a, apex}, Side{apex, side.b}})
      if (mesh_.oppositeOf(made) >= 0)
        queue_.push_back(made);
    return;
  }
}

std::vector<std::int32_t>
Refill::fittingApexes(const Side& side, const SideFrame& frame)
{
  const auto fits = [&](std::int32_t i) {
    const GrowingMesh::Verdict verdict = mesh_.judge(side, i);
    return verdict == GrowingMesh::Verdict::Fits ||
           verdict == GrowingMesh::Verdict::Doubtful;
  };
  const auto any = [](std::int32_t) { return true; };
  std::vector<std::int32_t> result;
  if (rule_ == DeWallRule::Dense) {
    const std::int32_t nearest = findApex(tree_, size_, frame, any);
    if (nearest >= 0 && fits(nearest))
      result.push_back(nearest);
    return result;
  }
  std::vector<Apex> apexes;
  forEachApex(tree_, size_, frame, [&](const Apex& apex) {
    if (!mesh_.isSaturated(apex.index) && fits(apex.index))
      apexes.push_back(apex);
  });
  std::sort(apexes.begin(), apexes.end(), [&](const Apex& p, const Apex& q) {
    return isNearerApex(p, q, side.a, side.b, frame.u);
  });
  for (const Apex& apex : apexes)
    result.push_back(apex.index);
  return result;
}

void
Refill::startAt(std::int32_t p1)
{
  const Eigen::Vector3d centre = tree_.position(p1);
  const double reach = size_.longest(p1);
  std::vector<std::pair<double, std::int32_t>> unused;
  tree_.visitBall(
      centre,
      reach,
      [](const PointTree::Node&) { return true; },
      [&](const PointTree::Node& leaf) {
        for (std::int32_t i = leaf.begin; i < leaf.end; ++i) {
          const double squared = (tree_.position(i) - centre).squaredNorm();
          if (i != p1 && !mesh_.isUsed(i) && size_.allows(p1, i, squared))
            unused.emplace_back(squared, i);
        }
      });
  std::sort(unused.begin(), unused.end());
  unused.resize(std::min(unused.size(), largest_neighbourhood));
  for (std::size_t j = 1; j < unused.size(); ++j)
    for (std::size_t i = 0; i < j; ++i) {
      const std::int32_t p2 = unused[i].second, p3 = unused[j].second;
      const Eigen::Vector3d b = tree_.position(p2), c = tree_.position(p3);
      if (!size_.allows(p2, p3, (b - c).squaredNorm()) || isDegenerate(centre, b, c) ||
          !isFirstTriangle(tree_, size_, {p1, p2, p3}))
        continue;
      mesh_.addSeed({p1, p2, p3}, TriangleMesh::no_wall);
      queue_ = mesh_.sidesOfLast();
      workOff();
      return;
    }
}

} // namespace pcl::acmap::dewall
