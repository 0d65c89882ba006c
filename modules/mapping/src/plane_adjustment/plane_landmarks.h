#pragma once

#include "odometry_prior.h"
#include "pose_system.h"
#include "view_pieces.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::acmap {

using PiecesOfViews = std::vector<std::vector<PlanePiece>>;

/** \brief Systematic error of the position of a view's surfaces, metres, which grows
 * with the square of the distance as the errors of triangulation do. */
struct SurfaceFloor {
  static constexpr double min_constant = 0.0002; ///< metres

  double constant = 0.001; ///< metres
  double per_square = 0;   ///< 1/m
  double minimum = 0;      ///< metres, of the annealing

  double
  variance(double distance) const
  {
    const double growth = per_square * distance * distance;
    return std::max(minimum * minimum, constant * constant + growth * growth);
  }
};

/** \brief How well the relative pose of two views is known: the covariance of the
 * relative motion (rotation, translation; axes of the map) at the first view. */
struct RelativeCovariance {
  Matrix6 matrix;
  double turn = 0; ///< radians, largest standard deviation of the rotation
};

/** \brief Relative covariances of pairs of views. */
class RelativeCovariances {
public:
  /** \param[in] inverse pose i is row i - 1; pose 0 is fixed
   * \param[in] pairs within its pattern, the smaller number first */
  RelativeCovariances(const PoseSystem& inverse,
                      const Poses& poses,
                      const std::vector<PoseSystem::Pair>& pairs);

  /** \brief Pairs of a view: the other view, and where the covariance at the position of
   * the first of both is. */
  struct Entry {
    std::size_t other, place;
  };

  const std::vector<Entry>&
  of(std::size_t view) const
  {
    return entries_[view];
  }

  const RelativeCovariance&
  at(std::size_t place) const
  {
    return covariances_[place];
  }

  /** \brief View at which the covariance of a place is. */
  std::size_t
  origin(std::size_t place) const
  {
    return origins_[place];
  }

private:
  std::vector<std::vector<Entry>> entries_;
  std::vector<RelativeCovariance> covariances_;
  std::vector<std::size_t> origins_;
};

/** \brief What a view has measured of a landmark. */
struct LandmarkView {
  std::size_t view;
  Eigen::Matrix4d cluster; ///< of its pieces, sensor's frame, with its floor
  double variance;         ///< m^2, of its noise across the plane, without floor
  double distance;         ///< metres, of the sensor
};

/** \brief A plane that several views see. */
struct Landmark {
  Eigen::Vector3d center; ///< metres, map
  Eigen::Vector3d normal; ///< unit vector, map
  double offset = 0;      ///< metres, of the plane from the centre along the normal
  std::vector<LandmarkView> views;
  std::size_t pieces = 0;
};

/** \brief Settings of an association. */
struct AssociationGate {
  double distance = 0.05; ///< metres, largest across a plane
  double inner = 3;       ///< standard deviations of the relative position
  double angle = 0.2;     ///< radians
  SurfaceFloor floor;
};

/** \brief Associates pieces of several views: the most informative pieces first, each
 * takes the free pieces within 0.5 m along its plane whose relative position is known
 * well enough. Quadratic in the density of the pieces, linear in the views. */
std::vector<Landmark>
findLandmarks(const PiecesOfViews& pieces,
              const Poses& poses,
              const RelativeCovariances& covariances,
              const AssociationGate& gate);

/** \brief Pairs of views that have seen the same place, and all consecutive ones; the
 * smaller number first, in order. */
std::vector<PoseSystem::Pair>
overlappingViews(const PiecesOfViews& pieces, const Poses& poses);

/** \brief Standard deviation across a piece of its position relative to the view at
 * which a relative covariance is.
 * \param[in] from_origin metres, from that view to the piece, axes of the map
 * \param[in] normal in the map */
double
deviationAcross(const RelativeCovariance& relative,
                const Eigen::Vector3d& from_origin,
                const Eigen::Vector3d& normal);

} // namespace pcl::acmap
