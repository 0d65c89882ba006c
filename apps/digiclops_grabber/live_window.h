#pragma once

#include "memory.h"

#include <pcl/core/point_types.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/point_cloud.h>

#include <memory>
#include <mutex>

namespace pcl::acmap {

/** \brief A window with the last cloud, and next to it the last images in small size.
 * Used by one thread. After the user has closed it, nothing is shown any more. */
class LiveWindow {
public:
  /** \param[in] drawing is locked during drawing; outlives the window
   * \throws InitFailedException with advice when there is no X server */
  explicit LiveWindow(std::mutex& drawing);
  ~LiveWindow();

  LiveWindow(const LiveWindow&) = delete;
  LiveWindow&
  operator=(const LiveWindow&) = delete;

  /** \brief Sets the images of a frame; the next \ref update draws them. */
  void
  show(const TrinocularFrame& frame);

  /** \brief Sets a cloud in the camera's frame. */
  void
  show(const PointCloud<PointXYZRGBSigma>& cloud);

  /** \brief Draws new data and processes mouse events, at a limited rate. */
  void
  update();

  /** \brief Has the user closed it? */
  bool
  isClosed() const;

private:
  UnlimitedMemory while_open_;
  struct Window;
  std::unique_ptr<Window> window_;
};

} // namespace pcl::acmap
