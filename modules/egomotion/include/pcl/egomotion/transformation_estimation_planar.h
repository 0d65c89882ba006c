#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/point_types.h>
#include <pcl/egomotion/impl/motion_fit_kernel.h>
#include <pcl/memory.h>
#include <pcl/registration/transformation_estimation.h>

#include <vector>

namespace pcl::registration {

/** \brief Estimates the motion that aligns matched points: minimises Eq. 2 of "Active
 * Stereo Based Compact Mapping" (II-B.1),
 * E (R, t) = sum B_ij |M_{t-1}^j - (R M_t^i + t)|^2, by conjugate gradient as in the
 * paper, or in closed form.
 *
 * Planar (default): the action of the paper, x, z and the rotation about y; heights
 * remain unchanged. Rigid: all six degrees of freedom. It can be used in PCL's own
 * ICP (`setTransformationEstimation`). The matrix maps points of the source to the
 * target's frame, metres; computations are in double precision. Pairs that are not
 * finite are ignored. What the pairs do not determine remains unchanged: everything
 * without a pair; rotations with one pair or with all points at one position; the
 * rotation about a line that contains all points (Rigid: the smallest of the possible
 * rotations). Time O(n).
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

  /** \brief Sets the motion model of the camera (default Planar). */
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

  /** \brief Sets the method for minimising Eq. 2 (default ConjugateGradient). */
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

  /** \brief Sets the weights of the pairs, in the order of the pairs of the next calls;
   * empty (default): equal weights. Use 1 / sigma^2.
   * \throws BadArgumentException unless all are finite and >= 0 */
  void
  setCorrespondenceWeights(const std::vector<double>& weights);

  const std::vector<double>&
  getCorrespondenceWeights() const
  {
    return weights_;
  }

  /** \throws BadArgumentException if clouds, indices, correspondences or weights differ
   * in number, or for an index outside of its cloud; this applies to all four overloads
   */
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

#ifdef PCL_NO_PRECOMPILE
#include <pcl/egomotion/impl/transformation_estimation_planar.hpp>
#endif
