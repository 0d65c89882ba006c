#include "calibrations/rig_pair.h"
#include "files/text_number.h"

#include <pcl/core/impl/size_text.h>
#include <pcl/core/rig_cameras.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

constexpr double typical_disparity = 100.0; // px

[[noreturn]] void
failPair(const std::string& name, const std::string& fault)
{
  throw InputFileException(name + ": " + fault);
}

std::string
namesOfCameras(const std::vector<CalibratedCamera>& cameras)
{
  std::string names;
  for (const CalibratedCamera& camera : cameras)
    names += (names.empty() ? "" : ", ") + inPrint(camera.name, 40);
  return names;
}

const CalibratedCamera&
cameraOfName(const std::string& file,
             const std::vector<CalibratedCamera>& cameras,
             const std::string& name)
{
  const auto found =
      std::find_if(cameras.begin(), cameras.end(), [&](const CalibratedCamera& camera) {
        return camera.name == name;
      });
  if (found == cameras.end())
    failPair(file,
             "has no camera " + inQuotes(name) + " for --rig-cameras, but " +
                 namesOfCameras(cameras));
  return *found;
}

/** \brief A file of one camera: it may know its place beside a left one, whose view is
 * the same. */
std::vector<CalibratedCamera>
pairOfOne(const std::string& file,
          const CalibratedCamera& camera,
          const RigImages& images)
{
  CalibratedCamera reference = camera;
  if (const auto& view = camera.rectified;
      view && view->has_pose &&
      !view->camera.T_reference_camera.translation().isZero()) {
    reference.name = "the left camera beside it";
    reference.built.reset();
    reference.rectified->camera.T_reference_camera.setIdentity();
    return {reference, camera};
  }
  if (!images.baseline)
    failPair(
        file,
        "has one camera and no baseline: --baseline states it, metres to the right, or "
        "--rig LEFT RIGHT names the files of both cameras");
  CalibratedCamera neighbour = camera;
  if (neighbour.built)
    neighbour.built->has_pose = false;
  if (neighbour.rectified)
    neighbour.rectified->has_pose = false;
  neighbour.name = "one of the same kind";
  return {neighbour, neighbour};
}

std::vector<CalibratedCamera>
chosenPair(const std::string& file,
           const std::vector<CalibratedCamera>& cameras,
           bool is_kitti,
           const RigImages& images)
{
  if (images.cameras.size() == 2)
    return {cameraOfName(file, cameras, images.cameras[0]),
            cameraOfName(file, cameras, images.cameras[1])};
  if (cameras.size() == 1)
    return pairOfOne(file, cameras.front(), images);
  if (cameras.size() == 2)
    return cameras;
  if (!is_kitti)
    failPair(file,
             "has the cameras " + namesOfCameras(cameras) +
                 ": --rig-cameras names reference and neighbour, for example "
                 "--rig-cameras " +
                 cameras[0].name + "," + cameras[1].name);
  return {cameraOfName(file, cameras, images.are_grey ? "P0" : "P2"),
          cameraOfName(file, cameras, images.are_grey ? "P1" : "P3")};
}

/** \brief The pose of the neighbour, with the baseline of the user where there is one. */
std::optional<Eigen::Isometry3d>
poseBetween(const CalibratedView& reference,
            const CalibratedView& neighbour,
            const std::optional<double>& baseline)
{
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  if (!reference.has_pose || !neighbour.has_pose) {
    if (!baseline)
      return std::nullopt;
    pose.translation().x() = *baseline;
    return pose;
  }
  if (!reference.camera.T_reference_camera.matrix().isIdentity(0.0))
    pose = reference.camera.T_reference_camera.inverse();
  pose = pose * neighbour.camera.T_reference_camera;
  Eigen::Index along = 0;
  const double length = pose.translation().head<2>().cwiseAbs().maxCoeff(&along);
  if (!(length > 0.0))
    return std::nullopt;
  if (baseline)
    pose.translation() *= *baseline / pose.translation()[along];
  return pose;
}

