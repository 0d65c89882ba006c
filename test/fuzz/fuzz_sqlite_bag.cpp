#include "bag/sqlite_bag.h"

#include <pcl/core/exceptions.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

/** \brief A file of this process, which is removed at its end. */
class InputOnDisk {
public:
  InputOnDisk()
  : path_(std::filesystem::temp_directory_path() / "acmap-fuzz-XXXXXX")
  {
    if (::mkstemp(path_.data()) < 0)
      std::abort();
  }

  ~InputOnDisk()
  {
    std::remove(path_.c_str());
  }

  const std::string&
  write(const std::uint8_t* data, std::size_t size) const
  {
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    return path_;
  }

private:
  std::string path_;
};

} // namespace

/** A database is refused, or each of its messages is as long as its index has it. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const InputOnDisk input;
  try {
    pcl::acmap::SqliteBag bag(input.write(data, size));
    const pcl::acmap::BagIndex index = bag.readIndex();
    for (const pcl::BagMessage& message : index.messages)
      if (message.channel >= index.channels.size() ||
          bag.load(message).size() != message.bytes)
        std::abort();
  }
  catch (const pcl::InputFileException&) {
    return 0;
  }
  return 0;
}
