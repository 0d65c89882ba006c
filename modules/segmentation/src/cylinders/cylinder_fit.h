#pragma once

#include "cylinders/cylinder.h"

#include <optional>

namespace pcl::acmap::cylinders {

using Vector5 = Eigen::Matrix<double, 5, 1>;
using Matrix5 = Eigen::Matrix<double, 5, 5>;

/** Rays that meet a surface at a smaller cosine do not determine it. */
inline constexpr double min_slant = 0.2;

/** A cylinder fitted to samples. */
struct CylinderFit {
  Cylinder cylinder; ///< its point is at the middle of the samples

  /** Axes of the tangent space at the cylinder. */
  Eigen::Vector3d u = Eigen::Vector3d::UnitX();
  Eigen::Vector3d v = Eigen::Vector3d::UnitY();

  double rms = 0;        ///< metres, of the samples within the gate
  std::size_t count = 0; ///< number of these

  /** Of (shift along u, shift along v, tilt towards u, tilt towards v, radius), metres
   * and radians; NaN if there are too few patches of surface to estimate it. */
  Matrix5 covariance = Matrix5::Constant(std::nan(""));
};

/** Least-squares cylinder with a known axis through points with normals: the points are
 * c + r n across the axis, which is linear in c and r. The radius is negative if the
 * normals point inwards.
 * \param[out] residual root mean square, metres */
std::optional<Cylinder>
cylinderOfNormals(const std::vector<Eigen::Vector3d>& points,
                  const std::vector<Eigen::Vector3d>& normals,
                  const Eigen::Vector3d& axis,
                  double& residual);

/** Circle through points across an axis by Taubin's algebraic fit, as a cylinder. */
std::optional<Cylinder>
cylinderOfCircle(const std::vector<Sample>& samples, const Eigen::Vector3d& axis);

/** Fits all five parameters to samples with Tukey's weights, by Gauss and Newton's
 * method with Levenberg's damping. Residuals are along the rays where these are known.
 * \param[in] sigma standard deviation of the residuals, metres; samples beyond four of
 * it have no weight
 * \return nothing if the samples do not determine a cylinder */
std::optional<CylinderFit>
fitCylinder(const std::vector<Sample>& samples, const Cylinder& start, double sigma);

/** A few steps of the same over at most 500 of the samples, while it is not settled yet which
 * samples are of the cylinder. Does not set rms and count. */
std::optional<CylinderFit>
roughFit(const std::vector<Sample>& samples, const Cylinder& start, double sigma);

/** Sets the covariance of a fit from the variation of its residuals between patches of
 * surface, because noise that neighbouring samples share does not average out.
 * \param[in] patch side of a patch, metres */
void
setCovariance(const std::vector<Sample>& samples,
              double sigma,
              double patch,
              CylinderFit& fit);

/** Share of the squared residuals that taper, bend, oval and twist explain: it is large
 * for cones, tori and spheres.
 * \param[in] noise metres; residuals below it are not looked at */
double
misfit(const std::vector<Sample>& samples, const CylinderFit& fit, double noise);

} // namespace pcl::acmap::cylinders
