#pragma once

#include "bench.h"

#include <pcl/core/sensor_view.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <functional>

namespace pcl::acmap::bench {

/** \brief A cloud for plane detection, with prior knowledge for the methods. Lengths
 * are in metres; all points are finite. */
struct PlaneInput {
  PointCloud<PointXYZ>::Ptr points;

  /** \brief Sensor positions; empty if unknown. */
  std::vector<Eigen::Vector3f> origins;

  /** \brief Sensor of each point; empty if the first one observed all points. */
  std::vector<std::int32_t> views;

  double sigma = 0;   ///< noise across the surface
  double spacing = 0; ///< of the points

  /** \brief Maximum distance of a point from its plane for peers, which have one limit
   * per cloud. */
  double tolerance = 0;

  /** \brief Valid during the lifetime of the input. */
  SensorView
  sensors() const;

  /** \brief Minimum number of points of a plane for the peers: \ref largeCount. */
  std::size_t
  leastSupport() const;
};

/** \brief Tolerance for a known noise: three sigma, but at least 2 mm. */
double
toleranceFor(double sigma);

/** \brief Estimates sigma and spacing of a cloud of finite points, and sets the
 * tolerance. */
PlaneInput
makePlaneInput(const PointCloud<PointXYZ>::Ptr& points,
               std::vector<Eigen::Vector3f> origins,
               std::vector<std::int32_t> views);

/** \brief Minimum number of points of a large plane in a cloud of \a size points: 0.3
 * %. */
std::size_t
largeCount(std::size_t size);

/** \brief Result of a plane detection method. */
struct FoundPlanes {
  std::vector<Eigen::Vector4d> planes; ///< unit normal n and d: n.p + d = 0, metres
  std::vector<std::int32_t> labels;    ///< plane of each point, -1 for none
  double seconds = 0;                  ///< total CPU time of the calling thread

  /** \brief Of the points, those on a plane. */
  double
  labelledPercent() const;
};

using PlaneFinder = std::function<FoundPlanes(const PlaneInput&)>;

/** \brief A method with its name in the tables. */
struct NamedFinder {
  std::string name;
  PlaneFinder find;
  bool is_ours = false; ///< its figures are compared with targets

  /** Larger clouds would take too long and are skipped. */
  std::size_t max_points = std::numeric_limits<std::size_t>::max();

  bool is_slow = false; ///< takes several seconds for a view of 300,000 points
};

/** \brief Runs a function that returns planes, and measures its time. */
template <typename Function>
FoundPlanes
timedPlanes(const Function& find)
{
  const double begin = threadSeconds();
  FoundPlanes found = find();
  found.seconds = threadSeconds() - begin;
  return found;
}

/** \brief The methods of PCL and, if available, of CGAL. */
std::vector<NamedFinder>
peers();

/** \brief acmap, then these. */
std::vector<NamedFinder>
allFinders();

/** \brief Runs a method; fast ones run three times, and the median time is returned. */
FoundPlanes
findPlanes(const NamedFinder& finder, const PlaneInput& input);

/** \brief All stages of acmap on one thread: consolidation, mesh, voting, clustering,
 * labels. */
FoundPlanes
findAcmapPlanes(const PlaneInput& input);

/** \brief As above, with the tolerance that the peers get. */
FoundPlanes
findAcmapPlanesWithin(const PlaneInput& input);

/** \brief SACSegmentation with RANSAC, its fixed seed and optimised coefficients: finds
 * a plane, removes its points, and repeats until the next plane is too small. PCL selects
 * the inliers again after its own fit, which gives three times larger errors than
 * \ref planesOfRegions. */
std::vector<Indices>
sacRegions(const PlaneInput& input);

/** \brief RegionGrowing with the normals of NormalEstimation. */
std::vector<Indices>
pclRegions(const PlaneInput& input);

/** \brief Region growing on points, starting at the flattest ones. Needs CGAL 5. */
std::vector<Indices>
cgalRegions(const PlaneInput& input);

/** \brief Efficient RANSAC (Schnabel 2007) for planes, with a fixed seed; the plane
 * itself is defined by three points. */
std::vector<Indices>
ransacRegions(const PlaneInput& input);

/** \brief Fits a least-squares plane to the points of each region, because the region
 * methods return no plane or an inaccurate one. */
FoundPlanes
planesOfRegions(const PlaneInput& input, const std::vector<Indices>& regions);

} // namespace pcl::acmap::bench
