#include <pcl/core/rig_calibration.h>

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <type_traits>

namespace {

/** \brief Bytes as a file that is in memory only. */
class MemoryFile {
public:
  MemoryFile(const std::uint8_t* data, std::size_t size)
  : file_(::memfd_create("rig", MFD_CLOEXEC))
  {
    if (file_ < 0 || ::write(file_, data, size) != static_cast<ssize_t>(size))
      throw std::runtime_error("no file in memory");
  }

  ~MemoryFile()
  {
    ::close(file_);
  }

  MemoryFile(const MemoryFile&) = delete;
  MemoryFile&
  operator=(const MemoryFile&) = delete;

  std::string
  path() const
  {
    return "/proc/self/fd/" + std::to_string(file_);
  }

private:
  int file_;
};

void
require(bool holds)
{
  if (!holds)
    std::abort();
}

/** \brief Where what was read is written, to be read again. */
const std::string&
otherPath()
{
  static const std::string path = (std::filesystem::temp_directory_path() /
                                   ("fuzz_rig_" + std::to_string(::getpid()) + ".yaml"))
                                      .string();
  return path;
}

void
requireEqual(const pcl::TrinocularRig& a, const pcl::TrinocularRig& b)
{
  require(a.width == b.width && a.height == b.height &&
          a.focal_length == b.focal_length && a.center_x == b.center_x &&
          a.center_y == b.center_y && a.baseline_horizontal == b.baseline_horizontal &&
          a.baseline_vertical == b.baseline_vertical &&
          a.disparity_sigma == b.disparity_sigma);
}

void
requireEqual(const pcl::CameraCalibration& a, const pcl::CameraCalibration& b)
{
  require(a.is_there == b.is_there && a.focal_x == b.focal_x &&
          a.focal_y == b.focal_y && a.center_x == b.center_x &&
          a.center_y == b.center_y && a.distortion == b.distortion &&
          a.T_reference_camera.matrix() == b.T_reference_camera.matrix());
}

/** A ray that can be found is a unit one, and is seen where it was looked for. */
void
look(const pcl::CameraCalibration& camera)
{
  const Eigen::Vector2d pixel(10, 20);
  const Eigen::Vector3d ray = pcl::pixelRay(camera, pixel);
  if (ray.hasNaN())
    return;
  require(std::abs(ray.norm() - 1.0) < 1e-9);
  const double longest = std::max(camera.focal_x, camera.focal_y);
  const double far = (pixel - Eigen::Vector2d(camera.center_x, camera.center_y)).norm();
  require((pcl::projectPoint(camera, ray) - pixel).norm() <= 1e-6 * (longest + far));
}

/** \brief Reads from a file, or finds it refused. */
template <typename Load>
auto
readFuzzed(const Load& load, const std::string& path)
{
  using Read = std::invoke_result_t<Load, const std::string&>;
  try {
    return std::optional<Read>(load(path));
  }
  catch (const pcl::InputFileException&) {
    return std::optional<Read>();
  }
}

void
checkRig(const pcl::TrinocularRig& rig)
{
  pcl::saveTrinocularRig(otherPath(), rig);
  requireEqual(pcl::loadTrinocularRig(otherPath()), rig);
}

void
checkCameras(const pcl::RigCalibration& cameras)
{
  pcl::requireSoundCalibration(cameras);
  for (const pcl::CameraCalibration& camera : cameras.cameras)
    if (camera.is_there)
      look(camera);
  pcl::TrinocularRig rig;
  rig.width = cameras.width;
  rig.height = cameras.height;
  if (!cameras.camera(pcl::RigCamera::Horizontal).is_there)
    rig.baseline_horizontal = 0;
  if (!cameras.camera(pcl::RigCamera::Vertical).is_there)
    rig.baseline_vertical = 0;
  pcl::saveRigCalibration(otherPath(), rig, cameras);
  const pcl::RigCalibration again = pcl::loadRigCalibration(otherPath());
  require(again.width == cameras.width && again.height == cameras.height);
  for (std::size_t i = 0; i < cameras.cameras.size(); ++i)
    requireEqual(again.cameras[i], cameras.cameras[i]);
}

} // namespace

/** Bytes are refused, or give a rig and cameras that can be written and read back. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const MemoryFile file(data, size);
  const auto rig = readFuzzed(&pcl::loadTrinocularRig, file.path());
  const auto cameras = readFuzzed(&pcl::loadRigCalibration, file.path());
  if (rig)
    checkRig(*rig);
  if (cameras)
    checkCameras(*cameras);
  if (rig || cameras)
    std::filesystem::remove(otherPath());
  return 0;
}
