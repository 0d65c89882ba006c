#include "images/image_codecs.h"

#include <pcl/core/exceptions.h>

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>

namespace pcl::acmap {

namespace {

constexpr std::size_t signature_bytes = 8;
constexpr double max_deflated = 1040.0; // maximum compression ratio of deflate
constexpr png_uint_32 no_limit = 0x7fffffff;

/** \brief A PNG that libpng reads from memory. libpng reports faults by longjmp, so the
 * functions that call it must not have objects with a destructor. */
struct PngReading {
  explicit PngReading(const ImageBytes& bytes)
  : next(bytes.data())
  , left(bytes.size())
  {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &fail, &ignore);
    info = png ? png_create_info_struct(png) : nullptr;
    if (!info) {
      png_destroy_read_struct(&png, nullptr, nullptr);
      throw std::bad_alloc();
    }
  }

  ~PngReading()
  {
    png_destroy_read_struct(&png, &info, nullptr);
  }

  PngReading(const PngReading&) = delete;
  PngReading&
  operator=(const PngReading&) = delete;

  [[noreturn]] static void
  fail(png_structp png, png_const_charp message)
  {
    auto* const self = static_cast<PngReading*>(png_get_error_ptr(png));
    std::strncpy(self->fault, message, sizeof(self->fault) - 1);
    png_longjmp(png, 1);
  }

  static void
  ignore(png_structp /*png*/, png_const_charp /*message*/)
  {}

  static void
  give(png_structp png, png_bytep to, std::size_t bytes)
  {
    auto* const self = static_cast<PngReading*>(png_get_io_ptr(png));
    if (bytes > self->left)
      png_error(png, "is truncated");
    std::memcpy(to, self->next, bytes);
    self->next += bytes;
    self->left -= bytes;
  }

