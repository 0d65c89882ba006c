#include "clouds/mesh_codecs.h"

#include "files/byte_source.h"
#include "files/text_number.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace pcl::acmap {

namespace {

constexpr std::uint64_t max_vertices = std::numeric_limits<std::int32_t>::max();

/** \brief Zero-based index of the vertex of a corner such as `7`, `7/1/2` or `-1`. */
std::int32_t
cornerOf(std::string_view word, std::uint64_t vertices, const ByteSource& source)
{
  std::string_view number = word.substr(0, word.find('/'));
  const bool backwards = number.substr(0, 1) == "-";
  if (backwards)
    number.remove_prefix(1);
  std::uint64_t value = 0;
  if (!parseCount(number, value))
    source.failAtLine("corner " + inQuotes(word) + " is not the number of a vertex");
  if (value == 0 || value > max_vertices || (backwards && value > vertices))
    source.failAtLine("corner " + inQuotes(word) + " lies outside of the vertices");
  return static_cast<std::int32_t>(backwards ? vertices - value : value - 1);
}

void
addFace(Words words, std::uint64_t vertices, const ByteSource& source, TriangleMesh& to)
{
  std::vector<std::int32_t> corners;
  for (std::string_view word; words.next(word) && word.front() != '#';)
    corners.push_back(cornerOf(word, vertices, source));
  for (std::size_t i = 2; i < corners.size(); ++i)
    to.triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

} // namespace

TriangleMesh
readObjFaces(ByteSource& source)
{
  TriangleMesh mesh;
  std::uint64_t vertices = 0;
  for (std::string_view line; source.readFilledLine(line);) {
    Words words(line);
    std::string_view key;
    if (!words.next(key))
      continue;
    if (key == "v")
      ++vertices;
    else if (key == "f")
      addFace(words, vertices, source, mesh);
  }
  // a face may precede its vertices
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const std::int32_t corner : mesh.triangles[t])
      if (static_cast<std::uint64_t>(corner) >= vertices)
        source.fail("face " + std::to_string(t) +
                    " has a corner outside of the vertices");
  return mesh;
}

} // namespace pcl::acmap
