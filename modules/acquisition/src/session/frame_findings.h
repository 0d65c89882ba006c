#pragma once

#include <pcl/acquisition/trinocular_file_grabber.h>

#include <mutex>
#include <string>

namespace pcl::acmap {

/** \brief The report of a grabber, which is extended while frames are read. Reading a
 * frame again adds nothing. */
class FrameFindings {
public:
  explicit FrameFindings(TrinocularFileReport report);

  void
  addBroken(std::uint64_t number, const std::string& fault);

  /** \brief Checks the brightness of the images. */
  void
  addRead(const TrinocularFrame& frame);

  TrinocularFileReport
  report() const;

private:
  void
  add(std::vector<std::uint64_t> TrinocularFileReport::*list,
      std::uint64_t number,
      const std::string& remark);

  mutable std::mutex mutex_;
  TrinocularFileReport report_;
};

} // namespace pcl::acmap
