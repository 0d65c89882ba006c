#pragma once

#include "memory.h"

#include <pcl/core/point_types.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/point_cloud.h>

#include <memory>
#include <mutex>

namespace pcl::acmap {

/** \brief A window with the last cloud, and beside it the last images, small. Used by one
 * thread. One that the user closes shows nothing any more. */
class LiveWindow {
public:
  /** \param[in] drawing is held while something is drawn; outlives it
   * \throws InitFailedException with advice when no X server answers */
  explicit LiveWindow(std::mutex& drawing);
  ~LiveWindow();

  LiveWindow(const LiveWindow&) = delete;
  LiveWindow&
  operator=(const LiveWindow&) = delete;

  /** \brief Takes the images of a frame; the next \ref update draws them. */
  void
  show(const TrinocularFrame& frame);

  /** \brief Takes a cloud in the camera's frame. */
  void
  show(const PointCloud<PointXYZRGBSigma>& cloud);

  /** \brief Draws what is new, heeds the mouse; not more often than the eye sees. */
  void
  update();

  /** \brief Whether the user has closed it. */
  bool
  isClosed() const;

private:
  UnlimitedMemory while_open_;
  struct Window;
  std::unique_ptr<Window> window_;
};

} // namespace pcl::acmap
