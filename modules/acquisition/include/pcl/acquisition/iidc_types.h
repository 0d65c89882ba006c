#pragma once

#include <pcl/core/export.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief Who a camera is, from its configuration ROM. \ingroup acquisition */
struct IidcIdentity {
  std::string maker;
  std::string model;
  std::uint64_t guid = 0; ///< the serial number, unique in the world
  std::string version;    ///< of IIDC, say `1.31`; `Point Grey` where it names its own

  /** \brief The guid as 16 hexadecimal digits. */
  ACMAP_EXPORT std::string
  serial() const;
};

/** \brief How a pixel is coded; the numbers are those of the register.
 * \ingroup acquisition */
enum class IidcColor : std::uint8_t {
  Mono8,
  Yuv411,
  Yuv422,
  Yuv444,
  Rgb8,   ///< of a Digiclops: a byte of each of three cameras
  Mono16, ///< of two cameras: a byte of each
  Rgb16,
  SignedMono16,
  SignedRgb16,
  Raw8,
  Raw16 ///< of two cameras: a byte of each
};

/** \brief Say `RGB8`. \ingroup acquisition */
ACMAP_EXPORT const char*
nameOf(IidcColor color);

/** \brief A way in which a camera can send images. \ingroup acquisition */
struct IidcMode {
  int format = 0; ///< 0 to 2: of fixed sizes; 7: scalable
  int mode = 0;   ///< within the format, 0 to 7
  int width = 0;  ///< px; of format 7 the most, from the left edge on
  int height = 0; ///< px; likewise, from the top on
  IidcColor color = IidcColor::Mono8;

  /** \brief Frames a second to choose from, ascending; empty where any is possible up to a
   * limit (format 7). */
  std::vector<float> rates;

  /** \brief How many cameras' images it interleaves: 3, 2 or 1; 0 for what no rig uses. */
  ACMAP_EXPORT int
  cameras() const;

  /** \brief Of one frame. */
  ACMAP_EXPORT std::size_t
  bytes() const;

  /** \brief `7:0 640x480 RGB8`. */
  ACMAP_EXPORT std::string
  text() const;
};

/** \brief What can be set; the numbers are those of the registers.
 * \ingroup acquisition */
enum class IidcFeature : std::uint8_t {
  Brightness = 0,
  Exposure = 1,
  Sharpness = 2,
  WhiteBalance = 3,
  Saturation = 5,
  Gamma = 6,
  Shutter = 7,    ///< seconds as a physical value
  Gain = 8,       ///< dB as a physical value
  FrameRate = 15, ///< Hz as a physical value; IidcCamera::setMode sets it
  Pan = 33        ///< which camera, where one alone is sent
};

/** \brief Say `shutter`. \ingroup acquisition */
ACMAP_EXPORT const char*
nameOf(IidcFeature feature);

/** \brief What a camera can do with a feature, and what it does. \ingroup acquisition */
struct IidcFeatureState {
  bool is_there = false;
  bool can_be_automatic = false;
  bool can_be_set = false;
  bool can_be_off = false;
  bool is_on = false;
  bool is_automatic = false;
  unsigned least = 0; ///< of the value
  unsigned most = 0;
  unsigned value = 0; ///< in steps of the camera's own

  /** \brief In physical units, where the camera knows them. */
  struct Physical {
    float least = 0;
    float most = 0;
    float value = 0;
  };
  std::optional<Physical> physical;
};

/** \brief What makes a camera take an image. \ingroup acquisition */
enum class IidcTrigger {
  Off,     ///< one after another, by itself
  External ///< a falling edge at its trigger input (mode 0 of IIDC)
};

} // namespace pcl
