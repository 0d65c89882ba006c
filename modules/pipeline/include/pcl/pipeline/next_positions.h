#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/report.h>
#include <pcl/core/stage_controls.h>
#include <pcl/pipeline/unseen_surfaces.h>
#include <pcl/texture/floor_plan.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {

/** \brief Where to stand and look. \ingroup pipeline */
struct NextPosition {
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();       ///< metres, in the map frame
  Eigen::Vector3d direction = Eigen::Vector3d::Zero(); ///< of the view, of length 1
  double uncovered = 0;   ///< square metres that the positions before it do not show
  std::int32_t room = -1; ///< index in the map
  std::string
      words; ///< "Behind the furniture in room 1, 1.2 m to the left; look at ..."
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const NextPosition& position, Visitor&& visit)
{
  visit({"eye", "m"}, position.eye);
  visit({"direction"}, position.direction);
  visit({"uncovered", "m^2"}, position.uncovered);
  visit({"room"}, position.room);
  visit({"words"}, position.words);
}

/** \brief Report of \ref NextPositions. \ingroup pipeline */
struct NextPositionsReport : Report {
  std::size_t candidates = 0; ///< positions that were asked, in all directions
  double unseen_area = 0;     ///< square metres
  std::vector<NextPosition> positions;
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const NextPositionsReport& report, Visitor&& visit)
{
  visit({"candidates"}, report.candidates);
  visit({"unseen_area", "m^2"}, report.unseen_area);
  visit({"positions"}, report.positions);
}

/** \brief Proposes from where to look next, so that as much as possible of what no observation
 * saw of the rooms is seen.
 *
 * Where a room ends without a wall, floor, ceiling and the walls beside the open end are presumed to go
 * on for 4 m. Candidates are places on the free floor of the rooms, half a metre apart, at most 300, and
 * those where the sensor was, with views to
 * twelve sides, level and 25 degrees up and down. What a view shows are the unseen patches in its field
 * that face it and that no plane of the map hides. The best one is taken, then the one that shows
 * most of the rest, and so on: what views uncover is submodular, so this uncovers at least 63 % of what the
 * best ones among the candidates do.
 *
 * Takes O(c p n) for c candidates, p patches and n planes, at most some seconds. The result is the same
 * for any number of threads.
 * \code
 * pcl::NextPositions next;
 * next.compute (map, plan, pcl::findUnseenSurfaces (map, plan));
 * for (const pcl::NextPosition& position : next.getReport ().positions)
 *   std::cout << position.words << '\n';
 * \endcode
 * \ingroup pipeline */
class ACMAP_EXPORT NextPositions : public StageControls<NextPositionsReport> {
public:
  /** \brief Sets how many positions are proposed, at most (default 3).
   * \throws BadArgumentException unless it is within [1, 20] */
  void
  setNumberOfPositions(int number);

  int
  getNumberOfPositions() const
  {
    return number_;
  }

  /** \brief Sets the height of the sensor above the floor, metres (default 1.5).
   * \throws BadArgumentException unless it is within [0.1, 10] m */
  void
  setEyeHeight(double height);

  double
  getEyeHeight() const
  {
    return eye_height_;
  }

  /** \brief Sets the field of view, radians (default 1.05 and 0.8, 60 and 46 degrees).
   * \throws BadArgumentException unless both are within [0.1, 3] rad */
  void
  setFieldOfView(double horizontal, double vertical);

  double
  getHorizontalFieldOfView() const
  {
    return horizontal_;
  }

  double
  getVerticalFieldOfView() const
  {
    return vertical_;
  }

  /** \brief Sets the farthest depth that the sensor measures, metres (default 5).
   * \throws BadArgumentException unless it is within [0.5, 100] m */
  void
  setReach(double reach);

  double
  getReach() const
  {
    return reach_;
  }

  /** \brief Finds the positions, which are in the report, those that uncover most first: none if
   * there is no room, or nothing is unseen that a view can show.
   * \param[in] map with names of its surfaces (\ref nameSurfaces)
   * \param[in] plan of this map
   * \param[in] unseen from \ref findUnseenSurfaces for both
   * \throws CancelledException when the progress callback requested to stop */
  void
  compute(const CompactMap& map, const FloorPlan& plan, const UnseenSurfaces& unseen);

private:
  int number_ = 3;
  double eye_height_ = 1.5, horizontal_ = 1.05, vertical_ = 0.8, reach_ = 5;
};

} // namespace pcl
