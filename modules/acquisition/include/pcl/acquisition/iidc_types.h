#pragma once

#include <pcl/core/export.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief Identity of a camera, from its configuration ROM. \ingroup acquisition */
struct IidcIdentity {
  std::string maker;
  std::string model;
  std::uint64_t guid = 0; ///< serial number, globally unique
  std::string version;    ///< of IIDC, for example `1.31`; `Point Grey` for its own one

  /** \brief The guid as 16 hexadecimal digits. */
  ACMAP_EXPORT std::string
  serial() const;
};

/** \brief Coding of a pixel; the numbers are those of the register.
 * \ingroup acquisition */
enum class IidcColor : std::uint8_t {
  Mono8,
  Yuv411,
  Yuv422,
  Yuv444,
  Rgb8,   ///< Digiclops: one byte of each of the three cameras
  Mono16, ///< two cameras: one byte of each
  Rgb16,
  SignedMono16,
  SignedRgb16,
  Raw8,
  Raw16 ///< two cameras: one byte of each
};

/** \brief Returns the name, for example `RGB8`. \ingroup acquisition */
ACMAP_EXPORT const char*
nameOf(IidcColor color);

/** \brief An image mode of a camera. \ingroup acquisition */
struct IidcMode {
  int format = 0; ///< 0 to 2: fixed sizes; 7: scalable
  int mode = 0;   ///< within the format, 0 to 7
  int width = 0;  ///< px; in format 7 the maximum, from the left edge
  int height = 0; ///< px; in format 7 the maximum, from the top edge
  IidcColor color = IidcColor::Mono8;

  /** \brief Available frames per second, ascending; empty if any rate up to a limit is
   * possible (format 7). */
  std::vector<float> rates;

  /** \brief Number of cameras whose images are interleaved: 3, 2 or 1; 0 for pixel
   * codings that no rig uses. */
  ACMAP_EXPORT int
  cameras() const;

  /** \brief Number of bytes of one frame. */
  ACMAP_EXPORT std::size_t
  bytes() const;

  /** \brief The mode as text, for example `7:0 640x480 RGB8`. */
  ACMAP_EXPORT std::string
  text() const;
};

/** \brief Features of a camera; the numbers are those of the registers.
 * \ingroup acquisition */
enum class IidcFeature : std::uint8_t {
  Brightness = 0,
  Exposure = 1,
  Sharpness = 2,
  WhiteBalance = 3,
  Saturation = 5,
  Gamma = 6,
  Shutter = 7,    ///< physical value in seconds
  Gain = 8,       ///< physical value in dB
  FrameRate = 15, ///< physical value in Hz; set by IidcCamera::setMode
  Pan = 33        ///< selects the camera if only one is transmitted
};

/** \brief Returns the name, for example `shutter`. \ingroup acquisition */
ACMAP_EXPORT const char*
nameOf(IidcFeature feature);

/** \brief Capabilities and current state of a feature. \ingroup acquisition */
struct IidcFeatureState {
  bool is_there = false;
  bool can_be_automatic = false;
  bool can_be_set = false;
  bool can_be_off = false;
  bool is_on = false;
  bool is_automatic = false;
  unsigned minimum = 0; ///< minimum of the value
  unsigned maximum = 0; ///< maximum of the value
  unsigned value = 0;   ///< current value, in the camera's own units

  /** \brief The same in physical units; empty if the camera does not know them. */
  struct Physical {
    float minimum = 0;
    float maximum = 0;
    float value = 0;
  };
  std::optional<Physical> physical;
};

/** \brief Trigger of the exposure. \ingroup acquisition */
enum class IidcTrigger {
  Off,     ///< the camera runs freely
  External ///< a falling edge at its trigger input (mode 0 of IIDC)
};

} // namespace pcl
