#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/point_types.h>
#include <pcl/egomotion/motion_fit_kernel.h>
#include <pcl/memory.h>
#include <pcl/registration/transformation_estimation.h>

#include <vector>

namespace pcl::registration {

/** \brief The motion that brings matched points together: minimises Eq. 2 of "Active
 * Stereo Based Compact Mapping" (II-B.1), E (R, t) = sum B_ij |M_{t-1}^j - (R M_t^i + t)|^2,
 * by conjugate gradient as the paper, or in closed form.
 *
 * Planar (default): the paper's action, x and z and a turn about y; the points' heights are
 * left as they are. Rigid: all six. For PCL's own ICP as well (`setTransformationEstimation`).
 * The matrix takes the source's points into the target's frame, metres; double precision
 * inside. Pairs that are not finite do not count. What the pairs leave open stays as it is:
 * all without a pair, turns with one pair or with all in one place, the turn about a line
 * that all lie on (Rigid; of those that remain the shortest is taken). Time O(n).
 * \code
 * pcl::registration::TransformationEstimationPlanar<pcl::PointXYZ, pcl::PointXYZ> fit;
 * Eigen::Matrix4f T_target_source;
 * fit.estimateRigidTransformation (now, before, matches, T_target_source);
 * \endcode
 * \ingroup egomotion
 */
template <typename PointSource, typename PointTarget, typename Scalar = float>
class TransformationEstimationPlanar
: public TransformationEstimation<PointSource, PointTarget, Scalar> {
  using Base = TransformationEstimation<PointSource, PointTarget, Scalar>;

public:
  using Ptr = shared_ptr<TransformationEstimationPlanar>;
  using ConstPtr = shared_ptr<const TransformationEstimationPlanar>;
  using Matrix4 = typename Base::Matrix4;

  /** \brief Sets how the camera may move (default Planar). */
  void
  setMotionModel(MotionModel model)
  {
    model_ = model;
  }

  MotionModel
  getMotionModel() const
  {
    return model_;
  }

  /** \brief Sets how to minimise (default ConjugateGradient). */
  void
  setSolver(MotionSolver solver)
  {
    solver_ = solver;
  }

  MotionSolver
  getSolver() const
  {
    return solver_;
  }

  /** \brief Sets how much each pair counts, in the order of the pairs of the next calls;
   * empty (default): all the same. Take 1 / sigma^2.
   * \throws BadArgumentException unless all are finite and >= 0 */
  void
  setCorrespondenceWeights(const std::vector<double>& weights);

  const std::vector<double>&
  getCorrespondenceWeights() const
  {
    return weights_;
  }

  /** \throws BadArgumentException where clouds, indices, correspondences or weights differ
   * in number, or for an index outside of its cloud; this holds for all four */
  void
  estimateRigidTransformation(const PointCloud<PointSource>& cloud_src,
                              const PointCloud<PointTarget>& cloud_tgt,
                              Matrix4& transformation_matrix) const override;

  void
  estimateRigidTransformation(const PointCloud<PointSource>& cloud_src,
                              const Indices& indices_src,
                              const PointCloud<PointTarget>& cloud_tgt,
                              Matrix4& transformation_matrix) const override;

  void
  estimateRigidTransformation(const PointCloud<PointSource>& cloud_src,
                              const Indices& indices_src,
                              const PointCloud<PointTarget>& cloud_tgt,
                              const Indices& indices_tgt,
                              Matrix4& transformation_matrix) const override;

  void
  estimateRigidTransformation(const PointCloud<PointSource>& cloud_src,
                              const PointCloud<PointTarget>& cloud_tgt,
                              const Correspondences& correspondences,
                              Matrix4& transformation_matrix) const override;

private:
  using Places = std::vector<Eigen::Vector3d>;

  void
  fit(const Places& source, const Places& target, Matrix4& transformation_matrix) const;

  MotionModel model_ = MotionModel::Planar;
  MotionSolver solver_ = MotionSolver::ConjugateGradient;
  std::vector<double> weights_;
};

} // namespace pcl::registration
