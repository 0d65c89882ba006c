#pragma once

#include "outlines/creases.h"

#include <map>

namespace pcl::acmap::outlines {

/** An end of a rim on a crease, or a corner of three planes. */
struct CreasePoint {
  std::int32_t crease = -1;
  double along = 0;        ///< metres along the crease
  std::int32_t third = -1; ///< a plane that ends there as well: a corner of three
  int heading = 0;         ///< 1 if the edge goes on towards larger \a along, else -1
  double weight = 1;       ///< inverse variance of \a along, square spacings
};

/** \brief The points on creases at which edges end, each of them once: what two planes
 * have in common gets the same coordinates in both.
 *
 * All points are added before the first one is looked up. */
class CreaseNodes {
public:
  CreaseNodes(const Creases& creases,
              const std::vector<PlaneRaster>& rasters,
              double spacing);

  void
  add(const CreasePoint& point);

  /** Merges points that are the same within the noise, and sorts them along their
   * creases. */
  void
  settle();

  /** Number of the node of a point that was added. */
  std::size_t
  find(const CreasePoint& point) const;

  /** Nodes of a crease strictly between two of its nodes, in the order from the first to
   * the second. */
  std::vector<std::size_t>
  between(std::int32_t crease, std::size_t from, std::size_t to) const;

  const Eigen::Vector3d&
  position(std::size_t node) const
  {
    return positions_[node];
  }

private:
  using Corner = std::array<std::size_t, 3>;

  /** An end of a rim. */
  struct End {
    double along;
    int heading;
    double weight;
    std::size_t node = 0;
  };

  static bool
  isBefore(const End& a, const End& b);

  /** A node on a crease. */
  struct Place {
    double along;
    std::size_t node;
  };

  Corner
  cornerOf(const CreasePoint& point) const;

  void
  settleCorners();

  void
  settleEnds(std::size_t crease);

  bool
  areSame(const std::vector<End>& ends, std::size_t first, std::size_t last) const;

  const Creases& creases_;
  const std::vector<PlaneRaster>& rasters_;
  double spacing_;
  std::map<Corner, std::size_t> corners_;  ///< their nodes
  std::vector<std::vector<End>> ends_;     ///< on each crease, ascending
  std::vector<std::vector<Place>> places_; ///< on each crease, ascending
  std::vector<Eigen::Vector3d> positions_;
};

} // namespace pcl::acmap::outlines
