#pragma once

#include <pcl/core/cloud_assessment_types.h>
#include <pcl/core/cloud_rows.h>
#include <pcl/core/export.h>
#include <pcl/core/impl/file_of_cloud.h>
#include <pcl/core/noise_scale.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/stage_controls.h>

#include <memory>
#include <optional>
#include <vector>

namespace pcl {

namespace acmap {

/** \brief The up direction of a cloud if it is stated: by the caller, else by its file.
 * \param[in] given by the caller, of length 1 */
ACMAP_EXPORT std::optional<UpEvidence>
statedUp(const std::optional<Eigen::Vector3d>& given, const PointCloudFile& file);

} // namespace acmap

/** \brief Says what a cloud is: its unit, which direction is up, whether one sensor measured
 * it, its noise with an interval, its spacing, and what its colours are.
 *
 * What the other classes assume of a cloud that neither its file nor the caller states, they
 * take from here. Each finding has its evidence, or it is *assumed* or *undetermined*, with
 * what is then done in its place; a remark of the report names the setter and the option that
 * state it. Nothing here changes the cloud.
 *
 * Takes linear time, well below that of finding the planes. The result is the same for any
 * number of threads.
 * \code
 * pcl::CloudAssessment assessment;
 * assessment.setInputCloud (cloud);
 * assessment.compute ();
 * if (assessment.getReport ().up.isKnown ())
 *   levelling.setUpDirection (assessment.getReport ().up.value);
 * \endcode
 * \ingroup core */
class ACMAP_EXPORT CloudAssessment : public StageControls<CloudAssessmentReport> {
public:
  /** \brief Sets the cloud, with what its file and the caller state of it.
   * \throws InitFailedException without one */
  void
  setInputCloud(const std::shared_ptr<const PointCloudFile>& file);

  /** \brief The same for rows that may be larger than the memory.
   * \param[in] file what is stated of the rows; none: nothing */
  void
  setInputCloud(const CloudRows& rows,
                std::shared_ptr<const PointCloudFile> file = nullptr);

  /** \brief The same for a cloud of a point type, which is copied. */
  template <typename PointT>
  void
  setInputCloud(const std::shared_ptr<const PointCloud<PointT>>& cloud)
  {
    setInputCloud(acmap::fileOf(cloud));
  }

  template <typename PointT>
  void
  setInputCloud(const std::shared_ptr<PointCloud<PointT>>& cloud)
  {
    setInputCloud(std::shared_ptr<const PointCloud<PointT>>(cloud));
  }

  /** \brief Sets the positions of the sensor for the observations that a field `view` of the
   * points refers to, metres.
   * \throws BadArgumentException when one is not finite */
  void
  setViewpoints(std::vector<Eigen::Vector3f> viewpoints);

  /** \brief States the up direction, whatever the file says.
   * \param[in] up of any length above 0
   * \throws BadArgumentException if it is not finite or zero */
  void
  setUpDirection(const Eigen::Vector3d& up);

  /** \throws InitFailedException without a cloud
   * \throws CancelledException if the progress callback stopped it */
  void
  compute();

  /** \brief Noise and spacing as the other classes use them, from the last run. */
  const NoiseScale&
  getNoiseScale() const
  {
    return scale_;
  }

private:
  CloudRows rows_;
  std::shared_ptr<const PointCloudFile> file_;
  std::vector<Eigen::Vector3f> viewpoints_;
  std::optional<Eigen::Vector3d> given_up_;
  NoiseScale scale_;
};

} // namespace pcl
