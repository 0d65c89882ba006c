#pragma once

#include <pcl/core/export.h>
#include <pcl/core/image_file.h>

namespace pcl {

/** \brief What casts patterns on the scene. Shots are kept in step with patterns by
 * calling \ref show between them. \ingroup acquisition */
class ACMAP_EXPORT PatternProjector {
public:
  virtual ~PatternProjector();

  PatternProjector(const PatternProjector&) = delete;
  PatternProjector&
  operator=(const PatternProjector&) = delete;

  /** \brief Casts a pattern; it stays until the next call. Returns when the pattern was
   * handed to the device.
   * \throws BadArgumentException when the image is empty or has not all its values
   * \throws IOException when the device fails */
  virtual void
  show(const RgbImage& image) = 0;

  /** \brief Casts black, for the shot that gives the texture.
   * \throws IOException when the device fails */
  virtual void
  showNothing() = 0;

protected:
  PatternProjector() = default;
};

} // namespace pcl
