#include "test_png.h"

#include <png.h>

#include <stdexcept>

namespace pcl::acmap::test {
namespace {

void
append(png_structp png, png_bytep data, std::size_t bytes)
{
  static_cast<std::string*>(png_get_io_ptr(png))
      ->append(reinterpret_cast<const char*>(data), bytes);
}

void
flush(png_structp /*png*/)
{}

void
setPalette(png_structp png, png_infop info)
{
  std::vector<png_color> shades(256);
  for (std::size_t i = 0; i < shades.size(); ++i)
    shades[i].red = static_cast<png_byte>(i);
  png_set_PLTE(png, info, shades.data(), static_cast<int>(shades.size()));
}

void
setTransparentValue(png_structp png, png_infop info, int color_type)
{
  const png_byte alpha = 0;
  png_color_16 value = {};
  const bool has_palette = color_type == PNG_COLOR_TYPE_PALETTE;
  png_set_tRNS(png, info, &alpha, 1, has_palette ? nullptr : &value);
}

} // namespace

std::string
pngBytes(const TestPng& image)
{
  png_structp png =
      png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  std::string bytes;
  png_set_write_fn(png, &bytes, &append, &flush);
  png_set_IHDR(png,
               info,
               image.width,
               image.height,
               image.bits,
               image.color_type,
               image.is_interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  if (image.color_type == PNG_COLOR_TYPE_PALETTE)
    setPalette(png, info);
  if (image.has_transparent_value)
    setTransparentValue(png, info, image.color_type);
  if (image.gamma)
    png_set_gAMA(png, info, *image.gamma);
  png_write_info(png, info);
  const std::size_t row_bytes = png_get_rowbytes(png, info);
  if (image.rows.size() != row_bytes * image.height)
    throw std::logic_error("test image has the wrong number of values");
  std::vector<std::uint8_t> rows = image.rows;
  std::vector<png_bytep> starts;
  for (std::size_t row = 0; row < image.height; ++row)
    starts.push_back(&rows[row * row_bytes]);
  png_write_image(png, starts.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

std::string
depthPngBytes(std::uint32_t width,
              std::uint32_t height,
              const std::vector<std::uint16_t>& values)
{
  TestPng png;
  png.width = width;
  png.height = height;
  png.bits = 16;
  for (const std::uint16_t value : values) {
    png.rows.push_back(static_cast<std::uint8_t>(value >> 8));
    png.rows.push_back(static_cast<std::uint8_t>(value & 0xff));
  }
  return pngBytes(png);
}

} // namespace pcl::acmap::test
