#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/export.h>
#include <pcl/core/report.h>
#include <pcl/egomotion/worst_out_kernel.h>
#include <pcl/memory.h>
#include <pcl/point_cloud.h>
#include <pcl/registration/correspondence_rejection.h>

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl::registration {

/** \brief What CorrespondenceRejectorWorstOut tells about its last run. \ingroup egomotion */
struct WorstOutReport : Report {
  std::size_t given = 0, kept = 0;
  std::size_t invalid = 0; ///< with a point that is not finite: removed
  double distortion = 0;   ///< largest D_ij of those kept
};

/** \brief Removes matches that bend the scene: leaving the worst out, "Active Stereo Based
 * Compact Mapping", II-B.1 and Eq. 1. A rigid motion keeps distances; D_ij is the mean,
 * over the other matches (k, l), of the larger ratio between |M_t^i - M_t^k| and
 * |M_{t-1}^j - M_{t-1}^l|, 1 for a perfect match. The match with the largest is removed
 * again and again until none exceeds \ref setMaximumDistortion.
 *
 * Needs no motion and no tree: it works before any alignment, and inside of PCL's own
 * ICP (`addCorrespondenceRejector`). Pairs nearer than \ref setMinimumDistance in both
 * clouds tell nothing and are skipped; a match that no pair tells about is removed. Where
 * less than \ref setMinimumMatches remain, none is returned. Of equally bad matches the first is
 * removed first; nothing else depends on their order.
 *
 * Time O(n^2) once and O(n) a removal, memory O(n). Above \ref setSampleSize matches Eq.
 * 1 is a mean over evenly chosen ones, which are cleaned first: O(n) then.
 * \code
 * pcl::registration::CorrespondenceRejectorWorstOut rejector;
 * rejector.setInputSource<pcl::PointXYZRGB> (now);
 * rejector.setInputTarget<pcl::PointXYZRGB> (before);
 * rejector.getRemainingCorrespondences (matches, consistent);
 * \endcode
 * \ingroup egomotion
 */
class ACMAP_EXPORT CorrespondenceRejectorWorstOut : public CorrespondenceRejector {
public:
  using Ptr = shared_ptr<CorrespondenceRejectorWorstOut>;
  using ConstPtr = shared_ptr<const CorrespondenceRejectorWorstOut>;

  CorrespondenceRejectorWorstOut();

  /** \brief Sets the cloud that `index_query` points into. \throws BadArgumentException
   * without a cloud */
  template <typename PointT>
  void
  setInputSource(const typename PointCloud<PointT>::ConstPtr& cloud)
  {
    source_ = placesOf<PointT>(cloud);
  }

  /** \brief Sets the cloud that `index_match` points into. \throws BadArgumentException
   * without a cloud */
  template <typename PointT>
  void
  setInputTarget(const typename PointCloud<PointT>::ConstPtr& cloud)
  {
    target_ = placesOf<PointT>(cloud);
  }

  /** \brief Sets the largest D_ij of a match that stays (default 1.06).
   * \throws BadArgumentException unless within [1, 1000] */
  void
  setMaximumDistortion(double distortion);

  double
  getMaximumDistortion() const
  {
    return settings_.most_distortion;
  }

  /** \brief Sets below which distance two points tell nothing (default 0.05), metres;
   * where they are so near in one cloud alone, they are taken for that far apart.
   * \throws BadArgumentException unless within [0, 1e6] */
  void
  setMinimumDistance(double metres);

  double
  getMinimumDistance() const
  {
    return settings_.least_distance;
  }

  /** \brief Sets how many matches must agree (default 6).
   * \throws BadArgumentException unless within [3, 1e6] */
  void
  setMinimumMatches(std::size_t matches);

  std::size_t
  getMinimumMatches() const
  {
    return settings_.least_matches;
  }

  /** \brief Sets over how many matches Eq. 1 is a mean, at most (default 1000).
   * \throws BadArgumentException unless within [10, 1e6] */
  void
  setSampleSize(std::size_t matches);

  std::size_t
  getSampleSize() const
  {
    return settings_.sample;
  }

  const WorstOutReport&
  getReport() const
  {
    return report_;
  }

  /** \brief Keeps matches that agree, in their order.
   * \throws InitFailedException without source or target
   * \throws BadArgumentException for an index outside of them */
  void
  getRemainingCorrespondences(const Correspondences& original_correspondences,
                              Correspondences& remaining_correspondences) override;

  bool
  requiresSourcePoints() const override
  {
    return true;
  }

  /** \brief For PCL's ICP. \throws BadArgumentException without a cloud, or without fields
   * x y z of one 32 bit float in it */
  void
  setSourcePoints(PCLPointCloud2::ConstPtr cloud) override;

  bool
  requiresTargetPoints() const override
  {
    return true;
  }

  /** \brief For PCL's ICP. \throws BadArgumentException as \ref setSourcePoints */
  void
  setTargetPoints(PCLPointCloud2::ConstPtr cloud) override;

protected:
  void
  applyRejection(Correspondences& correspondences) override;

private:
  using Places = std::vector<Eigen::Vector3f>;

  template <typename PointT>
  static Places
  placesOf(const typename PointCloud<PointT>::ConstPtr& cloud)
  {
    if (!cloud)
      throw BadArgumentException("a cloud is missing");
    Places places;
    places.reserve(cloud->size());
    for (const PointT& point : *cloud)
      places.push_back(point.getVector3fMap());
    return places;
  }

  acmap::WorstOutSettings settings_;
  std::optional<Places> source_, target_;
  WorstOutReport report_;
};

} // namespace pcl::registration
