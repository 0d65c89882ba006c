#include "pictures/drawing.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace pcl::acmap {

namespace {

// lengths of a plot, pixels
constexpr int left_margin = 85, right_margin = 30, top_margin = 34, bottom_margin = 50;
constexpr int tick = 5;
constexpr int title_row = top_margin / 2; ///< of the legend, too

const Color grid_color(228, 228, 228);

constexpr int font = cv::FONT_HERSHEY_SIMPLEX;
constexpr double font_scale = 0.45;

// bits for parts of a pixel
constexpr int shift = 4;

cv::Point2l
fixedPoint(const Eigen::Vector2d& pixel)
{
  // beyond any picture, and the products of such numbers are still integers
  constexpr double farthest = 1e8;
  const Eigen::Vector2d scaled =
      (1 << shift) * pixel.cwiseMax(-farthest).cwiseMin(farthest);
  return {std::lround(scaled.x()), std::lround(scaled.y())};
}

} // namespace

cv::Mat3b
matOf(RgbImage& image)
{
  return {image.height, image.width, reinterpret_cast<Color*>(image.values.data())};
}

RgbImage
rgbImageOf(const cv::Mat3b& matrix)
{
  RgbImage image{matrix.cols, matrix.rows, {}};
  image.values.resize(3 * matrix.total());
  matrix.copyTo(matOf(image));
  return image;
}

void
drawLine(cv::Mat3b& image,
         const Eigen::Vector2d& from,
         const Eigen::Vector2d& to,
         int width,
         const Color& color)
{
  if (!from.allFinite() || !to.allFinite())
    return;
  cv::Point2l begin = fixedPoint(from), end = fixedPoint(to);
  const cv::Size2l size(std::int64_t{image.cols} << shift,
                        std::int64_t{image.rows} << shift);
  if (!cv::clipLine(size, begin, end))
    return;
  const bool is_sharp = width == 1 && (begin.x == end.x || begin.y == end.y);
  cv::line(image,
           cv::Point(begin),
           cv::Point(end),
           color,
           width,
           is_sharp ? cv::LINE_8 : cv::LINE_AA,
           shift);
}

void
drawDot(cv::Mat3b& image, const Eigen::Vector2d& at, int radius, const Color& color)
{
  const cv::Rect2d rectangle(0, 0, image.cols, image.rows);
  if (rectangle.contains(cv::Point2d(at.x(), at.y())))
    cv::circle(image,
               cv::Point(fixedPoint(at)),
               radius << shift,
               color,
               cv::FILLED,
               cv::LINE_AA,
               shift);
}

int
drawText(cv::Mat3b& image,
         const Eigen::Vector2d& at,
         const std::string& text,
         const Color& color,
         double share)
{
  int baseline = 0;
  const cv::Size size = cv::getTextSize(text, font, font_scale, 1, &baseline);
  const cv::Point begin(cvRound(at.x() - share * size.width),
                        cvRound(at.y() + 0.5 * size.height));
  constexpr int border = 3;
  cv::putText(image, text, begin, font, font_scale, white, border, cv::LINE_AA);
  cv::putText(image, text, begin, font, font_scale, color, 1, cv::LINE_AA);
  return size.width;
}

RgbImage
beside(RgbImage left, RgbImage right)
{
  constexpr int gap = 6;
  cv::Mat3b between(left.height, gap, white);
  drawLine(between, {gap / 2, 0}, {gap / 2, left.height - 1.0}, 1, gray);
  cv::Mat3b both;
  cv::hconcat(std::vector<cv::Mat3b>{matOf(left), between, matOf(right)}, both);
  return rgbImageOf(both);
}

double
roundLength(double maximum)
{
  const double power = std::pow(10.0, std::floor(std::log10(maximum)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= maximum)
      return factor * power;
  return power;
}

Plot::Plot(const cv::Size& size,
           const Eigen::AlignedBox2d& shown,
           const std::string& x_name,
           const std::string& y_name)
: shown_(shown)
, whole_(top_margin + size.height + bottom_margin,
         left_margin + size.width + right_margin,
         white)
, inside_(whole_(cv::Rect({left_margin, top_margin}, size)))
, legend_column_(left_margin)
{
  for (const int axis : {0, 1})
    drawTicks(axis);
  cv::rectangle(whole_,
                {left_margin - 1, top_margin - 1},
                {left_margin + size.width, top_margin + size.height},
                black);
  drawText(whole_,
           {left_margin + 0.5 * size.width, whole_.rows - bottom_margin * 0.25},
           x_name,
           black,
           0.5);
  addToLegend(y_name, black);
}

Eigen::Vector2d
Plot::pixelOf(double x, double y) const
{
  const Eigen::Array2d share =
      (Eigen::Vector2d(x, y) - shown_.min()).array() / shown_.sizes().array();
  return {share.x() * (inside_.cols - 1), (1 - share.y()) * (inside_.rows - 1)};
}

void
Plot::drawTicks(int axis)
{
  const bool is_x = axis == 0;
  // at most so many pixels from one number to the next
  const double share = is_x ? 200.0 / inside_.cols : 140.0 / inside_.rows;
  const double step = roundLength(share * shown_.sizes()[axis]);
  const Eigen::Vector2d across = is_x ? Eigen::Vector2d(0, 1) : Eigen::Vector2d(-1, 0);
  for (double i = std::ceil(shown_.min()[axis] / step); i * step <= shown_.max()[axis];
       ++i) {
    const double value = i * step + 0.0; // without a negative zero
    Eigen::Vector2d at = is_x ? pixelOf(value, 0) : pixelOf(0, value);
    at[1 - axis] = is_x ? inside_.rows : -1; // on the axis
    Eigen::Vector2d opposite = at;
    opposite[1 - axis] = is_x ? 0 : inside_.cols;
    drawLine(inside_, at, opposite, 1, grid_color);
    const Eigen::Vector2d on_axis = at + Eigen::Vector2d(left_margin, top_margin);
    drawLine(whole_, on_axis, on_axis + tick * across, 1, black);
    std::ostringstream number;
    number << value;
    drawText(whole_,
             on_axis + (is_x ? 3 : 2) * tick * across,
             number.str(),
             black,
             is_x ? 0.5 : 1);
  }
}

void
Plot::addToLegend(const std::string& text, const Color& color)
{
  constexpr int gap = 24; // pixels
  legend_column_ += drawText(whole_, {legend_column_, title_row}, text, color) + gap;
}

RgbImage
Plot::picture()
{
  return rgbImageOf(whole_);
}

} // namespace pcl::acmap