std::optional<RigCalibration>
rigOfViews(const std::string& file,
           const std::optional<CalibratedView>& reference,
           const std::optional<CalibratedView>& neighbour,
           const RigImages& images)
{
  if (!reference || !neighbour)
    return std::nullopt;
  const auto pose = poseBetween(*reference, *neighbour, images.baseline);
  if (!pose)
    return std::nullopt;
  if (neighbour->width != reference->width || neighbour->height != reference->height)
    failPair(file,
             "the two cameras have images of " +
                 sizeText(reference->width, reference->height) + " and " +
                 sizeText(neighbour->width, neighbour->height) +
                 " pixels, a pair needs one size");
  const bool is_horizontal =
      std::abs(pose->translation().x()) >= std::abs(pose->translation().y());
  RigCalibration cameras;
  cameras.width = reference->width;
  cameras.height = reference->height;
  cameras.cameras[0] = reference->camera;
  cameras.cameras[0].T_reference_camera.setIdentity();
  CameraCalibration& other =
      cameras.camera(is_horizontal ? RigCamera::Horizontal : RigCamera::Vertical);
  other = neighbour->camera;
  other.T_reference_camera = *pose;
  return cameras;
}

const CameraCalibration&
neighbourIn(const RigCalibration& cameras)
{
  return cameras.camera(cameras.camera(RigCamera::Horizontal).is_there
                            ? RigCamera::Horizontal
                            : RigCamera::Vertical);
}

bool
hasDistortion(const CameraCalibration& camera)
{
  return camera.distortion != std::array<double, 5>{};
}

/** \brief Largest distance, px, that another focal length moves a pixel. */
double
spreadOf(double one, double other, int side)
{
  return std::abs(one / other - 1.0) * 0.5 * side;
}

} // namespace

CameraPair
pairOf(const std::vector<std::string>& names,
       const std::vector<Calibration>& calibrations,
       const RigImages& images)
{
  std::vector<CalibratedCamera> cameras;
  for (std::size_t i = 0; i < calibrations.size(); ++i) {
    const std::vector<CalibratedCamera>& found = calibrations[i].cameras;
    if (calibrations.size() == 2 && found.size() != 1)
      failPair(
          names[i],
          "has a rig or several cameras, so that no second file beside it is needed");
    cameras.insert(cameras.end(), found.begin(), found.end());
  }
  const bool is_kitti = calibrations.front().kind.rfind("KITTI", 0) == 0;
  const std::vector<CalibratedCamera> two =
      chosenPair(names.front(), cameras, is_kitti, images);
  CameraPair pair;
  pair.names = {inPrint(two[0].name, 40), inPrint(two[1].name, 40)};
  pair.built = rigOfViews(names.front(), two[0].built, two[1].built, images);
  pair.rectified =
      rigOfViews(names.front(), two[0].rectified, two[1].rectified, images);
  if (!pair.built && !pair.rectified)
    failPair(
        names.front(),
        "does not say where the second camera stands; --baseline states it, metres to "
        "the right");
  return pair;
}

double
rowResidual(const RigCalibration& cameras)
{
  const CameraCalibration& reference = cameras.cameras[0];
  const CameraCalibration& neighbour = neighbourIn(cameras);
  const Eigen::Isometry3d& pose = neighbour.T_reference_camera;
  const bool is_horizontal = cameras.camera(RigCamera::Horizontal).is_there;
  const Eigen::Index along = is_horizontal ? 0 : 1;
  Eigen::Vector3d aside = pose.translation() / pose.translation()[along];
  aside[along] = 0.0;
  const double turn = Eigen::AngleAxisd(pose.linear()).angle();
  const double center = is_horizontal ? reference.center_y - neighbour.center_y
                                      : reference.center_x - neighbour.center_x;
  const int side = std::max({cameras.width, cameras.height, 1});
  return turn * reference.focal_x + std::abs(center) +
         spreadOf(reference.focal_x, neighbour.focal_x, side) +
         spreadOf(reference.focal_y, neighbour.focal_y, side) +
         typical_disparity * aside.norm();
}

