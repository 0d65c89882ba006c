#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/fields.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/core/report.h>
#include <pcl/egomotion/impl/worst_out_kernel.h>
#include <pcl/memory.h>
#include <pcl/point_cloud.h>
#include <pcl/registration/correspondence_rejection.h>

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl::registration {

/** \brief Report of CorrespondenceRejectorWorstOut on its last run.
 * \ingroup egomotion */
struct WorstOutReport : Report {
  std::size_t given = 0, kept = 0;
  std::size_t invalid = 0; ///< removed because a point is not finite
  double distortion = 0;   ///< largest D_ij of the kept matches
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const WorstOutReport& report, Visitor&& visit)
{
  visit({"given"}, report.given);
  visit({"kept"}, report.kept);
  visit({"invalid"}, report.invalid);
  visit({"distortion"}, report.distortion);
}

/** \brief Removes matches that contradict a rigid motion: leaving the worst out,
 * "Active Stereo Based Compact Mapping", II-B.1 and Eq. 1. A rigid motion preserves
 * distances; D_ij is the mean, over the other matches (k, l), of the larger ratio
 * between |M_t^i - M_t^k| and |M_{t-1}^j - M_{t-1}^l|, 1 for a perfect match. The match
 * with the largest D_ij is removed repeatedly until none exceeds
 * \ref setMaximumDistortion.
 *
 * This requires neither a motion nor a search tree: it can be used before any
 * alignment, and in PCL's own ICP (`addCorrespondenceRejector`). Pairs that are closer
 * than \ref setMinimumDistance in both clouds provide no information and are skipped; a
 * match without any valid pair is removed. If fewer than \ref setMinimumMatches remain,
 * none is returned. Of equally bad matches the first one is removed first; apart from
 * this, the result does not depend on their order.
 *
 * Time O(n^2) once and O(n) per removal, memory O(n). For more than \ref setSampleSize
 * matches, Eq. 1 is a mean over an evenly chosen sample, which is cleaned first; the
 * time is then O(n).
 *
 * In paper mode (\ref setPaperMode) Eq. 1 is computed as printed.
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

  /** \brief Sets the cloud to which `index_query` refers. \throws BadArgumentException
   * without a cloud */
  template <typename PointT>
  void
  setInputSource(const typename PointCloud<PointT>::ConstPtr& cloud)
  {
    source_ = placesOf<PointT>(cloud);
  }

  /** \brief Sets the cloud to which `index_match` refers. \throws BadArgumentException
   * without a cloud */
  template <typename PointT>
  void
  setInputTarget(const typename PointCloud<PointT>::ConstPtr& cloud)
  {
    target_ = placesOf<PointT>(cloud);
  }

  /** \brief Sets the maximum D_ij of a match that is kept (default 1.06).
   * \throws BadArgumentException unless within [1, 1000] */
  void
  setMaximumDistortion(double distortion);

  double
  getMaximumDistortion() const
  {
    return settings_.max_distortion;
  }

  /** \brief Sets the minimum distance between two points (default 0.05), metres. Pairs
   * that are closer in both clouds are skipped; a distance that is shorter in one cloud
   * only is replaced by the minimum.
   * \throws BadArgumentException unless within [0, 1e6] */
  void
  setMinimumDistance(double metres);

  double
  getMinimumDistance() const
  {
    return settings_.min_distance;
  }

  /** \brief Sets the minimum number of matches that must agree (default 6).
   * \throws BadArgumentException unless within [3, 1e6] */
  void
  setMinimumMatches(std::size_t matches);

  std::size_t
  getMinimumMatches() const
  {
    return settings_.min_matches;
  }

  /** \brief Sets the maximum number of matches for the mean of Eq. 1 (default 1000).
   * \throws BadArgumentException unless within [10, 1e6] */
  void
  setSampleSize(std::size_t matches);

  std::size_t
  getSampleSize() const
  {
    return settings_.sample;
  }

  /** \brief If true, Eq. 1 is computed as printed (default false): D_ij is the sum over
   * all matches (k, l), those of near points and (i, j) itself included, divided by
   * their number |M|. Two distances of 0 have the ratio 1, so that D_ij of a perfect
   * match is 1; a distance of 0 in one cloud only has the ratio 1000. Minimum distance,
   * minimum number of matches and sample size have no effect then; only
   * \ref setMaximumDistortion has, which the paper leaves open. */
  void
  setPaperMode(bool paper)
  {
    settings_.paper = paper;
  }

  bool
  getPaperMode() const
  {
    return settings_.paper;
  }

  const WorstOutReport&
  getReport() const
  {
    return report_;
  }

  /** \brief Keeps the matches that agree, in their order.
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

  /** \brief For PCL's ICP. \throws BadArgumentException without a cloud, or if its
   * fields x, y and z are missing or not one 32 bit float each */
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
    acmap::requireCloud<acmap::BadArgument>(cloud);
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
