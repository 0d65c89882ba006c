#include "gzip_text.h"

#include "byte_source.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <new>
#include <vector>

namespace pcl::acmap {

namespace {

constexpr std::size_t max_unpacked = std::size_t{1} << 30;
constexpr std::size_t chunk = std::size_t{1} << 16;

class Inflater {
public:
  explicit Inflater(const ByteSource& source)
  : source_(source)
  {
    constexpr int largest_window_of_gzip = 15 + 16;
    if (::inflateInit2(&stream_, largest_window_of_gzip) != Z_OK)
      throw std::bad_alloc();
  }

  ~Inflater()
  {
    ::inflateEnd(&stream_);
  }

  Inflater(const Inflater&) = delete;
  Inflater&
  operator=(const Inflater&) = delete;

  void
  append(unsigned char* packed, std::size_t bytes, std::string& text)
  {
    stream_.next_in = packed;
    stream_.avail_in = static_cast<uInt>(bytes);
    do {
      if (at_end_ && ::inflateReset(&stream_) != Z_OK)
        throw std::bad_alloc();
      step(text);
    } while (stream_.avail_in > 0 || (stream_.avail_out == 0 && !at_end_));
  }

  bool
  atEnd() const
  {
    return at_end_;
  }

private:
  void
  step(std::string& text)
  {
    stream_.next_out = unpacked_.data();
    stream_.avail_out = static_cast<uInt>(unpacked_.size());
    const int state = ::inflate(&stream_, Z_NO_FLUSH);
    if (state == Z_MEM_ERROR)
      throw std::bad_alloc();
    if (state != Z_OK && state != Z_STREAM_END && state != Z_BUF_ERROR)
      source_.fail("its compression is damaged");
    at_end_ = state == Z_STREAM_END;
    const std::size_t got = unpacked_.size() - stream_.avail_out;
    if (got > max_unpacked - text.size())
      source_.fail("unpacks to more than 1 GiB");
    text.append(reinterpret_cast<const char*>(unpacked_.data()), got);
  }

  const ByteSource& source_;
  z_stream stream_{};
  std::array<unsigned char, chunk> unpacked_;
  bool at_end_ = false;
};

} // namespace

bool
isGzip(const std::string& path)
{
  ByteSource source(path);
  std::array<unsigned char, 2> magic{};
  if (source.remaining() < magic.size())
    return false;
  source.read(magic.data(), magic.size());
  return magic[0] == 0x1f && magic[1] == 0x8b;
}

std::string
unpackGzip(ByteSource& source)
{
  std::string text;
  Inflater inflater(source);
  std::vector<unsigned char> packed(chunk);
  while (source.remaining() > 0) {
    const auto bytes =
        static_cast<std::size_t>(std::min<std::uint64_t>(chunk, source.remaining()));
    source.read(packed.data(), bytes);
    inflater.append(packed.data(), bytes, text);
  }
  if (!inflater.atEnd())
    source.fail("is truncated: its compression has no end");
  return text;
}

} // namespace pcl::acmap
