#pragma once

#include "cylinders/raw_cylinders.h"

#include <set>

namespace pcl::acmap::cylinders {

/** By how much the radius of a cylinder may change in the fit to the source, of the
 * radius: a coarse mesh cuts small pipes. */
inline constexpr double max_radius_change = 0.5;

/** Points of a source beside a cylinder that was found on the mesh. */
struct PointsBeside {
  std::vector<std::int32_t> free; ///< on no plane that stays and on no other cylinder
  std::size_t on = 0;             ///< within the noise of its surface
  std::size_t free_on = 0;        ///< those of them that are free
  std::set<std::int32_t> planes;  ///< that stay, of the others
};

/** \brief Finds the points of a source beside cylinders. Points that follow one another
 * are near each other in most clouds, so that whole blocks of them are passed over. */
class SourceBlocks {
public:
  /** \param[in] source must outlive this object */
  explicit SourceBlocks(const RawCloud& source);

  /** \param[in] owners cylinder of each point of the source, -1 for none
   * \param[in] replaced planes that the cylinder replaces */
  PointsBeside
  beside(const PointLabels& owners,
         const std::vector<std::int32_t>& replaced,
         const Cylinder& cylinder,
         const CylinderReach& reach) const;

private:
  /** A ball around points that follow one another. */
  struct Block {
    static constexpr std::size_t length = 256;

    Eigen::Vector3d center;
    double radius;
  };

  const RawCloud& source_;
  std::vector<Block> blocks_;
};

} // namespace pcl::acmap::cylinders
