// Writes small files of every encoding, from which the fuzzers set out.
//   write_fuzz_seeds FOLDER   makes FOLDER/pcd and FOLDER/ply

#include <liblzf/lzf.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

namespace fs = std::filesystem;

template <typename Value>
std::string
bytesOf(Value value)
{
  return {reinterpret_cast<const char*>(&value), sizeof(value)};
}

void
save(const fs::path& path, const std::string& content)
{
  fs::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file << content;
  file.close();
  if (!file)
    throw std::runtime_error("cannot write " + path.string());
}

void
writePcdSeeds(const fs::path& folder)
{
  const std::string header =
      "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z rgb normal _\nSIZE 4 4 4 4 2 1\n"
      "TYPE F F F U I U\nCOUNT 1 1 1 1 3 2\nWIDTH 2\nHEIGHT 1\n"
      "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ";
  save(folder / "ascii.pcd",
       header + "ascii\n1 2 3 4 5 6 7 8 9\nnan -1.5 +2e3 255 -1 0 1 0 0\n");
  save(folder / "binary.pcd", header + "binary\n" + std::string(48, 'b'));
  save(folder / "doubles.pcd",
       "FIELDS z x y\nSIZE 8 2 4\nTYPE F U I\nWIDTH 3\nDATA binary\n" +
           std::string(42, 'd'));
  save(folder / "back.pcd",
       "FIELDS a x y _ z\nCOUNT 2 1 1 -4 1\nSIZE 4 4 4 1 4\nTYPE F F F U F\n"
       "POINTS 2\nDATA binary\n" +
           std::string(32, 'e'));
  const std::string block(44, 'c');
  std::string packed(60, '\0');
  packed.resize(lzf_compress(block.data(),
                             static_cast<unsigned>(block.size()),
                             packed.data(),
                             static_cast<unsigned>(packed.size())));
  save(folder / "compressed.pcd",
       header + "binary_compressed\n" +
           bytesOf(static_cast<std::uint32_t>(packed.size())) +
           bytesOf(static_cast<std::uint32_t>(block.size())) + packed);
}

void
writePlySeeds(const fs::path& folder)
{
  const std::string elements =
      "comment seed\nelement extra 1\nproperty short a\nproperty list char uchar b\n"
      "element vertex 2\nproperty double x\nproperty float y\nproperty int z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  const std::string alpha = "property uchar alpha\n";
  const std::string list = "property list uchar short w\n";
  const std::string end =
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  save(folder / "ascii.ply",
       "ply\nformat ascii 1.0\n" + elements + list + end +
           "5 2 6 7\n1.5 -2e0 3 0 128 255 2 1 2\nnan inf 9 1 2 3 0\n3 0 1 1\n");
  // In either byte order: an empty list, two points, an empty face.
  const std::string extra(3, '\0');
  const std::string face(1, '\0');
  save(folder / "little.ply",
       "ply\nformat binary_little_endian 1.0\n" + elements + alpha + end + extra +
           std::string(40, 'l') + face);
  save(folder / "big.ply",
       "ply\nformat binary_big_endian 1.0\n" + elements + alpha + end + extra +
           std::string(40, 'b') + face);
  save(folder / "lists.ply",
       "ply\nformat binary_big_endian 1.0\n" + elements + list + end + extra +
           std::string(19, 'v') + face + std::string(19, 'v') + face + face);
  save(folder / "floats.ply",
       "ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float x\n"
       "property float y\nproperty float z\nproperty float nx\nend_header\n" +
           std::string(32, 'f'));
}

} // namespace

int
main(int argc, char** argv)
try {
  if (argc != 2) {
    std::cerr << "usage: write_fuzz_seeds FOLDER\n";
    return 2;
  }
  writePcdSeeds(fs::path(argv[1]) / "pcd");
  writePlySeeds(fs::path(argv[1]) / "ply");
  return 0;
}
catch (const std::exception& exception) {
  std::cerr << exception.what() << "\n";
  return 1;
}
