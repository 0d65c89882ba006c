#pragma once

#include <pcl/core/point_types.h>
#include <pcl/point_cloud.h>

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace pcl::acmap::test {

using NaiveMatches = std::vector<std::pair<int, int>>; ///< pixels of source and target

/** \brief Brightness of an image; pixels outside repeat the border. */
struct NaiveImage {
  int width = 0, height = 0;
  std::vector<double> values;

  explicit NaiveImage(const PointCloud<PointXYZRGBSigma>& cloud);

  double
  at(int x, int y) const;
};

/** \brief The image after a Gaussian, sigma in pixels. */
NaiveImage
blurred(const NaiveImage& image, double sigma);

/** \brief Pixels with a point at which the gradient is larger than at all of their
 * eight neighbours, row by row. */
std::vector<int>
naiveKeypoints(const PointCloud<PointXYZRGBSigma>& cloud);

/** \brief Samples on 12 rings of 24 samples, from 1 to 20 pixels, ring by ring. */
std::vector<double>
patchAt(const NaiveImage& image, int pixel);

/** \brief Matches of two views by section II-B.1 of the paper: every pair of keypoints
 * is compared under every shift. Score 0.8, ambiguity 0.7. */
NaiveMatches
naiveMatches(const PointCloud<PointXYZRGBSigma>& source,
             const PointCloud<PointXYZRGBSigma>& target,
             int ring_shifts,
             int sector_shifts);

/** \brief Points of matches in both clouds. */
struct NaivePairs {
  std::vector<Eigen::Vector3d> source, target;
};

NaivePairs
pairsOf(const PointCloud<PointXYZRGBSigma>& source,
        const PointCloud<PointXYZRGBSigma>& target,
        const NaiveMatches& matches);

/** \brief D_ij of Eq. 1 as printed: the sum over all matches, divided by their number.
 */
double
naiveDistortion(const NaivePairs& pairs, std::size_t match);

/** \brief Removes the match with the largest D_ij until none exceeds the bound.
 * \return the indices that remain, ascending */
std::vector<std::size_t>
naiveLeaveWorstOut(const NaivePairs& pairs, double max_distortion);

/** \brief x, z and theta that minimise Eq. 2 with B_ij = 1. */
Eigen::Vector3d
naiveAction(const NaivePairs& pairs);

/** \brief Covariance of the small motion in x, z and about y in the target's frame,
 * after the action: that of least squares, from the residuals. */
Eigen::Matrix3d
naiveCovariance(const NaivePairs& pairs, const Eigen::Vector3d& action);

} // namespace pcl::acmap::test
