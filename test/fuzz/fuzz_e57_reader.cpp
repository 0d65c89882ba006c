#include "fuzzed_reader.h"

#include "clouds/e57_pages.h"
#include "clouds/point_cloud_readers.h"

#include <algorithm>
#include <string>

/** The input is a file without its checksums, which hardly any input would have right. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  constexpr std::size_t content = 1020;
  std::string file;
  for (std::size_t from = 0; from < size; from += content) {
    std::string page(reinterpret_cast<const char*>(data) + from,
                     std::min(content, size - from));
    page.resize(content);
    const std::uint32_t checksum = pcl::acmap::e57Checksum(page.data(), page.size());
    for (int shift = 24; shift >= 0; shift -= 8)
      page.push_back(static_cast<char>(checksum >> shift & 255));
    file += page;
  }
  return pcl::acmap::test::readFuzzed(
      reinterpret_cast<const std::uint8_t*>(file.data()),
      file.size(),
      [](pcl::acmap::ByteSource& source) { return pcl::acmap::readE57(source); });
}
