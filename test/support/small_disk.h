#pragma once

#include <cstddef>
#include <string>

namespace pcl::acmap::test {

/** \brief A disk of its own for a folder, seen by this process and those that it starts: it
 * can be full, or read-only for the superuser too. */
class SmallDisk {
public:
  /** \brief Whether this process may mount one; the first call takes what it needs for it,
   * before there are any threads. */
  static bool
  isAllowed();

  /** \param[in] folder must be there, and is empty from now on
   * \param[in] bytes it has room for */
  SmallDisk(const std::string& folder, std::size_t bytes);
  ~SmallDisk();

  SmallDisk(const SmallDisk&) = delete;
  SmallDisk&
  operator=(const SmallDisk&) = delete;

  /** \brief Leaves room for no more than some pages of 4096 bytes. */
  void
  fill(std::size_t pages_left) const;

  void
  makeReadOnly() const;

private:
  std::string folder_;
};

} // namespace pcl::acmap::test
