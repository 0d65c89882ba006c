#include "board_views.h"

#include "opencv_values.h"

#include <pcl/core/impl/size_text.h>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <limits>

namespace pcl::acmap {

namespace {

constexpr float min_spacing = 8.0F; // px between adjacent corners
constexpr double max_blur = 5.0;    // width of an edge from dark to bright, px

using Corners = std::vector<cv::Point2f>;

cv::Mat
greyOf(const CameraImage& image)
{
  const int type = image.channels == 3 ? CV_8UC3 : CV_8UC1;
  // OpenCV has no matrix of constant bytes; this one is only read.
  auto* const values = const_cast<std::uint8_t*>(image.values.data());
  const cv::Mat all(image.height, image.width, type, values);
  cv::Mat grey;
  if (image.channels == 3)
    cv::cvtColor(all, grey, cv::COLOR_RGB2GRAY);
  else
    grey = all.clone();
  return grey;
}

/** \brief Mean grey level in the middle of the square right of and below a corner. */
double
greyOfSquare(const cv::Mat& grey, const Corners& corners, int columns, int at)
{
  const auto corner = [&](int i) { return corners[static_cast<std::size_t>(i)]; };
  const cv::Point2f middle = 0.25F * (corner(at) + corner(at + 1) +
                                      corner(at + columns) + corner(at + columns + 1));
  const cv::Rect around(cvRound(middle.x) - 1, cvRound(middle.y) - 1, 3, 3);
  return cv::mean(grey(around & cv::Rect({}, grey.size())))[0];
}

/** \brief Orders the corners clockwise from the corner whose inner square is dark; the
 * detector may start at either end and use either orientation. */
void
order(const cv::Mat& grey, const CalibrationBoard& board, Corners& corners)
{
  const auto columns = static_cast<std::size_t>(board.columns);
  const cv::Point2f right = corners[columns - 1] - corners.front();
  const cv::Point2f down = corners[corners.size() - columns] - corners.front();
  if (right.cross(down) < 0)
    for (std::size_t row = 0; row < corners.size(); row += columns)
      std::reverse(&corners[row], &corners[row] + columns);
  if (greyOfSquare(grey, corners, board.columns, 0) >
      greyOfSquare(grey, corners, board.columns, 1))
    std::reverse(corners.begin(), corners.end());
}

float
leastSpacing(const Corners& corners, const CalibrationBoard& board)
{
  float minimum = std::numeric_limits<float>::max();
  const auto columns = static_cast<std::size_t>(board.columns);
  const auto length = [&](std::size_t a, std::size_t b) {
    minimum = std::min(minimum, static_cast<float>(cv::norm(corners[a] - corners[b])));
  };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if ((i + 1) % columns != 0)
      length(i, i + 1);
    if (i + columns < corners.size())
      length(i, i + columns);
  }
  return minimum;
}

/** \brief Moves each corner to the intersection of the edges around it. The window
 * stays within the four squares, where the edges are straight. */
void
refine(const cv::Mat& grey, float spacing, Corners& corners)
{
  const int half = std::clamp(static_cast<int>(spacing / 3.0F), 2, 11);
  cv::cornerSubPix(grey,
                   corners,
                   {half, half},
                   {-1, -1},
                   {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 50, 1e-3});
}

std::string
faultOf(const cv::Mat& grey,
        const cv::Size& size,
        const Corners& corners,
        float minimum)
{
  if (minimum < min_spacing)
    return "the board is too small: its corners are " +
           std::to_string(cvRound(minimum)) + " px apart";
  const double blur = cv::estimateChessboardSharpness(grey, size, corners)[0];
  if (blur > max_blur)
    return "blurred: its edges are " + std::to_string(cvRound(blur)) + " px wide";
  return "";
}

} // namespace

BoardCorners
findBoard(const CameraImage& image, const CalibrationBoard& board)
try {
  const cv::Mat grey = greyOf(image);
  const cv::Size size(board.columns, board.rows);
  Corners corners;
  BoardCorners found;
  if (!cv::findChessboardCornersSB(grey, size, corners, cv::CALIB_CB_NORMALIZE_IMAGE) ||
      corners.size() != static_cast<std::size_t>(size.area())) {
    found.reason =
        "no whole board of " + sizeText(board.columns, board.rows) + " corners found";
    return found;
  }
  order(grey, board, corners);
  const float spacing = leastSpacing(corners, board);
  found.reason = faultOf(grey, size, corners, spacing);
  if (found.reason.empty())
    refine(grey, spacing, corners);
  for (const cv::Point2f& corner : corners)
    found.corners.emplace_back(corner.x, corner.y);
  return found;
}
catch (const cv::Exception& error) {
  requireMemoryWasThere(error);
  throw;
}

} // namespace pcl::acmap
