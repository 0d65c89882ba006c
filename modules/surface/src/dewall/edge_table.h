#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace pcl::acmap::dewall {

/** \brief What is known of an edge of the mesh. */
struct Edge {
  std::int32_t high; ///< its end of higher index; the list it stands in is the lower
  std::int32_t next; ///< in that list, -1 at its end
  std::int32_t opposite;  ///< third corner of its first triangle
  std::int32_t component; ///< of that triangle
  bool ascending; ///< that triangle runs through it from the lower to the higher end
  std::uint8_t triangles; ///< at it, at most 2 under the guard

  bool
  isOpen() const
  {
    return triangles == 1;
  }
};

/** \brief The edges of the mesh, a linked list for each lower end: points that are near
 * stand near in the tree's order, and so do their edges. */
class EdgeTable {
public:
  explicit EdgeTable(std::int32_t points)
  : first_(static_cast<std::size_t>(points), -1)
  {}

  /** \brief The edge between two points, nullptr where there is none. */
  Edge*
  find(std::int32_t a, std::int32_t b)
  {
    const std::int32_t high = std::max(a, b);
    for (std::int32_t e = first_[static_cast<std::size_t>(std::min(a, b))]; e >= 0;) {
      Edge& edge = edges_[static_cast<std::size_t>(e)];
      if (edge.high == high)
        return &edge;
      e = edge.next;
    }
    return nullptr;
  }

  /** \brief Adds an edge that was not there; invalidates what find () gave. */
  Edge&
  add(std::int32_t a, std::int32_t b)
  {
    std::int32_t& first = first_[static_cast<std::size_t>(std::min(a, b))];
    edges_.push_back({std::max(a, b), first, -1, -1, false, 0});
    first = static_cast<std::int32_t>(edges_.size()) - 1;
    return edges_.back();
  }

  /** \brief Calls function (edge) for the edges whose lower end is \a low. */
  template <typename Function>
  void
  forEachAt(std::int32_t low, const Function& function)
  {
    for (std::int32_t e = first_[static_cast<std::size_t>(low)]; e >= 0;) {
      Edge& edge = edges_[static_cast<std::size_t>(e)];
      e = edge.next;
      function(edge);
    }
  }

private:
  std::vector<std::int32_t> first_;
  std::vector<Edge> edges_;
};

} // namespace pcl::acmap::dewall
