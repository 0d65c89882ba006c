#pragma once

#include <pcl/core/cloud_rows.h>
#include <pcl/core/export.h>
#include <pcl/core/planar_scan.h>
#include <pcl/mapping/entropy_rectification.h>
#include <pcl/mapping/map_levelling.h>
#include <pcl/pipeline/cost_callback.h>
#include <pcl/pipeline/sequence_consolidation.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {

/** \brief The scans of a planar laser as observations, to be rectified.
 * \ingroup pipeline */
struct LaserObservations : ConsolidatedObservations {
  std::vector<PlanarScan> scans;    ///< one for each observation
  std::size_t points = 0;           ///< echoes
  std::size_t missing_beams = 0;    ///< beams without an echo
  std::vector<std::string> remarks; ///< warnings, one per line
};

/** \brief Makes observations of the scans of a CARMEN log (\ref loadCarmenLog) or of a bag
 * (\ref loadBagScans): clouds of their echoes, which weigh as much as the wall that they
 * represent, with the poses of the scans. Where stamps do not grow, they become the numbers
 * of the scans.
 * \code
 * pcl::LaserObservations seen = pcl::observationsOf (pcl::loadCarmenLog ("a.log").scans);
 * pcl::MapLevelling<pcl::PointNormal> levelling;
 * levelling.setUpDirection (-Eigen::Vector3d::UnitY ());
 * const pcl::RectifiedLaser straight = pcl::rectifyLaser (seen, levelling, {});
 * pcl::saveCorrectedLog ("corrected.log", seen, straight.poses);
 * \endcode
 * \param[in] every take only each n-th scan; 0 is taken as 1
 * \throws BadArgumentException when an angle is not finite \ingroup pipeline */
ACMAP_EXPORT LaserObservations
observationsOf(std::vector<PlanarScan> scans, std::size_t every = 1);

/** \brief What a rectification of laser observations has found. \ingroup pipeline */
struct RectifiedLaser {
  MapLevellingReport levelling;
  EntropyRectificationReport report;
  std::vector<Eigen::Isometry3d> poses; ///< T_map_laser of each observation
};

/** \brief Levels and rectifies the poses of laser observations.
 * \param[in,out] observations level afterwards
 * \param[in] levelling with the vertical, if it is known; that of a CARMEN log is -y
 * \param[in] rectification without clouds; with its threads and its progress
 * \throws what the two classes throw \ingroup pipeline */
ACMAP_EXPORT RectifiedLaser
rectifyLaser(LaserObservations& observations,
             const MapLevelling<PointNormal>& levelling,
             EntropyRectification<PointNormal> rectification);

/** \brief The echoes of all observations under new poses as one cloud, which is that of a
 * map: x y z and `view`, the number of the observation.
 * \param[in] poses T_map_laser of each observation
 * \param[in] cost is called before memory is taken, see \ref CostCallback
 * \throws BadArgumentException unless there is a pose for each \ingroup pipeline */
ACMAP_EXPORT CloudRows
echoesOf(const LaserObservations& observations,
         const std::vector<Eigen::Isometry3d>& poses,
         const CostCallback& cost = {});

/** \brief Writes the scans under new poses as a CARMEN log, with the poses that they had as
 * its odometry.
 * \throws BadArgumentException as above, and as \ref saveCarmenLog
 * \throws OutputFileException when it could not be written completely \ingroup pipeline */
ACMAP_EXPORT void
saveCorrectedLog(const std::string& path,
                 const LaserObservations& observations,
                 const std::vector<Eigen::Isometry3d>& poses);

/** \brief Writes a line `stamp x y theta` for each observation: seconds, metres, radians; x
 * forward, y left, theta counter-clockwise.
 * \throws as above \ingroup pipeline */
ACMAP_EXPORT void
savePlanarPoses(const std::string& path,
                const LaserObservations& observations,
                const std::vector<Eigen::Isometry3d>& poses);

} // namespace pcl
