#include "frame_unpacking.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/size_text.h>

#include <opencv2/imgproc.hpp>

#include <array>

namespace pcl::acmap {

namespace {

void
requireLayout(const PlaneLayout& layout, std::size_t bytes)
{
  const int min_side = layout.bayer == BayerPattern::None ? 1 : 3;
  if (layout.width < min_side || layout.height < min_side)
    throw acmap::BadArgument("a frame of " + sizeText(layout) +
                             " pixels; legal are sides of at least " +
                             std::to_string(min_side));
  if (layout.cameras < 1 || layout.cameras > 3)
    throw acmap::BadArgument("a frame of " + std::to_string(layout.cameras) +
                             " cameras; legal are 1 to 3");
  for (std::size_t k = 1; k < static_cast<std::size_t>(layout.cameras); ++k)
    for (std::size_t before = 0; before < k; ++before)
      if (layout.order[k] == layout.order[before])
        throw acmap::BadArgument("a frame has the " +
                                 std::string(nameOf(layout.order[k])) +
                                 " camera twice");
  const std::size_t needed = static_cast<std::size_t>(layout.width) *
                             static_cast<std::size_t>(layout.height) *
                             static_cast<std::size_t>(layout.cameras);
  if (bytes < needed)
    throw acmap::BadArgument("a frame of " + std::to_string(bytes) +
                             " bytes; its images need " + std::to_string(needed));
}

/** Sets the size of the image and returns it as an OpenCV matrix that shares its
 * memory. */
cv::Mat
shape(CameraImage& image, const PlaneLayout& layout, int channels)
{
  image.width = layout.width;
  image.height = layout.height;
  image.channels = channels;
  image.values.resize(static_cast<std::size_t>(layout.width) *
                      static_cast<std::size_t>(layout.height) *
                      static_cast<std::size_t>(channels));
  return {layout.height, layout.width, CV_8UC(channels), image.values.data()};
}

/** OpenCV's older names begin at another corner of the pattern; these ones begin at the
 * upper left. */
int
conversionOf(BayerPattern bayer)
{
  switch (bayer) {
  case BayerPattern::Rggb:
    return cv::COLOR_BayerRGGB2RGB;
  case BayerPattern::Gbrg:
    return cv::COLOR_BayerGBRG2RGB;
  case BayerPattern::Grbg:
    return cv::COLOR_BayerGRBG2RGB;
  default:
    return cv::COLOR_BayerBGGR2RGB;
  }
}

} // namespace

BayerPattern
bayerPatternOf(const std::string& filter)
{
  if (filter.empty() || filter == "YYYY")
    return BayerPattern::None;
  if (filter == "RGGB")
    return BayerPattern::Rggb;
  if (filter == "GBRG")
    return BayerPattern::Gbrg;
  if (filter == "GRBG")
    return BayerPattern::Grbg;
  if (filter == "BGGR")
    return BayerPattern::Bggr;
  throw acmap::BadArgument("colour filter " + filter +
                           "; legal are RGGB, GBRG, GRBG, BGGR and YYYY");
}

void
unpackFrame(const std::vector<std::uint8_t>& bytes,
            const PlaneLayout& layout,
            TrinocularFrame& frame)
{
  requireLayout(layout, bytes.size());
  // OpenCV has no matrix of constant data; this one is only read.
  const cv::Mat interleaved(layout.height,
                            layout.width,
                            CV_8UC(layout.cameras),
                            const_cast<std::uint8_t*>(bytes.data()));
  const bool is_color = layout.bayer != BayerPattern::None;
  const int channels = is_color ? 3 : 1;
  const auto cameras = static_cast<std::size_t>(layout.cameras);
  std::array<bool, 3> is_there{};
  std::array<cv::Mat, 3> images;
  for (std::size_t k = 0; k < cameras; ++k) {
    images[k] = shape(frame.image(layout.order[k]), layout, channels);
    is_there[static_cast<std::size_t>(layout.order[k])] = true;
  }
  if (is_color) {
    std::array<cv::Mat, 3> mosaics;
    cv::split(interleaved, mosaics.data());
    for (std::size_t k = 0; k < cameras; ++k)
      cv::cvtColor(mosaics[k], images[k], conversionOf(layout.bayer));
  }
  else
    cv::split(interleaved, images.data());
  for (std::size_t i = 0; i < is_there.size(); ++i)
    if (!is_there[i])
      frame.images[i] = CameraImage();
}

} // namespace pcl::acmap
