#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Numbers of points that detected and true planes have in common. */
class PlaneOverlaps {
public:
  /** \param[in] truth,found plane of each point, -1 for none */
  PlaneOverlaps(const std::vector<std::int32_t>& truth,
                std::size_t truth_planes,
                const std::vector<std::int32_t>& found,
                std::size_t found_planes);

  std::size_t
  truths() const
  {
    return truth_sizes_.size();
  }

  std::size_t
  founds() const
  {
    return found_sizes_.size();
  }

  std::size_t
  common(std::size_t found, std::size_t truth) const
  {
    return common_[found * truths() + truth];
  }

  /** \brief Points of a true plane. */
  std::size_t
  truthSize(std::size_t truth) const
  {
    return truth_sizes_[truth];
  }

  /** \brief All points of a detected plane. */
  std::size_t
  foundSize(std::size_t found) const
  {
    return found_sizes_[found];
  }

  /** \brief Points of a detected plane that belong to any true plane. */
  std::size_t
  labelledSize(std::size_t found) const;

  /** \brief The true plane with most points of a detected one, -1 for none. */
  std::int32_t
  majority(std::size_t found) const;

private:
  std::vector<std::size_t> truth_sizes_;
  std::vector<std::size_t> found_sizes_;
  std::vector<std::size_t> common_;
};

} // namespace pcl::acmap::bench
