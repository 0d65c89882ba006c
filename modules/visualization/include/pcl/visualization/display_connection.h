#pragma once

#include <pcl/core/export.h>

namespace pcl::acmap {

/** \brief A connection to the X server that VTK is going to use.
 *
 * VTK aborts the process if no X server answers. Keep the connection as long as VTK
 * draws: a virtual server resets when its last client disconnects, and refuses
 * connections meanwhile. A program that draws a picture at its end opens a connection
 * before its computation, so that a missing server is reported at once.
 * \ingroup visualization */
class ACMAP_EXPORT DisplayConnection {
public:
  /** \throws InitFailedException with advice if no X server answers */
  DisplayConnection();

  ~DisplayConnection();

  DisplayConnection(const DisplayConnection&) = delete;
  DisplayConnection&
  operator=(const DisplayConnection&) = delete;

private:
  void* display_;
};

} // namespace pcl::acmap
