#include "front.h"

#include "poll_pace.h"
#include "third_point.h"

#include <map>

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

/** \brief The vertices of an edge are brought to the cache while this number of edges
 * before it is processed. */
constexpr std::size_t look_ahead = 3;

} // namespace

void
Front::advance(const Range& range)
{
  for (std::size_t next = 0; next < queue_.size(); ++next) {
    mesh_.prefetch(queue_[std::min(next + look_ahead, queue_.size() - 1)]);
    const Side side = queue_[next];
    process(side, range, Doubt::Postpones);
    tick_();
  }
  queue_.clear();
}

void
Front::advancePostponed(const Range& range)
{
  PollPace pace;
  // Most of them have been resolved by a neighbour in the meantime.
  while (!postponed_.empty() || !bridges_.empty()) {
    while (!postponed_.empty()) {
      const std::vector<Candidate> candidates = std::exchange(postponed_, {});
      for (std::size_t next = 0; next < candidates.size(); ++next) {
        pace();
        mesh_.prefetch(
            candidates[std::min(next + look_ahead, candidates.size() - 1)].side);
        reconsider(candidates[next], range, Doubt::IsAllowed);
      }
      advance(range);
    }
    for (const Candidate& candidate : bridgesByVotes()) {
      pace();
      reconsider(candidate, range, Doubt::MayBridge);
    }
    advance(range);
  }
}

void
Front::advanceContrary(const Range& range)
{
  PollPace pace;
  while (!contrary_.empty()) {
    for (const Side& side : std::exchange(contrary_, {})) {
      pace();
      process(side, range, Doubt::MayBeContrary);
    }
    advance(range);
    advancePostponed(range);
  }
}

std::vector<Front::Candidate>
Front::bridgesByVotes()
{
  std::vector<Candidate> bridges = std::exchange(bridges_, {});
  std::map<GrowingMesh::Bridge, std::size_t> votes;
  for (const Candidate& candidate : bridges)
    ++votes[candidate.bridge];
  for (Candidate& candidate : bridges)
    candidate.votes = votes[candidate.bridge];
  std::stable_sort(
      bridges.begin(), bridges.end(), [](const Candidate& p, const Candidate& q) {
        return p.votes > q.votes;
      });
  return bridges;
}

void
Front::reconsider(const Candidate& candidate, const Range& range, Doubt doubt)
{
  const auto& [side, apex, bridge, votes] = candidate;
  Edge* base = mesh_.findOpen(side);
  if (!base)
    return;
  const bool masked = rule_ == DeWallRule::Guarded && mesh_.isSaturated(apex);
  if (masked || !tryCandidate(mesh_.propose(side, apex, base), range, doubt))
    process(side, range, doubt);
}

void
Front::process(const Side& side, const Range& range, Doubt doubt)
{
  Edge* base = mesh_.findOpen(side);
  if (!base)
    return;
  const SideFrame frame(tree_, size_, side.a, side.b, base->opposites);
  const bool mask = rule_ == DeWallRule::Guarded;
  PassedOver passed_over;
  if (mask) {
    passed_over.masks = mesh_.arrays().saturated.data();
    passed_over.first_leaf = range.first_leaf;
    passed_over.end_leaf = range.end_leaf;
  }
  // With the paper's rule, the second-nearest apex is tried if the guard rejects the
  // first one. Without the sphere test this would create second layers.
  for (int attempt = 0; attempt < (mask ? 2 : 1); ++attempt) {
    const std::int32_t apex = findApex(tree_, size_, frame, passed_over);
    if (apex < 0)
      return;
    if (!range.contains(apex)) {
      deferred_.push_back(side);
      return;
    }
    if (mask && !isSphereEmpty(tree_, {side.b, side.a, apex}, base->opposites))
      return;
    if (tryCandidate(mesh_.propose(side, apex, base), range, doubt))
      return;
    passed_over.point = apex;
  }
}

bool
Front::tryCandidate(const Proposal& proposal, const Range& range, Doubt doubt)
{
  const Side& side = proposal.side;
  const std::int32_t apex = proposal.apex;
  const GrowingMesh::Verdict verdict = mesh_.judge(proposal);
  if (verdict == GrowingMesh::Verdict::Blocked)
    return false;
  if (doubt != Doubt::MayBeContrary && mesh_.isContrary(side, apex)) {
    contrary_.push_back(side);
    return true;
  }
  if (verdict != GrowingMesh::Verdict::Fits && doubt == Doubt::Postpones) {
    postponed_.push_back({side, apex, {}, 0});
    return true;
  }
  const GrowingMesh::Bridge bridge = mesh_.bridge(proposal);
  if (bridge.first >= 0 && verdict != GrowingMesh::Verdict::Fits &&
      doubt < Doubt::MayBridge) {
    bridges_.push_back({side, apex, bridge, 0});
    return true;
  }
  mesh_.add(proposal);
  if (!proposal.at_a)
    insert({side.a, apex}, range);
  if (!proposal.at_b)
    insert({apex, side.b}, range);
  return true;
}

void
Front::startAt(std::int32_t p1, std::int32_t p2, const Range& range)
{
  const std::int32_t p3 = findThirdPoint(tree_, size_, p1, p2, [&](std::int32_t i) {
    return range.contains(i) && !mesh_.isUsed(i);
  });
  if (p3 < 0 || !isFirstTriangle(tree_, size_, {p1, p2, p3}))
    return;
  mesh_.addSeed({p1, p2, p3});
  for (const Side& side : mesh_.sidesOfLast())
    insert(side, range);
  advance(range);
}

} // namespace pcl::acmap::ACMAP_DEWALL
