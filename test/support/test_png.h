#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief A PNG written by libpng, of formats that the library itself does not
 * write. */
struct TestPng {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  int bits = 8;       ///< per channel
  int color_type = 0; ///< libpng's PNG_COLOR_TYPE_*; 0 is grey
  bool is_interlaced = false;
  std::optional<double> gamma;

  /** \brief Rows as stored in the file, 16 bit numbers in big-endian order. */
  std::vector<std::uint8_t> rows;

  bool has_transparent_value = false; ///< the value 0 is transparent
};

/** \brief Encodes the file. If a palette is needed, it contains shades of red. */
std::string
pngBytes(const TestPng& png);

/** \brief A grey PNG of 16 bits. \param[in] values in row-major order */
std::string
depthPngBytes(std::uint32_t width,
              std::uint32_t height,
              const std::vector<std::uint16_t>& values);

} // namespace pcl::acmap::test
