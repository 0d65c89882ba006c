#include "images/image_codecs.h"
#include "source_checks.h"

#include <cmath>

using namespace pcl::acmap;

/** Bytes are rejected, or give an image that is unchanged by writing and reading. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const auto image = test::acceptedBy(readPfm, data, size);
  if (!image)
    return 0;
  const std::vector<std::uint8_t> bytes = encodePfm(*image);
  ByteSource source("again", bytes.data(), bytes.size());
  const pcl::DisparityImage again = readPfm(source);
  test::require(again.width == image->width && again.height == image->height);
  test::require(again.values.size() == image->values.size());
  for (std::size_t i = 0; i < again.values.size(); ++i)
    test::require(!std::isinf(again.values[i]) &&
                  test::isSame(again.values[i], image->values[i]));
  return 0;
}
