#include "images/image_codecs.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/size_text.h>

#include <turbojpeg.h>

#include <memory>
#include <type_traits>

namespace pcl {

namespace {

/** \brief There is at least one bit per block of 8 x 8 pixels. */
constexpr double max_pixels_per_byte = 512.0;
constexpr std::int32_t longest_side = 65500;

struct Destroy {
  void
  operator()(void* handle) const
  {
    tjDestroy(handle);
  }
};

struct Free {
  void
  operator()(std::uint8_t* bytes) const
  {
    tjFree(bytes);
  }
};

using Handle = std::unique_ptr<std::remove_pointer_t<tjhandle>, Destroy>;

Handle
made(tjhandle handle)
{
  if (!handle)
    throw std::bad_alloc();
  return Handle(handle);
}

[[noreturn]] void
fail(const Handle& handle)
{
  throw acmap::DamagedImage(std::string("JPEG: ") + tjGetErrorStr2(handle.get()));
}

} // namespace

namespace acmap {

bool
isJpeg(const ImageBytes& bytes)
{
  return bytes.size() >= 3 && bytes[0] == 0xff && bytes[1] == 0xd8 && bytes[2] == 0xff;
}

RgbImage
decodeJpeg(const ImageBytes& bytes)
{
  const Handle handle = made(tjInitDecompress());
  RgbImage image;
  int subsampling = 0;
  int colors = 0;
  if (tjDecompressHeader3(handle.get(),
                          bytes.data(),
                          bytes.size(),
                          &image.width,
                          &image.height,
                          &subsampling,
                          &colors) != 0)
    fail(handle);
  requireImageSize(static_cast<std::uint64_t>(image.width),
                   static_cast<std::uint64_t>(image.height),
                   max_pixels_per_byte,
                   bytes.size());
  image.values.resize(3 * static_cast<std::size_t>(image.width) *
                      static_cast<std::size_t>(image.height));
  // A warning means a missing end or invalid bits, which cause grey blocks in the
  // image.
  if (tjDecompress2(handle.get(),
                    bytes.data(),
                    bytes.size(),
                    image.values.data(),
                    image.width,
                    0,
                    image.height,
                    TJPF_RGB,
                    TJFLAG_ACCURATEDCT | TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS) != 0)
    fail(handle);
  return image;
}

} // namespace acmap

std::vector<std::uint8_t>
encodeJpeg(const RgbImage& image, int quality)
{
  acmap::requireWholeImage(image);
  if (quality < 1 || quality > 100)
    throw acmap::BadArgument("quality of a JPEG is " + std::to_string(quality) +
                             ", 1 to 100 are legal");
  if (image.width > longest_side || image.height > longest_side)
    throw acmap::BadArgument("an image of " + acmap::sizeText(image) +
                             " pixels is no JPEG, whose sides end at 65500");
  const Handle handle = made(tjInitCompress());
  std::uint8_t* bytes = nullptr;
  unsigned long size = 0;
  const int result = tjCompress2(handle.get(),
                                 image.values.data(),
                                 image.width,
                                 0,
                                 image.height,
                                 TJPF_RGB,
                                 &bytes,
                                 &size,
                                 TJSAMP_420,
                                 quality,
                                 TJFLAG_ACCURATEDCT | TJFLAG_PROGRESSIVE);
  const std::unique_ptr<std::uint8_t, Free> owner(bytes);
  if (result != 0)
    throw acmap::BadArgument(std::string("image cannot be a JPEG: ") +
                             tjGetErrorStr2(handle.get()));
  return {bytes, bytes + size};
}

} // namespace pcl
