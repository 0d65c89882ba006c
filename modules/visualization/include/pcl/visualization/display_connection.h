#pragma once

#include <pcl/core/export.h>

struct xcb_connection_t;

namespace pcl::acmap {

/** \brief A connection to the X server that VTK is going to use.
 *
 * VTK aborts the process if no X server answers. This connection survives an X server
 * that goes away, which those of Xlib do not. Keep the connection as long as VTK
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

  /** \brief Has the X server not gone away so far? */
  bool
  isOpen() const;

  /** \brief From now on, the loss of a connection of Xlib no longer ends the process;
   * what is drawn through it afterwards is lost.
   * \param[in] display a Display of Xlib, such as that of a window of VTK */
  static void
  surviveLossOf(void* display);

private:
  xcb_connection_t* connection_;
};

} // namespace pcl::acmap
