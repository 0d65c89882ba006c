#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::acmap {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/** \brief A symmetric positive definite matrix of 6 x 6 blocks, one row per pose, with
 * sparse Cholesky factor and selected inverse.
 *
 * The pattern is fixed at construction; poses are reordered by approximate minimum
 * degree. The entries of the inverse within the pattern of the factor are computed by
 * the recursion of Takahashi, Fagan and Chen (1973), in blocks. For a path along a
 * corridor all operations are linear in the number of poses. */
class PoseSystem {
public:
  using Pair = std::pair<std::size_t, std::size_t>;

  /** \param[in] pairs of poses with an off-diagonal block, in any order; repetitions
   * are permitted */
  PoseSystem(std::size_t poses, const std::vector<Pair>& pairs);

  std::size_t
  size() const
  {
    return place_.size();
  }

  void
  setZero();

  /** \brief Adds a block at row \a i and column \a j, and its transpose opposite. The
   * pair must be in the pattern. */
  void
  add(std::size_t i, std::size_t j, const Matrix6& block);

  /** \brief Adds to the diagonal of each diagonal block its \a share. */
  void
  damp(double share);

  /** \brief Replaces the matrix by its Cholesky factor.
   * \return false if it is not positive definite */
  bool
  factorize();

  /** \brief Solves for one right-hand side after \ref factorize. */
  std::vector<Vector6>
  solve(const std::vector<Vector6>& right) const;

  /** \brief Replaces the factor by the selected inverse. */
  void
  invert();

  /** \brief After \ref invert: a block of the inverse within the pattern. */
  Matrix6
  inverse(std::size_t i, std::size_t j) const;

  /** \brief Number of blocks of the factor below its diagonal. */
  std::size_t
  fill() const;

private:
  struct Column {
    Matrix6 diagonal;
    std::vector<std::size_t> rows; ///< ascending, below the diagonal
    std::vector<Matrix6> blocks;
  };

  Matrix6&
  blockAt(std::size_t row, std::size_t column);

  const Matrix6&
  blockAt(std::size_t row, std::size_t column) const;

  std::vector<std::size_t> place_; ///< row of each pose
  std::vector<Column> columns_;
};

} // namespace pcl::acmap
