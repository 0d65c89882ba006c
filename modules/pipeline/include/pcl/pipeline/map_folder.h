#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>
#include <pcl/core/point_types.h>
#include <pcl/core/progress.h>
#include <pcl/core/trajectory.h>
#include <pcl/core/triangle_mesh.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/point_cloud.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {

/** \brief All that the folder of a map, or of a rectification, holds; any part may be empty.
 * \ingroup pipeline */
struct MapFolder {
  CompactMap map;          ///< with the trajectory
  PCLPointCloud2 cloud;    ///< map.pcd
  PCLPointCloud2 vertices; ///< of mesh.ply
  TriangleMesh mesh;       ///< indexes the vertices
  /** \brief The poses before the rectification; not one for each of the map's in a damaged
   * folder, which \ref remarks names. */
  Trajectory trajectory_before;
  std::vector<std::string> remarks; ///< warnings about the files
};

/** \brief Reads map.json with its images, mesh.ply, map.pcd, trajectory.txt and
 * trajectory_before.txt, as far as they are there.
 * \code
 * const pcl::MapFolder result = pcl::loadMapFolder ("map");
 * std::cout << result.map.planes.size () << " planes, " << result.mesh.triangles.size () << " triangles\n";
 * \endcode
 * \throws InputFileException if there is neither a map.json nor a map.pcd with its
 * trajectory.txt, or a file is malformed \ingroup pipeline */
ACMAP_EXPORT MapFolder
loadMapFolder(const std::string& folder);

/** \brief Some of the points of all observations in the frame of the map, each with the number of
 * its observation, and the poses. \ingroup pipeline */
struct SequenceSample {
  PointCloud<PointXYZRGBNormalView> points; ///< metres, finite; normals are not set
  Trajectory trajectory;
};

/** \brief Reads a sequence for a picture: of each observation the same number of points at most,
 * at equal distances in the order of the cloud.
 * \param[in] max_points of all observations together, about
 * \param[in] progress is told each observation
 * \throws InputFileException if an observation cannot be read
 * \throws CancelledException when the callback requests it \ingroup pipeline */
ACMAP_EXPORT SequenceSample
sampleSequence(const ObservationSequence& sequence,
               std::size_t max_points,
               const ProgressCallback& progress = {});

} // namespace pcl
