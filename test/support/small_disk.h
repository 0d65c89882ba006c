#pragma once

#include <cstddef>
#include <string>

namespace pcl::acmap::test {

/** \brief A small file system mounted on a folder, visible in this process and its
 * children: it can be full, or read-only even for the superuser. */
class SmallDisk {
public:
  /** \brief May this process mount file systems? The first call acquires the
   * permission, and must happen before there are any threads. */
  static bool
  isAllowed();

  /** \param[in] folder must exist; its contents are hidden by an empty file system
   * \param[in] bytes size of the file system */
  SmallDisk(const std::string& folder, std::size_t bytes);
  ~SmallDisk();

  SmallDisk(const SmallDisk&) = delete;
  SmallDisk&
  operator=(const SmallDisk&) = delete;

  /** \brief Fills the file system except for some pages of 4096 bytes. */
  void
  fill(std::size_t pages_left) const;

  void
  makeReadOnly() const;

private:
  std::string folder_;
};

} // namespace pcl::acmap::test
