#include "rgbd/image_sizes.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/image_file.h>
#include <pcl/core/impl/size_text.h>

#include <cmath>
#include <optional>
#include <utility>

namespace pcl::acmap {

namespace {

struct FrameSizes {
  ImageSize color, depth;
};

/** \brief Sizes of the first whole frame; damaged ones are named when they are read. */
std::optional<FrameSizes>
sizesOf(const std::vector<RgbdFrame>& frames)
{
  constexpr std::size_t attempts = 3;
  for (std::size_t i = 0; i < std::min(attempts, frames.size()); ++i) {
    try {
      FrameSizes sizes;
      const GrayImage16 depth = loadGrayImage16(frames[i].depth);
      sizes.depth = {depth.width, depth.height};
      if (!frames[i].color.empty()) {
        const RgbImage color = loadRgbImage(frames[i].color);
        sizes.color = {color.width, color.height};
      }
      return sizes;
    }
    catch (const InputFileException&) {
      continue;
    }
  }
  return std::nullopt;
}

/** \brief Is the principal point within the middle half of images of a size? */
bool
isCentred(const Pinhole& camera, const ImageSize& size)
{
  return std::abs(2 * camera.cx - size.width) < 0.5 * size.width &&
         std::abs(2 * camera.cy - size.height) < 0.5 * size.height;
}

void
fitDepthCamera(const FrameSizes& sizes, RgbdSequence& sequence)
{
  ImageSize from = sequence.camera_size;
  const bool is_of_colors = from.width == 0 && sizes.color.width > 0 &&
                            !sequence.color_camera &&
                            !isCentred(sequence.camera, sizes.depth) &&
                            isCentred(sequence.camera, sizes.color);
  if (is_of_colors)
    from = sizes.color;
  if (from.width == 0 || from.height == 0 || areSame(from, sizes.depth))
    return;
  if (!isEnlarged(from, sizes.depth) && !isEnlarged(sizes.depth, from)) {
    sequence.remarks.push_back("the camera is that of images of " + sizeText(from) +
                               " pixels, the depth images have another shape, " +
                               sizeText(sizes.depth) + "; --intrinsics states theirs");
    return;
  }
  sequence.camera = scaledPinhole(sequence.camera, from, sizes.depth);
  sequence.remarks.push_back("the camera is that of images of " + sizeText(from) +
                             " pixels: scaled to the depth images' " +
                             sizeText(sizes.depth) +
                             "; --intrinsics states another one");
}

} // namespace

bool
areSame(const ImageSize& a, const ImageSize& b)
{
  return a.width == b.width && a.height == b.height;
}

bool
isEnlarged(const ImageSize& large, const ImageSize& small)
{
  constexpr double slack = 0.01;
  if (small.width <= 0 || small.height <= 0)
    return false;
  const double across = double{1} * large.width / small.width;
  const double down = double{1} * large.height / small.height;
  return across > 1 && std::abs(across - down) < slack * across;
}

Pinhole
scaledPinhole(const Pinhole& camera, const ImageSize& from, const ImageSize& to)
{
  const double across = double{1} * to.width / from.width;
  const double down = double{1} * to.height / from.height;
  // The outer edges of both images are at -0.5 px.
  return {camera.fx * across,
          camera.fy * down,
          (camera.cx + 0.5) * across - 0.5,
          (camera.cy + 0.5) * down - 0.5};
}

void
fitCameras(bool has_camera, RgbdSequence& sequence)
{
  const std::optional<FrameSizes> sizes = sizesOf(sequence.frames);
  if (!sizes)
    return;
  if (!has_camera)
    fitDepthCamera(*sizes, sequence);
  sequence.camera_size = sizes->depth;
}

} // namespace pcl::acmap
