#include "outlines/loop.h"

#include "outlines/face_loops.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::acmap::outlines {
namespace {

using Place = Eigen::Vector2d;

struct LoopEdge {
  std::int32_t from, to;
  std::size_t loop;
};

/** Rounding error of the distance between a cut and its edge. Places that are nearer to
 * each other are merged; otherwise each cut would cause new ones. */
double
roundingOf(const std::vector<Loop>& loops)
{
  double largest = 0;
  for (const Loop& loop : loops)
    for (const Place& place : loop)
      largest = std::max(largest, place.cwiseAbs().maxCoeff());
  return 1e-12 * largest;
}

/** \brief Edges of loops between numbered places, cut where they intersect. */
class CutEdges {
public:
  CutEdges(const std::vector<Loop>& loops, double distance)
  : distance_(std::max(distance, roundingOf(loops)))
  , is_met_(loops.size(), 0)
  {
    for (std::size_t l = 0; l < loops.size(); ++l) {
      const auto first = static_cast<std::int32_t>(places_.size());
      const auto size = static_cast<std::int32_t>(loops[l].size());
      places_.insert(places_.end(), loops[l].begin(), loops[l].end());
      for (std::int32_t i = 0; i < size; ++i)
        edges_.push_back({first + i, first + (i + 1) % size, l});
    }
    merge();
    // Cuts move edges slightly, so that these may intersect others.
    constexpr int max_rounds = 20;
    for (int round = 0; round < max_rounds && cut(); ++round)
      merge();
  }

  /** Does a loop touch itself or another one? */
  bool
  isMet(std::size_t loop) const
  {
    return is_met_[loop] != 0;
  }

  /** The edges of such loops that have the surface on their left side only. */
  std::vector<std::pair<std::int32_t, std::int32_t>>
  rims() const
  {
    struct Net {
      int count = 0; ///< towards higher numbers minus reverse
      bool is_met = false;
    };
    std::map<std::pair<std::int32_t, std::int32_t>, Net> nets;
    for (const LoopEdge& edge : edges_) {
      Net& net = nets[std::minmax(edge.from, edge.to)];
      net.count += edge.from < edge.to ? 1 : -1;
      net.is_met = net.is_met || isMet(edge.loop);
    }
    std::vector<std::pair<std::int32_t, std::int32_t>> rims;
    for (const auto& [ends, net] : nets) {
      if (net.count == 0 || !net.is_met)
        continue;
      auto way = ends;
      if (net.count < 0)
        std::swap(way.first, way.second);
      if (isRim(way, std::abs(net.count)))
        rims.push_back(way);
    }
    std::sort(rims.begin(), rims.end());
    return rims;
  }

  const std::vector<Place>&
  places() const
  {
    return places_;
  }

private:
  const Place&
  at(std::int32_t place) const
  {
    return places_[static_cast<std::size_t>(place)];
  }

  void
  meet(const LoopEdge& a, const LoopEdge& b)
  {
    is_met_[a.loop] = is_met_[b.loop] = 1;
  }

