#include <pcl/acquisition/rig_of_images.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/image_file.h>

#include <utility>

namespace pcl {

namespace {

/** Has an image the same value in all channels of each pixel? */
bool
isGrey(const CameraImage& image)
{
  const auto channels = static_cast<std::size_t>(image.channels);
  for (std::size_t i = 0; i < image.values.size(); ++i)
    if (image.values[i] != image.values[i - i % channels])
      return false;
  return true;
}

/** Adds what the first image of each list tells. */
void
lookAt(const TrinocularImageLists& lists, RigImages& images)
{
  const CameraImage first = loadCameraImage(lists.reference.front());
  const auto is_of_one_size = [&](const std::vector<std::string>& list) {
    if (list.empty())
      return true;
    const CameraImage other = loadCameraImage(list.front());
    return other.width == first.width && other.height == first.height;
  };
  // where sizes differ, the reader of the frames names the image
  if (is_of_one_size(lists.horizontal) && is_of_one_size(lists.vertical)) {
    images.width = first.width;
    images.height = first.height;
  }
  images.has_horizontal = !lists.horizontal.empty();
  images.has_vertical = !lists.vertical.empty();
  images.are_grey = isGrey(first);
}

} // namespace

CalibratedRig
loadRigOfImages(const std::vector<std::string>& paths,
                const TrinocularImageLists& images,
                RigImages stated)
{
  if (images.reference.empty() || paths.empty())
    throw acmap::BadArgument("images of the reference and a calibration are needed");
  lookAt(images, stated);
  CalibratedRig found = loadRig(paths, stated);
  const auto require = [&](RigCamera camera, bool is_listed, double& place) {
    const std::string name = nameOf(camera);
    if (!is_listed)
      place = 0.0;
    else if (place == 0.0)
      throw acmap::BadArgument("--" + name + ": " + paths.front() + " has no " + name +
                               " camera");
  };
  require(RigCamera::Horizontal, stated.has_horizontal, found.rig.baseline_horizontal);
  require(RigCamera::Vertical, stated.has_vertical, found.rig.baseline_vertical);
  return found;
}

} // namespace pcl
