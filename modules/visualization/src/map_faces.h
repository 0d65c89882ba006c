#pragma once

#include <pcl/core/compact_map.h>

#include <Eigen/Core>

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief The faces of one plane with one chart, or of a cylinder: convex,
 * counter-clockwise seen from the side to which the normal points. */
struct MapFaces {
  std::size_t plane = 0;   ///< or the number of planes plus that of the cylinder
  std::size_t polygon = 0; ///< number in the plane
  const TexturePicture* chart = nullptr; ///< null: without a texture
  std::vector<Eigen::Vector3f> points;   ///< metres
  std::vector<Eigen::Vector2f> places;   ///< texture coordinates of the points, 0 to 1
  std::vector<std::vector<std::int32_t>> faces;
};

/** \brief Faces of all polygons and cylinders, without textures. */
std::vector<MapFaces>
facesOf(const CompactMap& map);

/** \brief As above, but with textures: polygons with charts are cut along the borders of the
 * charts; parts of them that no chart covers are left out.
 * \throws BadArgumentException for charts that do not fit the map */
std::vector<MapFaces>
cutFaces(const CompactMap& map, const std::vector<MapFaces>& faces);

/** \brief Points distributed evenly over the faces, and the corners of the faces.
 * \throws InitFailedException when there is no face */
std::vector<Eigen::Vector3f>
samplesOf(const std::vector<MapFaces>& faces);

/** \brief First intersection of a ray with a plane or a cylinder. */
struct RayHit {
  std::size_t plane; ///< as in MapFaces
  double distance;   ///< as a multiple of the direction
};

/** \param[in] fronts_only ignores faces that face away from the eye */
std::optional<RayHit>
firstHit(const std::vector<MapFaces>& faces,
         const Eigen::Vector3d& eye,
         const Eigen::Vector3d& direction,
         bool fronts_only);

} // namespace pcl::acmap
