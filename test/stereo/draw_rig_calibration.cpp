#include "rendered_boards.h"

#include <pcl/core/image_file.h>
#include <pcl/stereo/rig_calibrator.h>
#include <pcl/stereo/trinocular_rectification.h>

#include <cmath>
#include <exception>
#include <filesystem>
#include <iostream>

// Writes the board images of a simulated rig into a folder, and draws the picture of
// the tutorial from them.

namespace {

using namespace pcl;
using namespace pcl::acmap;
using namespace pcl::acmap::test;

using Color = std::array<std::uint8_t, 3>;

constexpr Color red = {230, 40, 40};
constexpr Color green = {20, 160, 60};

/** \brief A picture with three columns and two rows of images at half their size. */
class Sheet {
public:
  Sheet(int width, int height)
  : width_(width)
  , height_(height)
  {
    picture_.width = 3 * (width / 2);
    picture_.height = 2 * (height / 2);
    picture_.values.resize(3u * static_cast<std::size_t>(picture_.width) *
                           static_cast<std::size_t>(picture_.height));
  }

  void
  place(const CameraImage& image, int column, int row)
  {
    for (int y = 0; y < height_ / 2; ++y)
      for (int x = 0; x < width_ / 2; ++x) {
        const auto at = [&](int dx, int dy) -> int {
          return image
              .values[static_cast<std::size_t>((2 * y + dy) * width_ + 2 * x + dx)];
        };
        // few grey levels give a small file
        const int grey = (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1)) / 4 / 12 * 12;
        const auto level = static_cast<std::uint8_t>(grey);
        paint(column, row, x, y, {level, level, level});
      }
  }

  /** \param[in] pixel position in the image of the cell, at full size */
  void
  dot(int column, int row, const Eigen::Vector2d& pixel, const Color& color)
  {
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x)
        paint(column,
              row,
              static_cast<int>(std::lround(pixel.x() / 2)) + x,
              static_cast<int>(std::lround(pixel.y() / 2)) + y,
              color);
  }

  void
  line(int column, int row, double place, bool is_row, const Color& color)
  {
    const int at = static_cast<int>(std::lround(place / 2));
    for (int i = 0; i < (is_row ? width_ : height_) / 2; ++i)
      paint(column, row, is_row ? i : at, is_row ? at : i, color);
  }

  const RgbImage&
  picture() const
  {
    return picture_;
  }

private:
  void
  paint(int column, int row, int x, int y, const Color& color)
  {
    if (x >= 0 && y >= 0 && x < width_ / 2 && y < height_ / 2)
      std::copy(color.begin(),
                color.end(),
                picture_.at(column * (width_ / 2) + x, row * (height_ / 2) + y));
  }

  int width_;
  int height_;
  RgbImage picture_;
};

/** \brief Draws common epipolar lines of two views of the rectified images at some
 * corners. */
void
drawLines(const TrinocularRectification& rectification,
          const RigCalibrator& calibrator,
          std::size_t shot,
          Sheet& sheet)
{
  for (const std::size_t corner : {0u, 8u, 45u, 53u}) {
    const auto& found = calibrator.getCorners(3 * shot)[corner];
    const Eigen::Vector2d at =
        rectification.rectifiedPixel(RigCamera::Reference, found.cast<double>());
    sheet.line(0, 1, at.y(), true, red);
    sheet.line(1, 1, at.y(), true, red);
    sheet.line(0, 1, at.x(), false, green);
    sheet.line(2, 1, at.x(), false, green);
  }
}

/** \brief The shot with the largest board. */
std::size_t
nearestShot(const RigCalibrator& calibrator)
{
  std::size_t nearest = 0;
  float widest = 0;
  for (std::size_t image = 0; image < calibrator.getReport().images.size();
       image += 3) {
    const auto& corners = calibrator.getCorners(image);
    const float width = (corners.back() - corners.front()).norm();
    if (width > widest) {
      widest = width;
      nearest = image / 3;
    }
  }
  return nearest;
}

void
draw(const std::string& folder)
{
  const std::vector<TrinocularFrame> shots = boardShots(builtRig(), 18);
  RigCalibrator calibrator;
  for (std::size_t i = 0; i < shots.size(); ++i) {
    calibrator.addShot(shots[i], shotNames(i));
    for (std::size_t k = 0; k < 3; ++k) {
      const CameraImage& image = shots[i].images[k];
      savePng(folder + "/" + shotNames(i)[k], image.width, image.height, image.values);
    }
  }
  const std::size_t shown = nearestShot(calibrator);
  RigCalibration cameras;
  TrinocularRig rig;
  calibrator.calibrate(cameras, rig);
  TrinocularRectification rectification;
  rectification.setInputCalibration(cameras);
  TrinocularFrame rectified;
  rectification.rectify(shots[shown], rectified);

  Sheet sheet(rig.width, rig.height);
  for (std::size_t k = 0; k < 3; ++k) {
    const int column = static_cast<int>(k);
    sheet.place(shots[shown].images[k], column, 0);
    for (const Eigen::Vector2f& corner : calibrator.getCorners(3 * shown + k))
      sheet.dot(column, 0, corner.cast<double>(), red);
    sheet.place(rectified.images[k], column, 1);
  }
  drawLines(rectification, calibrator, shown, sheet);
  savePng(folder + "/rig_calibration.png", sheet.picture());
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc != 2) {
    std::cerr << "usage: draw_rig_calibration FOLDER\n";
    return 2;
  }
  try {
    std::filesystem::create_directories(argv[1]);
    draw(argv[1]);
  }
  catch (const std::exception& exception) {
    std::cerr << "draw_rig_calibration: " << exception.what() << "\n";
    return 1;
  }
}
