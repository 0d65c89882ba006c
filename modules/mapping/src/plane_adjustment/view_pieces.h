#pragma once

#include <pcl/mapping/impl/plane_adjustment_kernel.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief A planar piece of a view, sensor's frame. */
struct PlanePiece {
  Eigen::Vector3d center; ///< weighted mean of its points, metres
  Eigen::Vector3d normal; ///< unit vector towards the sensor
  /** Sum over the points of [p; 1] [p; 1]^T / sigma_n^2, p on the plane of the piece:
   * the piece has no thickness of its own. sigma_n is the noise across the plane. */
  Eigen::Matrix4d cluster;
  double normal_sd; ///< radians, standard deviation of the normal, its worst direction
  double radius;    ///< metres, root mean square distance of the points from the centre

  /** \brief Inverse variance of the position across the plane, 1/m^2. */
  double
  weight() const
  {
    return cluster(3, 3);
  }

  double
  information() const
  {
    return weight() * radius * radius;
  }
};

/** \brief Noise along the ray in bins of distance whose limits differ by a factor of
 * sqrt (2), in units of the given sigma, or in metres if none is given. */
class RangeNoise {
public:
  static constexpr std::size_t bins = 24; ///< from 0.125 m

  RangeNoise()
  {
    factors_.fill(1);
  }

  /** \brief Standard deviation of a point.
   * \param[in] sigma as given; 1 without */
  double
  sigma(double distance, double sigma) const
  {
    return factors_[binOf(distance)] * sigma;
  }

  static std::size_t
  binOf(double distance);

  /** \brief Sets the factors of the bins; those that are not positive are taken from
   * their neighbours. */
  void
  set(const std::array<double, bins>& factors);

  /** \brief Share of the noise that neighbouring points have in common, as a factor of
   * sigma. */
  double common = 0;

private:
  std::array<double, bins> factors_;
};

/** \brief Measures the noise of a sensor on the views of a sequence: tiles that are as
 * planar as the best third are taken as planes. */
RangeNoise
measureRangeNoise(const AdjustedViewReader& read, std::size_t views);

/** \brief Counts of \ref piecesOf. */
struct PieceCounts {
  std::size_t points = 0, invalid_points = 0;
};

/** \brief Cuts a view into planar pieces. An organized view is divided into tiles of 32
 * pixels, which are quartered down to 8 pixels until they are planar; the rim of a tile
 * beyond which its surface does not go on is left out. Other views are divided into cubes
 * of 1 m, down to 25 cm. Planes are fitted by regression of the inverse distance, in which
 * they are linear in the ray, with weights from the predicted distance: those from the
 * measured one bias the fit. O(n log n). */
std::vector<PlanePiece>
piecesOf(const AdjustedView& view, const RangeNoise& noise, PieceCounts& counts);

} // namespace pcl::acmap
