#include <pcl/core/disparity_image.h>

#include "files/byte_source.h"
#include "files/text_number.h"
#include "images/image_codecs.h"

#include <pcl/core/impl/size_text.h>
#include <pcl/core/output_file.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace pcl {

namespace {

constexpr float unknown = std::numeric_limits<float>::infinity();
constexpr std::size_t value_bytes = sizeof(float);

/** \brief Contents of the three lines before the values. */
struct PfmHeader {
  std::size_t width = 0;
  std::size_t height = 0;
  bool big_endian = false;
};

std::string_view
nextLine(acmap::ByteSource& source)
{
  std::string_view line;
  if (!source.readLine(line))
    source.fail("is truncated: its header is not whole");
  return line;
}

void
readKind(acmap::ByteSource& source)
{
  const std::string_view kind = nextLine(source);
  if (kind == "PF")
    source.fail("is a PFM of three channels; a disparity image has one (Pf)");
  if (kind != "Pf")
    source.fail("is no PFM: begins with " + acmap::inQuotes(kind) + ", not with Pf");
}

void
readSize(acmap::ByteSource& source, PfmHeader& header)
{
  constexpr std::uint64_t longest_side = std::numeric_limits<std::int32_t>::max();
  acmap::Words words(nextLine(source));
  for (std::size_t* side : {&header.width, &header.height}) {
    std::string_view word;
    std::uint64_t pixels = 0;
    words.next(word);
    if (!acmap::parseCount(word, pixels) || pixels == 0 || pixels > longest_side)
      source.failAtLine(acmap::inQuotes(word) + " is no width or height in pixels");
    *side = pixels;
  }
  if (header.width * header.height > acmap::max_pixels)
    source.failAtLine("claims " + acmap::sizeText(header) +
                      " pixels, at most 2^28 are read");
}

PfmHeader
readHeader(acmap::ByteSource& source)
{
  PfmHeader header;
  readKind(source);
  readSize(source, header);
  const std::string_view word = nextLine(source);
  double scale = 0;
  if (!acmap::parseNumber(word, scale) || !std::isfinite(scale) || scale == 0.0)
    source.failAtLine(acmap::inQuotes(word) +
                      " is no scale: a number below 0 (little-endian) or above");
  header.big_endian = scale > 0.0;
  return header;
}

float
valueOf(const std::uint8_t* bytes, bool big_endian)
{
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < value_bytes; ++i)
    bits |= std::uint32_t{bytes[i]} << 8 * (big_endian ? value_bytes - 1 - i : i);
  float value = 0;
  std::memcpy(&value, &bits, sizeof(value));
  return std::isfinite(value) ? value : std::numeric_limits<float>::quiet_NaN();
}

void
appendValue(float value, std::vector<std::uint8_t>& bytes)
{
  const float written = std::isnan(value) ? unknown : value;
  std::uint32_t bits = 0;
  std::memcpy(&bits, &written, sizeof(bits));
  for (std::size_t i = 0; i < value_bytes; ++i)
    bytes.push_back(static_cast<std::uint8_t>(bits >> 8 * i));
}

} // namespace

std::vector<std::uint8_t>
acmap::encodePfm(const DisparityImage& image)
{
  requireImageValues(image.width, image.height, 1, image.values.size());
  const std::string header = "Pf\n" + std::to_string(image.width) + " " +
                             std::to_string(image.height) + "\n-1.0\n";
  std::vector<std::uint8_t> bytes(header.begin(), header.end());
  bytes.reserve(bytes.size() + value_bytes * image.values.size());
  for (std::int32_t row = image.height; row-- > 0;) // a PFM begins with the bottom row
    for (std::int32_t column = 0; column < image.width; ++column)
      appendValue(image.at(column, row), bytes);
  return bytes;
}

void
savePfm(const std::string& path, const DisparityImage& image)
{
  const std::vector<std::uint8_t> bytes = acmap::encodePfm(image);
  acmap::OutputFile file(path);
  file.write(bytes.data(), bytes.size());
  file.commit();
}

DisparityImage
acmap::readPfm(ByteSource& source)
{
  const PfmHeader header = readHeader(source);
  const std::uint64_t needed = value_bytes * header.width * header.height;
  if (source.remaining() != needed)
    source.fail((source.remaining() < needed ? "is truncated: " : "goes on: ") +
                std::to_string(source.remaining()) + " bytes follow its header, " +
                std::to_string(needed) + " are " + acmap::sizeText(header) + " values");
  DisparityImage image;
  image.width = static_cast<std::int32_t>(header.width);
  image.height = static_cast<std::int32_t>(header.height);
  image.values.resize(header.width * header.height);
  std::vector<std::uint8_t> bytes(value_bytes * header.width);
  for (std::int32_t row = image.height; row-- > 0;) {
    source.read(bytes.data(), bytes.size());
    for (std::int32_t column = 0; column < image.width; ++column)
      image.at(column, row) = valueOf(
          &bytes[value_bytes * static_cast<std::size_t>(column)], header.big_endian);
  }
  return image;
}

DisparityImage
loadPfm(const std::string& path)
{
  acmap::ByteSource source(path);
  return acmap::readPfm(source);
}

} // namespace pcl
