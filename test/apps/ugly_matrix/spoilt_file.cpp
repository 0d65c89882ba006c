#include "spoilt_file.h"

#include <pcl/core/random.h>

#include <sys/stat.h>

#include <filesystem>

namespace pcl::acmap::test {

std::string
garbage()
{
  Random random(1);
  std::string bytes(9000, ' ');
  for (char& byte : bytes)
    byte = static_cast<char>(random.bits());
  return bytes;
}

void
spoil(const std::string& path, Ugliness kind)
{
  const std::string whole = contentOf(path);
  if (!std::filesystem::remove(path))
    throw std::runtime_error(path + ": is not there to be spoilt");
  const auto write = [&](const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
  };
  if (kind == Ugliness::Empty)
    write("");
  if (kind == Ugliness::Truncated)
    write(whole.substr(0, whole.size() / 2));
  if (kind == Ugliness::Garbage)
    write(garbage());
  if (kind == Ugliness::Device && ::mkfifo(path.c_str(), 0600) != 0)
    throw std::runtime_error(path + ": no pipe can be made");
  if (kind == Ugliness::Folder)
    std::filesystem::create_directory(path);
}

const char*
stateOf(Ugliness kind)
{
  switch (kind) {
  case Ugliness::Missing:
    return "is not there";
  case Ugliness::Empty:
    return "has no byte";
  case Ugliness::Truncated:
    return "ends half-way";
  case Ugliness::Garbage:
    return "holds random bytes";
  case Ugliness::Device:
    return "is a pipe that nobody writes to";
  default:
    return "is a folder";
  }
}

} // namespace pcl::acmap::test
