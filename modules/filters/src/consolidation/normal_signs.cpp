#include "consolidation/normal_signs.h"

#include "consolidation/point_hash.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

namespace pcl::acmap {

namespace {

/** A propagation step of the sign from one normal to another. The flattest steps come
 * first, then they are sorted by index. */
struct Step {
  float bend; ///< 0 between normals of one plane or one arc, 1 if they are unrelated
  std::uint32_t to;
  std::uint32_t from;

  bool
  operator<(const Step& other) const // the queue returns the largest
  {
    return std::tie(bend, to, from) > std::tie(other.bend, other.to, other.from);
  }
};

/** Cosine between a normal and that of its neighbour, transported along a circular arc
 * by the reflection that the paper uses for the votes. */
float
agreement(const Representative& a, const Representative& b)
{
  const Eigen::Vector3f way = (b.point - a.point).normalized();
  const Eigen::Vector3f carried = b.normal - 2 * b.normal.dot(way) * way;
  return a.normal.dot(carried);
}

class SignSpreading {
public:
  SignSpreading(std::vector<Representative>& representatives, double edge)
  : all_(representatives)
  , radius_(static_cast<float>(1.8 * edge))
  , hash_(representatives.size(), radius_)
  , is_done_(representatives.size(), false)
  {
    for (std::uint32_t i = 0; i < all_.size(); ++i)
      if (hasNormal(i))
        hash_.add(i, all_[i].point);
  }

  void
  run()
  {
    for (std::uint32_t seed = 0; seed < all_.size(); ++seed)
      if (hasNormal(seed) && !is_done_[seed])
        spreadFrom(seed);
  }

private:
  bool
  hasNormal(std::uint32_t i) const
  {
    return !std::isnan(all_[i].normal.x());
  }

  void
  spreadFrom(std::uint32_t seed)
  {
    std::vector<std::uint32_t> component;
    std::size_t flipped = 0;
    std::priority_queue<Step> steps;
    steps.push({0, seed, seed});
    while (!steps.empty()) {
      const Step step = steps.top();
      steps.pop();
      if (is_done_[step.to])
        continue;
      is_done_[step.to] = true;
      component.push_back(step.to);
      if (step.to != step.from && agreement(all_[step.from], all_[step.to]) < 0) {
        all_[step.to].normal *= -1;
        ++flipped;
      }
      pushSteps(step.to, steps);
    }
    if (2 * flipped > component.size())
      for (const std::uint32_t i : component)
        all_[i].normal *= -1;
  }

  void
  pushSteps(std::uint32_t from, std::priority_queue<Step>& steps) const
  {
    hash_.visitNear(all_[from].point, [&](std::uint32_t to) {
      if (!is_done_[to] &&
          (all_[to].point - all_[from].point).squaredNorm() < radius_ * radius_)
        steps.push({1 - std::abs(agreement(all_[from], all_[to])), to, from});
      return false;
    });
  }

  std::vector<Representative>& all_;
  float radius_; // metres
  PointHash hash_;
  std::vector<bool> is_done_;
};

} // namespace

bool
fitTheirSensors(const std::vector<Representative>& representatives,
                const SensorView& sensors)
{
  if (!sensors.isKnown())
    return false;
  std::size_t edge_on = 0, seen = 0;
  for (const Representative& r : representatives) {
    const Eigen::Vector3f* sensor = sensors[static_cast<std::size_t>(r.witness)];
    if (!sensor || std::isnan(r.normal.x()))
      continue;
    constexpr float grazing = 0.05f;
    ++seen;
    edge_on += std::abs(r.normal.dot((*sensor - r.point).normalized())) < grazing;
  }
  return 20 * edge_on <= seen;
}

void
makeNormalsAgree(std::vector<Representative>& representatives, double edge)
{
  SignSpreading(representatives, edge).run();
}

} // namespace pcl::acmap