std::optional<TrinocularRig>
plainRig(const RigCalibration& cameras, bool is_stated)
{
  const double largest = is_stated ? 1.0 : 0.25; // px
  const CameraCalibration& reference = cameras.cameras[0];
  const CameraCalibration& neighbour = neighbourIn(cameras);
  const bool is_horizontal = cameras.camera(RigCamera::Horizontal).is_there;
  const int side = std::max({cameras.width, cameras.height, 1});
  if (hasDistortion(reference) || hasDistortion(neighbour) ||
      !(rowResidual(cameras) <= largest) ||
      spreadOf(reference.focal_x, reference.focal_y, side) > largest)
    return std::nullopt;
  TrinocularRig rig;
  rig.width = cameras.width;
  rig.height = cameras.height;
  rig.focal_length = is_horizontal ? reference.focal_x : reference.focal_y;
  rig.center_x = reference.center_x;
  rig.center_y = reference.center_y;
  const Eigen::Vector3d place = neighbour.T_reference_camera.translation();
  rig.baseline_horizontal = is_horizontal ? place.x() : 0.0;
  rig.baseline_vertical = is_horizontal ? 0.0 : place.y();
  constexpr double printed_digits = 1e-3; // px
  if (is_horizontal &&
      std::abs(neighbour.center_x - reference.center_x) > printed_digits)
    rig.center_x_horizontal = neighbour.center_x;
  if (!is_horizontal && std::abs(neighbour.center_y - reference.center_y) > largest)
    return std::nullopt;
  return rig;
}

bool
areAlike(const RigCalibration& built, const RigCalibration& rectified)
{
  constexpr double largest = 0.25; // px
  const std::optional<TrinocularRig> one = plainRig(built, false);
  const std::optional<TrinocularRig> other = plainRig(rectified, true);
  if (!one || !other)
    return false;
  const auto centerOf = [](const TrinocularRig& rig) {
    return rig.center_x_horizontal.value_or(rig.center_x);
  };
  const int side = std::max({built.width, built.height, 1});
  return spreadOf(one->focal_length, other->focal_length, side) <= largest &&
         std::abs(one->center_x - other->center_x) <= largest &&
         std::abs(one->center_y - other->center_y) <= largest &&
         std::abs(centerOf(*one) - centerOf(*other)) <= largest;
}

std::optional<double>
scaleBetween(int width, int height, int new_width, int new_height)
{
  const double scale = static_cast<double>(new_width) / width;
  if (std::abs(scale * height - new_height) > 1.0)
    return std::nullopt;
  return scale;
}

double
scaledCenter(double center, double scale)
{
  return (center + 0.5) * scale - 0.5;
}

bool
fitToImages(const std::string& name, const RigImages& images, RigCalibration& cameras)
{
  const bool is_known = cameras.width > 0;
  if (images.width == 0 && !is_known)
    failPair(
        name,
        "does not state the size of the images, which a camera needs: write it with "
        "the calibration into a rig.yaml, or into a file that has width and height");
  if (images.width == 0 ||
      (cameras.width == images.width && cameras.height == images.height))
    return false;
  const std::string size = sizeText(images.width, images.height) + " pixels";
  if (!is_known) {
    const CameraCalibration& reference = cameras.cameras[0];
    if (std::abs(2.0 * reference.center_x - images.width) > 0.5 * images.width ||
        std::abs(2.0 * reference.center_y - images.height) > 0.5 * images.height)
      failPair(name,
               "the principal point " + shortNumber(reference.center_x) + ", " +
                   shortNumber(reference.center_y) +
                   " is not near the middle of images of " + size +
                   ": it is for images of another size, which the file does not "
                   "state; a rig.yaml has width and height");
    cameras.width = images.width;
    cameras.height = images.height;
    return false;
  }
  const auto scale =
      scaleBetween(cameras.width, cameras.height, images.width, images.height);
  if (!scale)
    failPair(name,
             "is for images of " + sizeText(cameras.width, cameras.height) +
                 " pixels, the images have " + size +
                 " and so another shape; a calibration of these images is needed");
  cameras.width = images.width;
  cameras.height = images.height;
  for (CameraCalibration& camera : cameras.cameras) {
    camera.focal_x *= *scale;
    camera.focal_y *= *scale;
    camera.center_x = scaledCenter(camera.center_x, *scale);
    camera.center_y = scaledCenter(camera.center_y, *scale);
  }
  return true;
}

} // namespace pcl::acmap
