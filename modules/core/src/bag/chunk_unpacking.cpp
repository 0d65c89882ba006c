#include "bag/chunk_unpacking.h"

#include <bzlib.h>
#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <memory>

namespace pcl::acmap {

namespace {

constexpr std::size_t unpacking_step = 65536; // bytes

/** \brief A decoder with the calls of lz4 and zstd in one form: takes packed bytes, and adds
 * unpacked ones to the output until it returns true. */
class Lz4Decoder {
public:
  explicit Lz4Decoder(const UnpackingFault& fail)
  : fail_(fail)
  {
    LZ4F_dctx* context = nullptr;
    if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION)))
      throw std::bad_alloc();
    context_.reset(context);
  }

  bool
  next(std::string_view& packed, char* to, std::size_t& count)
  {
    std::size_t used = packed.size();
    const std::size_t hint =
        LZ4F_decompress(context_.get(), to, &count, packed.data(), &used, nullptr);
    if (LZ4F_isError(hint))
      fail_(std::string("lz4: ") + LZ4F_getErrorName(hint));
    packed.remove_prefix(used);
    return hint == 0 && packed.empty();
  }

private:
  struct Free {
    void
    operator()(LZ4F_dctx* context) const
    {
      LZ4F_freeDecompressionContext(context);
    }
  };
  const UnpackingFault& fail_;
  std::unique_ptr<LZ4F_dctx, Free> context_;
};

class ZstdDecoder {
public:
  explicit ZstdDecoder(const UnpackingFault& fail)
  : fail_(fail)
  , stream_(ZSTD_createDStream())
  {
    if (!stream_)
      throw std::bad_alloc();
    constexpr int window =
        27; // 2^27 bytes, the most that zstd itself allows by default
    ZSTD_DCtx_setParameter(stream_.get(), ZSTD_d_windowLogMax, window);
  }

  bool
  next(std::string_view& packed, char* to, std::size_t& count)
  {
    ZSTD_inBuffer in{packed.data(), packed.size(), 0};
    ZSTD_outBuffer out{to, count, 0};
    const std::size_t hint = ZSTD_decompressStream(stream_.get(), &out, &in);
    if (ZSTD_isError(hint))
      fail_(std::string("zstd: ") + ZSTD_getErrorName(hint));
    packed.remove_prefix(in.pos);
    count = out.pos;
    return hint == 0 && packed.empty();
  }

private:
  struct Free {
    void
    operator()(ZSTD_DStream* stream) const
    {
      ZSTD_freeDStream(stream);
    }
  };
  const UnpackingFault& fail_;
  std::unique_ptr<ZSTD_DStream, Free> stream_;
};

class Bz2Decoder {
public:
  explicit Bz2Decoder(const UnpackingFault& fail)
  : fail_(fail)
  , stream_(new bz_stream{})
  {
    constexpr int quiet = 0, uses_more_memory = 0;
    if (BZ2_bzDecompressInit(stream_.get(), quiet, uses_more_memory) != BZ_OK)
      throw std::bad_alloc();
  }

  bool
  next(std::string_view& packed, char* to, std::size_t& count)
  {
    // its counts have 32 bits
    const std::size_t offered = std::min(packed.size(), unpacking_step);
    stream_->next_in = const_cast<char*>(packed.data());
    stream_->avail_in = static_cast<unsigned>(offered);
    stream_->next_out = to;
    stream_->avail_out = static_cast<unsigned>(count);
    const int state = BZ2_bzDecompress(stream_.get());
    if (state == BZ_MEM_ERROR)
      throw std::bad_alloc();
    if (state != BZ_OK && state != BZ_STREAM_END)
      fail_("bz2: is damaged");
    packed.remove_prefix(offered - stream_->avail_in);
    count -= stream_->avail_out;
    return state == BZ_STREAM_END && packed.empty();
  }

private:
  struct Free {
    void
    operator()(bz_stream* stream) const
    {
      BZ2_bzDecompressEnd(stream);
      delete stream;
    }
  };
  const UnpackingFault& fail_;
  std::unique_ptr<bz_stream, Free> stream_;
};

template <typename Decoder>
std::string
unpackWith(Decoder decoder,
           std::string_view packed,
           std::uint64_t bytes,
           const UnpackingFault& fail)
{
  std::string unpacked;
  while (true) {
    const std::size_t before = unpacked.size();
    // one more than expected, so that surplus bytes are noticed
    std::size_t count =
        std::min<std::uint64_t>(unpacking_step, bytes - before + std::uint64_t{1});
    unpacked.resize(before + count);
    const std::size_t left = packed.size();
    const bool is_finished = decoder.next(packed, &unpacked[before], count);
    unpacked.resize(before + count);
    if (unpacked.size() > bytes)
      fail("has more bytes than the " + std::to_string(bytes) + " that it claims");
    if (is_finished)
      break;
    if (count == 0 && packed.size() == left)
      fail("is truncated within its packed bytes");
  }
  if (unpacked.size() != bytes)
    fail("has " + std::to_string(unpacked.size()) + " bytes, and claims " +
         std::to_string(bytes));
  return unpacked;
}

} // namespace

std::string
unpackChunk(std::string_view packing,
            std::string_view packed,
            std::uint64_t bytes,
            const UnpackingFault& fail)
{
  if (packing == "lz4")
    return unpackWith(Lz4Decoder(fail), packed, bytes, fail);
  if (packing == "zstd")
    return unpackWith(ZstdDecoder(fail), packed, bytes, fail);
  if (packing == "bz2")
    return unpackWith(Bz2Decoder(fail), packed, bytes, fail);
  if (!packing.empty())
    fail("is packed with '" + std::string(packing.substr(0, 20)) +
         "', lz4, zstd and bz2 are known");
  if (packed.size() != bytes)
    fail("has " + std::to_string(packed.size()) + " bytes, and claims " +
         std::to_string(bytes));
  return std::string(packed);
}

} // namespace pcl::acmap
