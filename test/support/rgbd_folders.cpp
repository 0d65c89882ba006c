#include "rgbd_folders.h"

#include "test_png.h"

#include <iomanip>
#include <sstream>

namespace pcl::acmap::test {

namespace {

std::string
numbered(int frame)
{
  std::ostringstream text;
  text << "frame-" << std::setw(6) << std::setfill('0') << 10 * frame;
  return text.str();
}

std::string
depthBytes(int frame)
{
  return depthPngBytes(small_width, small_height, tellingDepths(frame));
}

} // namespace

std::string
textOfBytes(const std::vector<std::uint8_t>& bytes)
{
  return {bytes.begin(), bytes.end()};
}

RgbImage
tellingColors(int frame, std::int32_t width, std::int32_t height)
{
  RgbImage image{width, height, {}};
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      for (const int value : {10 + row, 200 + column, frame})
        image.values.push_back(static_cast<std::uint8_t>(value));
  return image;
}

std::vector<std::uint16_t>
tellingDepths(int frame)
{
  std::vector<std::uint16_t> depths = {0, 65535};
  for (int pixel = 2; pixel < small_width * small_height; ++pixel)
    depths.push_back(static_cast<std::uint16_t>(1000 + 10 * pixel + 500 * frame));
  return depths;
}

Eigen::Isometry3d
posedAt(int frame)
{
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, 3).normalized();
  Eigen::Isometry3d pose(Eigen::AngleAxisd(0.5 + 0.2 * frame, axis));
  pose.translation() = Eigen::Vector3d(1 + 0.1 * frame, -2, 3 - 0.3 * frame);
  return pose;
}

std::string
matrixText(const Eigen::MatrixXd& matrix)
{
  std::ostringstream text;
  text << std::setprecision(17) << matrix << "\n";
  return text.str();
}

std::string
poseRow(double stamp, const Eigen::Isometry3d& pose)
{
  const Eigen::Quaterniond q(pose.linear());
  const Eigen::Vector3d t = pose.translation();
  std::ostringstream text;
  text << std::setprecision(17) << stamp;
  for (const double value : {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()})
    text << " " << value;
  text << "\n";
  return text.str();
}

void
writeSevenScenes(const TemporaryFolder& folder, int frames)
{
  folder.write("camera-intrinsics.txt", "1e1 0 3.5\n 0.0 20 2.5\n0 0 1\n");
  for (int frame = 0; frame < frames; ++frame) {
    const std::string name = numbered(frame);
    folder.write(name + ".color.png", textOfBytes(encodePng(tellingColors(frame))));
    folder.write(name + ".depth.png", depthBytes(frame));
    folder.write(name + ".pose.txt", matrixText(posedAt(frame).matrix()));
  }
}

void
writeTum(const TemporaryFolder& folder, int frames)
{
  std::string colors = "# color images\n# timestamp filename\n";
  std::string depths = "# depth maps\n";
  std::string poses = "# ground truth\n";
  std::filesystem::create_directory(folder.path("rgb"));
  std::filesystem::create_directory(folder.path("depth"));
  for (int frame = 0; frame < frames; ++frame) {
    const std::string name = std::to_string(frame) + ".png";
    folder.write("rgb/" + name, textOfBytes(encodePng(tellingColors(frame))));
    folder.write("depth/" + name, depthBytes(frame));
    const double stamp = 1305031102.1 + 0.1 * frame;
    std::ostringstream times;
    times << std::fixed << std::setprecision(6) << stamp + 0.004 << " rgb/" << name;
    colors += times.str() + "\n";
    times.str("");
    times << stamp << " depth/" << name;
    depths += times.str() + "\n";
    // the frame's pose is halfway between these two
    Eigen::Isometry3d before = posedAt(frame);
    Eigen::Isometry3d after = posedAt(frame);
    before.translation().x() -= 0.02;
    after.translation().x() += 0.02;
    const Eigen::AngleAxisd turn(0.03, Eigen::Vector3d::UnitX());
    before.linear() = before.linear() * turn.toRotationMatrix().transpose();
    after.linear() = after.linear() * turn.toRotationMatrix();
    poses += poseRow(stamp - 0.01, before) + poseRow(stamp + 0.01, after);
  }
  folder.write("rgb.txt", colors);
  folder.write("depth.txt", depths);
  folder.write("groundtruth.txt", poses);
}

} // namespace pcl::acmap::test