  png_structp png = nullptr;
  png_infop info = nullptr;
  const std::uint8_t* next;
  std::size_t left;
  char fault[128] = {};
};

/** \brief Reads up to the first bytes of the image data.
 * \return false in case of a fault */
bool
readHeader(PngReading& reading)
{
  if (setjmp(png_jmpbuf(reading.png))) // NOLINT(cert-err52-cpp)
    return false;
  png_set_read_fn(reading.png, &reading, &PngReading::give);
  // the number of pixels is limited by requireImageSize
  png_set_user_limits(reading.png, no_limit, no_limit);
  // skip profiles, texts and gamma, which do not change the stored values
  png_set_keep_unknown_chunks(reading.png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
  png_set_benign_errors(reading.png, 0);
  // libpng 1.6.48 only warns of a damaged end
  png_set_crc_action(reading.png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
  png_read_info(reading.png, reading.info);
  return true;
}

/** \brief Requests 8-bit RGB from libpng. */
void
askForColors(png_structp png)
{
  png_set_expand(png);
  png_set_scale_16(png);
  png_set_strip_alpha(png);
  png_set_gray_to_rgb(png);
}

void
askForHostOrder(png_structp png)
{
  const std::uint16_t one = 1;
  if (*reinterpret_cast<const std::uint8_t*>(&one) == 1)
    png_set_swap(png);
}

/** \brief Requests the format of the rows from libpng.
 * \return false in case of a fault */
bool
prepareRows(PngReading& reading, void (*ask)(png_structp))
{
  if (setjmp(png_jmpbuf(reading.png))) // NOLINT(cert-err52-cpp)
    return false;
  ask(reading.png);
  png_set_interlace_handling(reading.png);
  png_read_update_info(reading.png, reading.info);
  return true;
}

/** \return false in case of a fault */
bool
readRows(PngReading& reading, png_bytepp rows)
{
  if (setjmp(png_jmpbuf(reading.png))) // NOLINT(cert-err52-cpp)
    return false;
  png_read_image(reading.png, rows);
  png_read_end(reading.png, nullptr);
  return true;
}

void
require(bool is_good, const PngReading& reading)
{
  if (!is_good)
    throw DamagedImage(std::string("PNG: ") + reading.fault);
}

/** \brief Checks the header before memory is allocated for the image. */
void
openPng(PngReading& reading, std::size_t bytes)
{
  require(readHeader(reading), reading);
  const double bits = png_get_bit_depth(reading.png, reading.info) *
                      png_get_channels(reading.png, reading.info);
  requireImageSize(png_get_image_width(reading.png, reading.info),
                   png_get_image_height(reading.png, reading.info),
                   8.0 / bits * max_deflated,
                   bytes);
}

/** \brief Reads all rows into an array in row-major order. */
template <typename Image>
void
fillRows(PngReading& reading, void (*ask)(png_structp), Image& image)
{
  require(prepareRows(reading, ask), reading);
  const std::size_t row_bytes = png_get_rowbytes(reading.png, reading.info);
  const std::size_t rows = png_get_image_height(reading.png, reading.info);
  image.width =
      static_cast<std::int32_t>(png_get_image_width(reading.png, reading.info));
  image.height = static_cast<std::int32_t>(rows);
  image.values.resize(rows * row_bytes / sizeof(image.values[0]));
  std::vector<png_bytep> starts(rows);
  for (std::size_t row = 0; row < rows; ++row)
    starts[row] = reinterpret_cast<png_bytep>(image.values.data()) + row * row_bytes;
  require(readRows(reading, starts.data()), reading);
}

} // namespace

bool
isPng(const ImageBytes& bytes)
{
  return bytes.size() >= signature_bytes &&
         png_sig_cmp(bytes.data(), 0, signature_bytes) == 0;
}

RgbImage
decodePng(const ImageBytes& bytes)
{
  PngReading reading(bytes);
  openPng(reading, bytes.size());
  RgbImage image;
  fillRows(reading, &askForColors, image);
  return image;
}

GrayImage16
decodeGrayPng(const ImageBytes& bytes)
{
  PngReading reading(bytes);
  openPng(reading, bytes.size());
  const int bits = png_get_bit_depth(reading.png, reading.info);
  if (png_get_color_type(reading.png, reading.info) != PNG_COLOR_TYPE_GRAY ||
      (bits != 8 && bits != 16))
    throw DamagedImage("PNG: one channel of 8 or 16 bits is needed");
  GrayImage16 image;
  if (bits == 16) {
    fillRows(reading, &askForHostOrder, image);
    return image;
  }
  struct {
    std::int32_t width, height;
    std::vector<std::uint8_t> values;
  } narrow;
  fillRows(
      reading, [](png_structp) {}, narrow);
  image.width = narrow.width;
  image.height = narrow.height;
  image.values.assign(narrow.values.begin(), narrow.values.end());
  return image;
}

} // namespace pcl::acmap

namespace pcl {

namespace {

std::vector<std::uint8_t>
encodeRows(std::int32_t width,
           std::int32_t height,
           png_uint_32 format,
           const std::uint8_t* values)
{
  png_image header = {};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(width);
  header.height = static_cast<png_uint_32>(height);
  header.format = format;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::vector<std::uint8_t> bytes(size);
  if (!png_image_write_to_memory(&header, bytes.data(), &size, 0, values, 0, nullptr))
    throw acmap::BadArgument(std::string("image cannot be a PNG: ") + header.message);
  bytes.resize(size);
  return bytes;
}

} // namespace

std::vector<std::uint8_t>
encodePng(const RgbImage& image)
{
  acmap::requireWholeImage(image);
  return encodeRows(image.width, image.height, PNG_FORMAT_RGB, image.values.data());
}

std::vector<std::uint8_t>
encodePng(std::int32_t width,
          std::int32_t height,
          const std::vector<std::uint8_t>& values)
{
  acmap::requireImageValues(width, height, 1, values.size());
  return encodeRows(width, height, PNG_FORMAT_GRAY, values.data());
}

} // namespace pcl
