#pragma once

#include <pcl/features/impl/voting_kernel.h>

namespace pcl::acmap::voting {

/** The sum V of w N N^T over the votes at a vertex (Page et al., Eq. 7). */
class Ballot {
public:
  void
  add(const Eigen::Vector3f& vote, float weight)
  {
    const Eigen::Vector3f weighted = weight * vote;
    xx_ += weighted.x() * vote.x();
    xy_ += weighted.x() * vote.y();
    xz_ += weighted.x() * vote.z();
    yy_ += weighted.y() * vote.y();
    yz_ += weighted.y() * vote.z();
    zz_ += weighted.z() * vote.z();
    ++votes_;
  }

  std::size_t
  votes() const
  {
    return votes_;
  }

  /** Computes the eigenvectors and the class (Eq. 9, 10).
   * \param[in] front side to which the normal is oriented */
  VotedNormal
  count(const Eigen::Vector3f& front, const VotingSettings& settings) const;

private:
  float xx_ = 0, xy_ = 0, xz_ = 0, yy_ = 0, yz_ = 0, zz_ = 0;
  std::size_t votes_ = 0;
};

/** Result for a vertex without enough votes. */
VotedNormal
noNormal();

} // namespace pcl::acmap::voting
