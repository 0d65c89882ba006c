#pragma once

#include <pcl/core/export.h>

namespace pcl::acmap {

/** \brief A connection to the X server that VTK is going to use.
 *
 * VTK aborts the process where none answers. Keep it as long as VTK draws: a virtual
 * server starts anew when its last client leaves, and refuses others meanwhile. A program
 * that ends with a picture opens one before its work, so as to fail at once.
 * \ingroup visualization */
class ACMAP_EXPORT DisplayConnection {
public:
  /** \throws InitFailedException with advice when no X server answers */
  DisplayConnection();

  ~DisplayConnection();

  DisplayConnection(const DisplayConnection&) = delete;
  DisplayConnection&
  operator=(const DisplayConnection&) = delete;

private:
  void* display_;
};

} // namespace pcl::acmap
