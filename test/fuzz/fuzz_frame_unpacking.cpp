#include "checks.h"
#include "images/frame_unpacking.h"

#include <vector>

using namespace pcl::acmap;

namespace {

PlaneLayout
layoutOf(test::FuzzedBytes& numbers)
{
  PlaneLayout layout;
  layout.width = numbers.small();
  layout.height = numbers.small();
  layout.cameras = numbers.byte() % 5;
  const auto order = numbers.byte();
  for (std::size_t k = 0; k < layout.order.size(); ++k)
    layout.order[k] = static_cast<pcl::RigCamera>((order >> 2 * k) % 4 % 3);
  layout.bayer = static_cast<BayerPattern>(numbers.byte() % 5);
  return layout;
}

/** \brief Images exist exactly if the layout has them; without a colour filter, each
 * byte is at its position. */
void
requireUnpacked(const std::vector<std::uint8_t>& bytes,
                const PlaneLayout& layout,
                const pcl::TrinocularFrame& frame)
{
  const auto cameras = static_cast<std::size_t>(layout.cameras);
  const std::size_t pixels =
      static_cast<std::size_t>(layout.width) * static_cast<std::size_t>(layout.height);
  const bool is_color = layout.bayer != BayerPattern::None;
  std::size_t filled = 0;
  for (const pcl::CameraImage& image : frame.images)
    filled += image.values.empty() ? 0 : 1;
  test::require(filled == cameras);
  for (std::size_t k = 0; k < cameras; ++k) {
    const pcl::CameraImage& image =
        frame.images[static_cast<std::size_t>(layout.order[k])];
    test::require(image.width == layout.width && image.height == layout.height &&
                  image.values.size() == pixels * (is_color ? 3 : 1));
    for (std::size_t i = 0; !is_color && i < pixels; ++i)
      test::require(image.values[i] == bytes[i * cameras + k]);
  }
}

} // namespace

/** A layout is rejected, or the bytes of a frame are unpacked. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  test::FuzzedBytes numbers(data, size);
  const PlaneLayout layout = layoutOf(numbers);
  const std::vector<std::uint8_t> bytes(data + size - numbers.left(), data + size);
  pcl::TrinocularFrame frame;
  try {
    unpackFrame(bytes, layout, frame);
  }
  catch (const pcl::BadArgumentException&) {
    return 0;
  }
  requireUnpacked(bytes, layout, frame);
  return 0;
}
