#pragma once

#include <pcl/core/export.h>
#include <pcl/core/image_file.h>

namespace pcl {

/** \brief Interface of a projector that shows patterns on the scene. Shots and patterns
 * are synchronized by calling \ref show between the shots. \ingroup acquisition */
class ACMAP_EXPORT PatternProjector {
public:
  virtual ~PatternProjector();

  PatternProjector(const PatternProjector&) = delete;
  PatternProjector&
  operator=(const PatternProjector&) = delete;

  /** \brief Shows a pattern until the next call. Returns when the pattern was passed to
   * the device.
   * \throws BadArgumentException when the image is empty or incomplete
   * \throws IOException when the device fails */
  virtual void
  show(const RgbImage& image) = 0;

  /** \brief Shows black, for the shot from which the texture is taken.
   * \throws IOException when the device fails */
  virtual void
  showNothing() = 0;

protected:
  PatternProjector() = default;
};

} // namespace pcl
