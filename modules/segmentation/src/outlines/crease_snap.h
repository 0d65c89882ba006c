#pragma once

#include "labeling/candidate_grid.h"
#include "outlines/loop.h"

namespace pcl::acmap::outlines {

/** The frame of a patch: 2D positions in its plane, metres. */
struct PatchFrame {
  const PlanePatch& patch;

  Eigen::Vector2d
  flat(const Eigen::Vector3d& point) const
  {
    const Eigen::Vector3d way = point - patch.center;
    return {way.dot(patch.axis_u), way.dot(patch.axis_v)};
  }

  Eigen::Vector3d
  lifted(const Eigen::Vector2d& place) const
  {
    return patch.center + place[0] * patch.axis_u + place[1] * patch.axis_v;
  }
};

/** Moves the points of a loop onto the intersection lines of its plane with other
 * planes near them, if these lines are within reach; if there are two lines, into their
 * corner. */
class CreaseSnap {
public:
  CreaseSnap(const labeling::CandidateGrid& grid,
             const std::vector<KnownPlane>& planes,
             std::size_t own,
             double reach);

  /** Moves a single point.
   * \param[out] line number of the plane whose line it was moved onto, -1 if it was not
   * moved */
  Eigen::Vector2d
  moved(const Eigen::Vector2d& place, std::int32_t& line) const;

  /** Moves all points of a loop. */
  Loop
  operator()(const Loop& loop) const;

private:
  /** The line normal . place = offset with a unit normal. */
  struct Line {
    Eigen::Vector2d normal = Eigen::Vector2d::Zero();
    double offset = 0;

    double
    distance(const Eigen::Vector2d& place) const
    {
      return normal.dot(place) - offset;
    }

    Eigen::Vector2d
    nearest(const Eigen::Vector2d& place) const
    {
      return place - distance(place) * normal;
    }
  };

  bool
  isAt(const Eigen::Vector2d& place, std::size_t plane) const;

  std::vector<std::size_t>
  near(const Eigen::Vector2d& place, double reach) const;

  void
  bridge(const Loop& loop,
         const std::vector<std::int32_t>& line_of,
         Loop& snapped) const;

  bool
  corner(const Line& a,
         const Line& b,
         const Eigen::Vector2d& place,
         Eigen::Vector2d& found) const;

  const labeling::CandidateGrid& grid_;
  PatchFrame frame_;
  double reach_;
  std::vector<Line> lines_; ///< for each plane; zero if there is none
};

} // namespace pcl::acmap::outlines
