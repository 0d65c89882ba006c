#include "clouds/e57_pages.h"

#include "files/byte_source.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace pcl::acmap {

namespace {

constexpr std::size_t page_size = 1024, checksum_size = 4,
                      content_size = page_size - checksum_size;

/** \brief Table of CRC-32C (Castagnoli), reflected. */
std::array<std::uint32_t, 256>
checksumTable()
{
  constexpr std::uint32_t polynomial = 0x82F63B78;
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t value = byte;
    for (int bit = 0; bit < 8; ++bit)
      value = value >> 1 ^ ((value & 1) != 0 ? polynomial : 0);
    table[byte] = value;
  }
  return table;
}

/** \brief The checksum at the end of a page, most significant byte first. */
std::uint32_t
storedChecksum(const char* page)
{
  std::uint32_t value = 0;
  for (std::size_t i = content_size; i < page_size; ++i)
    value = value << 8 | static_cast<unsigned char>(page[i]);
  return value;
}

std::uint64_t
numberAt(const std::string& bytes, std::size_t offset)
{
  std::uint64_t value = 0;
  std::memcpy(&value, &bytes[offset], sizeof value);
  return value;
}

} // namespace

std::uint32_t
e57Checksum(const char* bytes, std::size_t count)
{
  static const std::array<std::uint32_t, 256> table = checksumTable();
  std::uint32_t value = ~std::uint32_t{0};
  for (std::size_t i = 0; i < count; ++i)
    value = value >> 8 ^ table[(value ^ static_cast<unsigned char>(bytes[i])) & 255];
  return ~value;
}

E57Pages::E57Pages(ByteSource& source)
: source_(source)
, page_(static_cast<std::uint64_t>(-1))
{
  constexpr std::size_t header = 48;
  if (source.size() < page_size)
    source.fail("is shorter than a page of an E57 file");
  if (source.ahead(8).substr(0, 8) != "ASTM-E57")
    source.fail("is no E57 file: it does not begin with ASTM-E57");
  if (source.size() % page_size != 0)
    source.fail("is truncated: E57 files have whole pages of 1024 bytes");
  if (const std::uint64_t bytes = numberAt(read(0, header), 40); bytes != page_size)
    source.fail("has pages of " + std::to_string(bytes) +
                " bytes, those of 1024 are read");
}

void
E57Pages::requireChecksums()
{
  std::array<char, page_size> page{};
  source_.moveTo(0);
  for (std::size_t number = 0; source_.remaining() > 0; ++number) {
    source_.read(page.data(), page_size);
    if (e57Checksum(page.data(), content_size) != storedChecksum(page.data()))
      source_.fail("is damaged: the checksum of page " + std::to_string(number) +
                   " is wrong");
  }
}

std::string
E57Pages::xml()
{
  const std::string header = read(0, 48);
  const std::uint64_t begin = logical(numberAt(header, 24)),
                      length = numberAt(header, 32);
  if (begin > size() || length > size() - begin)
    source_.fail("has its XML beyond its end");
  return read(begin, length);
}

std::uint64_t
E57Pages::size() const
{
  return source_.size() / page_size * content_size;
}

std::string
E57Pages::read(std::uint64_t offset, std::uint64_t count)
{
  std::string bytes;
  bytes.reserve(count);
  while (bytes.size() < count) {
    const std::uint64_t page = (offset + bytes.size()) / content_size,
                        within = (offset + bytes.size()) % content_size;
    if (page != page_) {
      if (source_.size() - source_.remaining() != page * page_size)
        source_.moveTo(page * page_size);
      content_.resize(page_size);
      page_ = page;
      source_.read(content_.data(), page_size);
    }
    bytes.append(content_,
                 within,
                 std::min<std::uint64_t>(count - bytes.size(), content_size - within));
  }
  return bytes;
}

std::uint64_t
E57Pages::logical(std::uint64_t physical) const
{
  const std::uint64_t within = physical % page_size;
  if (within >= content_size)
    source_.fail("has an offset within a checksum");
  return physical / page_size * content_size + within;
}

} // namespace pcl::acmap