  /** Merges places that are within the distance: they get the number of the first of
   * them. */
  void
  merge()
  {
    std::vector<std::int32_t> order(places_.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      order[i] = static_cast<std::int32_t>(i);
    std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
      return at(a).x() < at(b).x();
    });
    std::vector<std::int32_t> same(places_.size(), -1);
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (same[static_cast<std::size_t>(order[i])] >= 0)
        continue;
      for (std::size_t k = i; k < order.size(); ++k) {
        if (at(order[k]).x() > at(order[i]).x() + distance_)
          break;
        auto& other = same[static_cast<std::size_t>(order[k])];
        if (other < 0 && (at(order[k]) - at(order[i])).norm() <= distance_)
          other = order[i];
      }
    }
    for (LoopEdge& edge : edges_) {
      edge.from = same[static_cast<std::size_t>(edge.from)];
      edge.to = same[static_cast<std::size_t>(edge.to)];
    }
    // If a place is passed twice, a loop touches itself or another one there.
    std::vector<const LoopEdge*> passing(places_.size(), nullptr);
    for (const LoopEdge& edge : edges_) {
      if (edge.from == edge.to) {
        meet(edge, edge);
        continue;
      }
      const LoopEdge*& passed = passing[static_cast<std::size_t>(edge.from)];
      if (passed)
        meet(*passed, edge);
      passed = &edge;
    }
    edges_.erase(std::remove_if(edges_.begin(),
                                edges_.end(),
                                [](const LoopEdge& e) { return e.from == e.to; }),
                 edges_.end());
  }

  /** Is a place near an edge? The threshold is smaller than the minimum distance
   * between places by more than a factor of sqrt(2), so that among three places at most
   * one is near the edge between the others; otherwise the cuts would never end. */
  bool
  isNear(const LoopEdge& edge, std::int32_t place) const
  {
    if (place == edge.from || place == edge.to)
      return false;
    const Place way = at(edge.to) - at(edge.from);
    const Place there = at(place) - at(edge.from);
    const double along = there.dot(way) / way.squaredNorm();
    return along > 0 && along < 1 &&
           std::abs(cross(way, there)) <= distance_ / 2 * way.norm();
  }

  /** Intersection in the interior of both edges, -1 for none. */
  std::int32_t
  crossing(const LoopEdge& e, const LoopEdge& f)
  {
    const Place way = at(f.to) - at(f.from);
    const double from = cross(at(e.to) - at(e.from), at(f.from) - at(e.from));
    const double to = cross(at(e.to) - at(e.from), at(f.to) - at(e.from));
    const double a = cross(way, at(e.from) - at(f.from));
    const double b = cross(way, at(e.to) - at(f.from));
    if (!(from * to < 0 && a * b < 0))
      return -1;
    const Place place = at(f.from) + from / (from - to) * way;
    places_.push_back(place);
    return static_cast<std::int32_t>(places_.size()) - 1;
  }

  void
  cutPair(std::size_t i, std::size_t k, std::vector<std::vector<std::int32_t>>& cuts)
  {
    const LoopEdge e = edges_[i], f = edges_[k];
    const std::size_t before = cuts[i].size() + cuts[k].size();
    for (const std::int32_t place : {f.from, f.to})
      if (isNear(e, place))
        cuts[i].push_back(place);
    for (const std::int32_t place : {e.from, e.to})
      if (isNear(f, place))
        cuts[k].push_back(place);
    if (cuts[i].size() + cuts[k].size() == before &&
        std::minmax(e.from, e.to) != std::minmax(f.from, f.to)) {
      const bool is_joined =
          e.from == f.from || e.from == f.to || e.to == f.from || e.to == f.to;
      const std::int32_t place = is_joined ? -1 : crossing(e, f);
      if (place >= 0) {
        cuts[i].push_back(place);
        cuts[k].push_back(place);
      }
    }
    if (cuts[i].size() + cuts[k].size() > before)
      meet(e, f);
  }

  /** Cuts all edges once. Returns true if there was anything to cut. */
  bool
  cut()
  {
    std::vector<std::vector<std::int32_t>> cuts(edges_.size());
    const auto minimum = [&](const LoopEdge& e, int axis) {
      return std::min(at(e.from)[axis], at(e.to)[axis]) - distance_;
    };
    const auto maximum = [&](const LoopEdge& e, int axis) {
      return std::max(at(e.from)[axis], at(e.to)[axis]);
    };
    std::vector<std::size_t> order(edges_.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return minimum(edges_[a], 0) < minimum(edges_[b], 0);
    });
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t k = i + 1; k < order.size(); ++k) {
        const LoopEdge &e = edges_[order[i]], &f = edges_[order[k]];
        if (minimum(f, 0) > maximum(e, 0))
          break;
        if (minimum(f, 1) <= maximum(e, 1) && minimum(e, 1) <= maximum(f, 1))
          cutPair(order[i], order[k], cuts);
      }
    std::vector<LoopEdge> pieces;
    for (std::size_t i = 0; i < edges_.size(); ++i)
      appendPieces(edges_[i], cuts[i], pieces);
    const bool is_cut = pieces.size() > edges_.size();
    edges_ = std::move(pieces);
    return is_cut;
  }

  void
  appendPieces(const LoopEdge& edge,
               std::vector<std::int32_t>& cuts,
               std::vector<LoopEdge>& pieces) const
  {
    const Place way = at(edge.to) - at(edge.from);
    std::stable_sort(cuts.begin(), cuts.end(), [&](std::int32_t a, std::int32_t b) {
      return at(a).dot(way) < at(b).dot(way);
    });
    std::int32_t from = edge.from;
    for (const std::int32_t place : cuts)
      if (place != from) {
        pieces.push_back({from, place, edge.loop});
        from = place;
      }
    pieces.push_back({from, edge.to, edge.loop});
  }

  /** Is the surface on the left side only of an edge that occurs \a count times? */
  bool
  isRim(const std::pair<std::int32_t, std::int32_t>& way, int count) const
  {
    const Place direction = at(way.second) - at(way.first);
    // Rotated if necessary, so that a ray along x leaves the edge.
    const bool is_turned = std::abs(direction.x()) > std::abs(direction.y());
    const auto seen = [&](const Place& place) {
      return is_turned ? Place(place.y(), -place.x()) : place;
    };
    const Place middle = seen((at(way.first) + at(way.second)) / 2);
    int windings = 0;
    for (const LoopEdge& edge : edges_) {
      if (std::minmax(edge.from, edge.to) == std::minmax(way.first, way.second))
        continue;
      const Place a = seen(at(edge.from)), b = seen(at(edge.to));
      if ((a.y() > middle.y()) == (b.y() > middle.y()) ||
          a.x() + (b.x() - a.x()) * (middle.y() - a.y()) / (b.y() - a.y()) < middle.x())
        continue;
      windings += b.y() > a.y() ? 1 : -1;
    }
    const bool is_up = seen(direction).y() > 0;
    const int left = is_up ? windings + count : windings;
    return left >= 1 && left - count <= 0;
  }

  double distance_;
  std::vector<Place> places_;
  std::vector<LoopEdge> edges_;
  std::vector<std::uint8_t> is_met_;
};

