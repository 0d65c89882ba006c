#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

/** \brief Runs a fuzz target once with an empty input, and with each file of the
 * folders. */
int
main(int count, char** folders)
{
  const std::uint8_t nothing = 0;
  LLVMFuzzerTestOneInput(&nothing, 0);
  int inputs = 0;
  for (int i = 1; i < count; ++i)
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(folders[i])) {
      if (!entry.is_regular_file())
        continue;
      std::ifstream file(entry.path(), std::ios::binary);
      const std::string bytes{std::istreambuf_iterator<char>(file), {}};
      LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                             bytes.size());
      ++inputs;
    }
  std::cout << inputs << " inputs\n";
  return 0;
}
