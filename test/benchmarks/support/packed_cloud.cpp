#include "packed_cloud.h"

#include "temporary_folder.h"

#include <pcl/core/exceptions.h>

#include <array>
#include <cstdio>
#include <fstream>

namespace pcl::acmap::bench {
namespace {

bool
isPacked(const std::string& path)
{
  const std::string ending = ".xz";
  return path.size() > ending.size() &&
         path.compare(path.size() - ending.size(), ending.size(), ending) == 0;
}

/** \return false if xz is missing or failed */
bool
unpack(const std::string& packed, const std::string& unpacked)
{
  FILE* pipe = popen(("xz -dkc '" + packed + "'").c_str(), "r");
  if (!pipe)
    return false;
  std::ofstream file(unpacked, std::ios::binary);
  std::array<char, 1 << 16> bytes;
  while (const std::size_t got = fread(bytes.data(), 1, bytes.size(), pipe))
    file.write(bytes.data(), static_cast<std::streamsize>(got));
  return pclose(pipe) == 0 && file.good();
}

} // namespace

PointCloudFile
loadMaybePacked(const std::string& path)
{
  if (!isPacked(path))
    return loadPointCloud(path);
  const test::TemporaryFolder folder;
  const std::string unpacked = folder.path("cloud.ply");
  if (!unpack(path, unpacked))
    throw InputFileException(path + " was not unpacked: is there an xz?");
  return loadPointCloud(unpacked);
}

} // namespace pcl::acmap::bench