/** Splits a rim at places to which it returns. */
void
appendSimple(const std::vector<std::int32_t>& rim,
             const std::vector<Place>& places,
             std::vector<Loop>& loops)
{
  std::vector<std::int32_t> open;
  const auto close = [&](std::vector<std::int32_t>::iterator first) {
    Loop loop;
    for (auto it = first; it != open.end(); ++it)
      loop.push_back(places[static_cast<std::size_t>(*it)]);
    if (loop.size() >= 3)
      loops.push_back(std::move(loop));
    open.erase(first, open.end());
  };
  for (const std::int32_t place : rim) {
    const auto before = std::find(open.begin(), open.end(), place);
    if (before != open.end())
      close(before);
    open.push_back(place);
  }
  close(open.begin());
}

} // namespace

std::vector<Loop>
disentangled(const std::vector<Loop>& loops, double distance)
{
  const CutEdges cut(loops, distance);
  std::vector<Loop> sound;
  for (std::size_t l = 0; l < loops.size(); ++l)
    if (!cut.isMet(l))
      sound.push_back(loops[l]);
  for (const std::vector<std::int32_t>& rim :
       edgeLoops(cut.rims(), [&](std::int32_t vertex) {
         return cut.places()[static_cast<std::size_t>(vertex)];
       }))
    appendSimple(rim, cut.places(), sound);
  return sound;
}

} // namespace pcl::acmap::outlines
