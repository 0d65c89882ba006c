#include "energy_curve.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace pcl::acmap {

namespace {

constexpr int width = 1000, height = 560; // pixels
constexpr int left = 90, right = 25, top = 30, bottom = 60;
constexpr int title_row = 6;

constexpr std::array<Color, 6> palette = {Color{25, 90, 190},
                                          {200, 30, 40},
                                          {30, 140, 60},
                                          {190, 120, 0},
                                          {120, 60, 170},
                                          {0, 140, 150}};

class Plot {
public:
  Plot(RgbImage& image, const EnergyRange& x, const EnergyRange& y)
  : image_(image)
  , x_(x)
  , y_(y)
  {}

  Eigen::Vector2d
  pixelOf(double x, double y) const
  {
    return {left + (x - x_.least) / x_.length() * (width - left - right),
            height - bottom - (y - y_.least) / y_.length() * (height - top - bottom)};
  }

  /** Draws a line, clipped at the upper edge of the frame. */
  void
  draw(Eigen::Vector2d from, Eigen::Vector2d to, double line_width, const Color& color)
  {
    if (from.y() > to.y())
      std::swap(from, to);
    if (to.y() < top)
      return;
    if (from.y() < top)
      from = to + (from - to) * ((to.y() - top) / (to.y() - from.y()));
    drawLine(image_, from, to, line_width, color);
  }

  void
  frame()
  {
    for (double x = std::ceil(x_.least / stepOf(x_)) * stepOf(x_); x <= x_.most;
         x += stepOf(x_)) {
      const Eigen::Vector2d at = pixelOf(x, y_.least);
      drawLine(image_, at, at + Eigen::Vector2d(0, 6), 1, black);
      label(at + Eigen::Vector2d(0, 12), x, 0.5);
    }
    for (double y = std::ceil(y_.least / stepOf(y_)) * stepOf(y_); y <= y_.most;
         y += stepOf(y_)) {
      const Eigen::Vector2d at = pixelOf(x_.least, y);
      drawLine(image_, at - Eigen::Vector2d(6, 0), at, 1, black);
      label(at - Eigen::Vector2d(12, 0.5 * text_height), y, 1);
    }
    drawLine(image_, pixelOf(x_.least, y_.least), pixelOf(x_.most, y_.least), 1, black);
    drawLine(image_, pixelOf(x_.least, y_.least), pixelOf(x_.least, y_.most), 1, black);
    drawText(image_, left, title_row, "energy above the lowest", black);
    drawText(image_, width - right - 5 * text_advance, height - 20, "steps", black);
  }

private:
  static double
  stepOf(const EnergyRange& range)
  {
    return roundLength(range.length() / 4);
  }

  /** \param[in] share fraction of the text that is left of the position */
  void
  label(const Eigen::Vector2d& place, double value, double share)
  {
    std::ostringstream text;
    text.precision(7);
    text << (std::abs(value) < 1e-9 * y_.length() ? 0.0 : value);
    const auto pixels = static_cast<double>(text.str().size() * text_advance);
    drawText(image_,
             static_cast<int>(std::lround(place.x() - share * pixels)),
             static_cast<int>(std::lround(place.y())),
             text.str(),
             black);
  }

  RgbImage& image_;
  EnergyRange x_, y_;
};

} // namespace

RgbImage
energyPicture(const std::vector<RectificationStep>& steps)
{
  RgbImage image = whiteImage(width, height);
  const auto last = static_cast<double>(std::max<std::size_t>(steps.size(), 2) - 1);
  const std::vector<double> heights = energiesAboveLowest(steps);
  Plot plot(image, {0, last}, shownRange(heights));
  std::vector<std::string> searches;
  int name_column = left + 28 * text_advance;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const RectificationStep& step = steps[i];
    const auto found = std::find(searches.begin(), searches.end(), step.search);
    const auto number = static_cast<std::size_t>(found - searches.begin());
    const Color& color = palette[number % palette.size()];
    if (found == searches.end()) {
      searches.push_back(step.search);
      drawText(image, name_column, title_row, step.search, color);
      name_column += static_cast<int>(step.search.size() + 2) * text_advance;
    }
    const Eigen::Vector2d to = plot.pixelOf(static_cast<double>(i), heights[i]);
    const bool goes_on = i > 0 && areComparable(steps[i - 1], step);
    if (goes_on)
      plot.draw(plot.pixelOf(static_cast<double>(i - 1), heights[i - 1]), to, 2, color);
    else
      plot.draw(to, to, 4, color);
  }
  plot.frame();
  return image;
}

} // namespace pcl::acmap
