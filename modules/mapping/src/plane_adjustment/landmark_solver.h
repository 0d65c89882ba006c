#pragma once

#include "odometry_prior.h"
#include "plane_landmarks.h"
#include "pose_system.h"
#include "revisit_links.h"

#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief Pairs of rows (views without the first one) that landmarks or actions connect.
 */
std::vector<PoseSystem::Pair>
connectedRows(const std::vector<Landmark>& landmarks, std::size_t views);

/** \brief Fits the planes of landmarks to given poses.
 * \return chi^2: the sum over the views of pi' T M T^T pi */
double
fitLandmarks(const Poses& poses, std::vector<Landmark>& landmarks);

/** \brief Adds landmarks to the normal equations of the poses; the planes, which must
 * have been fitted, are eliminated (Schur complement). Pose i is row i - 1.
 * \param[in,out] gradient one per row */
void
linearizeLandmarks(const Poses& poses,
                   const std::vector<Landmark>& landmarks,
                   PoseSystem& system,
                   std::vector<Vector6>& gradient);

/** \brief Levenberg-Marquardt steps on the poses, from all evidence: odometry, revisits
 * and landmarks.
 * \param[in] steps maximum number
 * \return the farthest move of a pose, metres */
double
minimize(const OdometryPrior& prior,
         const RevisitLinks& links,
         std::size_t steps,
         std::vector<Landmark>& landmarks,
         Poses& poses);

/** \brief Distance of a view's points from the plane of the landmark, in the middle of
 * these points, metres. */
double
distanceOfView(const Landmark& landmark, const LandmarkView& view, const Poses& poses);

/** \brief Root mean square of \ref distanceOfView. */
double
thicknessOf(const std::vector<Landmark>& landmarks, const Poses& poses);

} // namespace pcl::acmap
