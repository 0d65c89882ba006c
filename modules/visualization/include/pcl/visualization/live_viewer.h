#pragma once

#include <pcl/core/export.h>
#include <pcl/core/point_types.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/point_cloud.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace pcl {

/** \brief A line or an area of a plan in one colour: red, green, blue.
 * \ingroup visualization */
struct PlanLine {
  std::vector<Eigen::Vector2d>
      points; ///< metres; a closed line repeats its first point, an area does not
  std::array<std::uint8_t, 3> color{};
  bool is_area = false; ///< drawn below the lines, in the given order
};

/** \brief A window with the last cloud, next to it the last images in small size, and
 * below it the plan of the map so far if one is made; a label says what each is, and how
 * many frames come in a second. Used by one thread. After the user has closed it, nothing
 * is shown any more.
 * \code
 * std::mutex drawing;
 * pcl::LiveViewer viewer (drawing, "what the rig sees");
 * while (!viewer.isClosed ()) {
 *   viewer.show (*next_cloud ());
 *   viewer.update ();
 * }
 * \endcode
 * \ingroup visualization */
class ACMAP_EXPORT LiveViewer {
public:
  /** \param[in] drawing is locked during drawing, as Xlib is not safe among threads;
   * outlives the window
   * \throws InitFailedException with advice when there is no X server */
  LiveViewer(std::mutex& drawing, const std::string& title);

  ~LiveViewer();

  /** \brief Sets the images of a frame; the next \ref update draws them. */
  void
  show(const TrinocularFrame& frame);

  /** \brief Sets a cloud in the camera's frame. */
  void
  show(const PointCloud<PointXYZRGBSigma>& cloud);

  /** \brief Sets a plan; its longer side is laid along the window. */
  void
  showPlan(const std::vector<PlanLine>& lines);

  /** \brief Sets a line that says how the work goes, such as "12 observations, 31 m²". */
  void
  showStatus(const std::string& text);

  /** \brief Draws new data and processes mouse events, at most ten times a second. */
  void
  update();

  /** \brief Has the user closed it, or did the X server go away? */
  bool
  isClosed() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace pcl
