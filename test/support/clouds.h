#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace pcl::acmap::test {

using Cloud = PointCloud<PointXYZ>;

PointXYZ
toPoint(const Eigen::Vector3d& p);

/** \brief Points on a parametrized surface; each has its true parameters (u, v). */
struct SheetCloud {
  Cloud cloud;
  std::vector<Eigen::Vector2d> parameters;
  Eigen::Vector2d minimum = Eigen::Vector2d::Zero(); ///< minimum (u, v) of the surface
  Eigen::Vector2d maximum = Eigen::Vector2d::Zero();
  double spacing = 1;
};

/** \brief How a sheet is sampled. Lengths in metres. */
struct SheetSampling {
  int columns = 45;
  int rows = 45;
  double spacing = 1;
  double jitter = 0.25; ///< of the spacing, in each direction within the surface
  double noise = 0;     ///< of the spacing, one standard deviation along the normal
  std::uint64_t seed = 1;
};

/** \brief The plane z = 0, centred at the origin. */
SheetCloud
makeJitteredPlane(const SheetSampling& sampling);

/** \brief A plane folded along x = 0 by \a fold radians: its right half goes up (down
 * if negative). */
SheetCloud
makeFoldedPlane(const SheetSampling& sampling, double fold);

/** \brief A plane whose spacing increases from one end to the other by the factor \a
 * growth. */
SheetCloud
makeGradedPlane(const SheetSampling& sampling, double growth);

/** \brief A sheet on a sphere of \a radius metres, around its pole (0, 0, radius). */
SheetCloud
makeSphereCap(const SheetSampling& sampling, double radius);

/** \brief Planes on which float coordinates are exact. */
enum class ExactPlane {
  Level,   ///< z = 0
  Inclined ///< z = x
};

/** \brief Square grid with cocircular points everywhere; exact if the spacing is a
 * power of two. */
Cloud
makeGrid(int columns, int rows, double spacing, ExactPlane plane);

/** \brief Rows shifted by half a spacing: six neighbours per point, nearly
 * cocircular. */
Cloud
makeHexagonalGrid(int columns, int rows, double spacing);

/** \brief Uniformly distributed points in a square of side 1. */
Cloud
makeRandomPlane(std::size_t size, ExactPlane plane, std::uint64_t seed);

/** \brief The points with integer coordinates that are exactly on a circle: 12 for
 * radius 5, 20 for 25, 36 for 65; with or without the centre. */
Cloud
makeExactCircle(int radius, bool with_center);

/** \brief Uniformly distributed points in a cube of side 1: no surface at all. */
Cloud
makeRandomBox(std::size_t size, std::uint64_t seed);

/** \brief All points with integer coordinates in a cube: only ties and right angles. */
Cloud
makeLattice(int side);

/** \brief Jittered Moebius band of the given radius. */
Cloud
makeMoebiusBand(
    int around, int across, double radius, double width, std::uint64_t seed);

/** \brief Two planes, one above the other at a distance. */
Cloud
makeParallelSheets(const SheetSampling& sampling, double distance);

/** \brief Three planes that meet at right angles in the origin. */
Cloud
makeCorner(const SheetSampling& sampling);

/** \brief Floor and four walls, 4 m by 3 m by 2.5 m, observed from its centre. */
Cloud
makeRoom(double spacing, double noise, std::uint64_t seed);

Cloud
makeCoincident(std::size_t size);

/** \brief Collinear, equally spaced points in a direction that is no coordinate
 * axis. */
Cloud
makeCollinear(std::size_t size);

/** \brief Every point twice: a second copy of the cloud is appended. */
Cloud
doubled(const Cloud& cloud);

/** \brief Inserts a point that is not finite before every \a period points. */
Cloud
lacedWithNan(const Cloud& cloud, std::size_t period);

Cloud
withOutlier(Cloud cloud, float coordinate);

Cloud
permuted(const Cloud& cloud, std::uint64_t seed);

Cloud
moved(const Cloud& cloud, const Eigen::Isometry3d& motion);

Cloud
scaled(const Cloud& cloud, float factor);

Eigen::Isometry3d
makeRandomMotion(std::uint64_t seed, double distance);

/** \brief View of a stereo camera into a corridor 2.4 m wide and 2.7 m high: the given
 * number of its 640 x 480 rays, with noise of clamp (0.0025 z^2, 1, 3) cm along the
 * ray. */
Cloud
makeCorridorView(std::size_t size, std::uint64_t seed);

} // namespace pcl::acmap::test
