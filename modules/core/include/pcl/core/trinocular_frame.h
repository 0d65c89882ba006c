#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/memory.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {

/** \brief Image of one camera: rows from the top, each from the left. \ingroup core */
struct CameraImage {
  std::int32_t width = 0;           ///< pixels; 0 if there is no such camera
  std::int32_t height = 0;          ///< pixels
  std::int32_t channels = 1;        ///< 1: grey; 3: red, green, blue
  std::vector<std::uint8_t> values; ///< channels * width * height

  bool
  empty() const
  {
    return values.empty();
  }
};

inline bool
operator==(const CameraImage& a, const CameraImage& b)
{
  return a.width == b.width && a.height == b.height && a.channels == b.channels &&
         a.values == b.values;
}

/** \brief Returns true if an image is not empty, has 1 or 3 channels, and all its
 * values.
 * \ingroup core */
inline bool
isWhole(const CameraImage& image)
{
  const auto side = [](std::int32_t pixels) {
    return static_cast<std::size_t>(pixels);
  };
  return image.width > 0 && image.height > 0 &&
         (image.channels == 1 || image.channels == 3) &&
         image.values.size() ==
             side(image.width) * side(image.height) * side(image.channels);
}

/** \brief Reads an image as \ref loadRgbImage does; three channels.
 * \throws InputFileException as \ref loadRgbImage \ingroup core */
ACMAP_EXPORT CameraImage
loadCameraImage(const std::string& path);

/** \brief The cameras of a TrinocularRig, in the order of the images of a frame.
 * \ingroup core */
enum class RigCamera { Reference, Horizontal, Vertical };

namespace acmap {

/** \brief The names of \ref RigCamera in files and messages. */
inline constexpr std::array<const char*, 3> rig_camera_names{
    "reference", "horizontal", "vertical"};

} // namespace acmap

/** \brief Returns `reference`, `horizontal` or `vertical`, as used in files and
 * messages.
 * \ingroup core */
inline const char*
nameOf(RigCamera camera)
{
  return acmap::rig_camera_names[static_cast<std::size_t>(camera)];
}

/** \brief Simultaneous images of all cameras of a \ref TrinocularRig (a shot).
 *
 * An observation consists of several shots from one pose: one for each pattern of the
 * projector, and one with the projector off. Geometry is computed from the shots with a
 * pattern, colour is taken from the one without. \ingroup core */
struct TrinocularFrame {
  using Ptr = shared_ptr<TrinocularFrame>;
  using ConstPtr = shared_ptr<const TrinocularFrame>;

  /** \brief Value of \ref pattern for a shot with the projector off. */
  static constexpr std::int32_t no_pattern = -1;

  std::uint64_t number = 0;     ///< of the shot in its session, from 0
  std::int32_t observation = 0; ///< from 0
  std::int32_t pattern = no_pattern;
  std::uint64_t stamp = 0; ///< microseconds, as in PCL's clouds

  /** \brief Indexed by \ref RigCamera; all images that are not empty have the same
   * size. */
  std::array<CameraImage, 3> images;

  CameraImage&
  image(RigCamera camera)
  {
    return images[static_cast<std::size_t>(camera)];
  }

  const CameraImage&
  image(RigCamera camera) const
  {
    return images[static_cast<std::size_t>(camera)];
  }
};

} // namespace pcl
