#pragma once

#include <pcl/core/cloud_rows.h>
#include <pcl/core/export.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/core/up_evidence.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief A surface, used to estimate the up direction. */
struct FacingArea {
  Eigen::Vector3d normal; ///< of length 1, of either sign
  double area;            ///< > 0, in any unit
};

/** \brief Result of \ref estimateUp. */
struct UpEstimate {
  Eigen::Vector3d up;
  double share = 0; ///< of the area that is horizontal or vertical
};

/** \brief By which planes may deviate from horizontal or vertical, radians. */
constexpr double up_tolerance = 5 * 3.14159265358979323846 / 180;

/** \brief Share of the area below which an estimate is not to be used. */
constexpr double min_up_share = 1.0 / 3;

/** \brief The direction with respect to which most of the area is horizontal or
 * vertical, by least squares.
 * \param[in] expected of length 1; only directions within 60 degrees of it are
 * considered, nearer ones are preferred
 * \param[in] tolerance radians by which surfaces may deviate */
ACMAP_EXPORT UpEstimate
estimateUp(std::vector<FacingArea> facings,
           const Eigen::Vector3d& expected,
           double tolerance);

/** \brief Refines an up direction by least squares with weights that fall from 1 at no
 * deviation from horizontal or vertical to 0 at the tolerance (Tukey), in radians. */
ACMAP_EXPORT Eigen::Vector3d
refineUp(const std::vector<FacingArea>& facings,
         const Eigen::Vector3d& up,
         double tolerance);

/** \brief Is an up direction within half a degree of an axis? Robots keep their sensors
 * level more accurately than surfaces can show. */
ACMAP_EXPORT bool
isLevel(const Eigen::Vector3d& up, const Eigen::Vector3d& axis);

/** \brief The up direction by which free space tells the sides of the surfaces of a cloud; none
 * if its sensors do, or if it is not known.
 * \param[in] cloud its field `view` names sensors
 * \param[in] up of the cloud; where its sensors do not fit, an assumed one, too
 * \param[in] has_sensor is one sensor known for all points?
 * \param[in] sensors_fit can the surface have been seen from the sensor? */
ACMAP_EXPORT std::optional<Eigen::Vector3d>
upWithoutSensors(const CloudRows& cloud,
                 const UpEvidence& up,
                 bool has_sensor,
                 bool sensors_fit);

} // namespace pcl::acmap
