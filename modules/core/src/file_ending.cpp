#include "file_ending.h"

#include <filesystem>

namespace pcl::acmap {

std::string
lowerEnding(const std::string& path)
{
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return ending;
}

} // namespace pcl::acmap
