#pragma once

#include "texturing/canvas.h"

#include <cstddef>
#include <vector>

namespace pcl::acmap::texturing {

/** The canvases of a polygon, or that of a cylinder, as one grid of texels: what is decided on
 * it does not depend on the maximum size of a texture. */
class Sheet {
public:
  /** \param[in] first number of its first canvas
   * \param[in] maximum texels per side of a canvas */
  Sheet(const std::vector<Canvas>& canvases, std::size_t first, int maximum);

  /** Number of its first canvas. */
  std::size_t
  begin() const
  {
    return first_;
  }

  /** Number of the canvas after its last one. */
  std::size_t
  end() const
  {
    return first_ + static_cast<std::size_t>(charts_a_row_ * charts_a_column_);
  }

  std::int32_t
  width() const
  {
    return width_;
  }

  std::int32_t
  height() const
  {
    return height_;
  }

  /** Where a texel of the sheet is. */
  struct Place {
    std::size_t canvas;
    std::size_t texel;
  };

  Place
  placeOf(std::int32_t column, std::int32_t row) const
  {
    if (charts_a_row_ == 1 && charts_a_column_ == 1) // the divisions below take time
      return {first_, (*canvases_)[first_].index(column, row)};
    const std::size_t canvas =
        first_ +
        static_cast<std::size_t>(row / maximum_ * charts_a_row_ + column / maximum_);
    return {canvas, (*canvases_)[canvas].index(column % maximum_, row % maximum_)};
  }

  const Canvas::Samples&
  samplesOf(const Place& place) const
  {
    return (*canvases_)[place.canvas].samples[place.texel];
  }

private:
  const std::vector<Canvas>* canvases_;
  std::size_t first_;
  std::int32_t maximum_;
  std::int32_t width_ = 0, height_ = 0; ///< texels
  std::int32_t charts_a_row_ = 1, charts_a_column_ = 1;
};

/** The sheets of all canvases, in their order. */
std::vector<Sheet>
sheetsOf(const std::vector<Canvas>& canvases, int maximum);

} // namespace pcl::acmap::texturing
