#include "report_page.h"

#include "drawing.h"
#include "entropy_rectification/energy_curve.h"
#include "page_text.h"
#include "page_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;

constexpr double width = 900, height = 380; // in SVG units
constexpr double left = 70, right = 20, top = 15, bottom = 60;

constexpr std::array<const char*, 6> palette = {
    "#195abe", "#c81e28", "#1e8c3c", "#be7800", "#783caa", "#008c96"};

std::vector<RectificationStep>
stepsOf(const Json& columns)
{
  const Json& searches = fieldOf(columns, "search");
  const Json& sizes = fieldOf(columns, "bin_size");
  const Json& energies = fieldOf(columns, "energy");
  std::vector<RectificationStep> steps;
  if (!searches.is_array() || !sizes.is_array() || !energies.is_array())
    return steps;
  const std::size_t rows = std::min({searches.size(), sizes.size(), energies.size()});
  for (std::size_t i = 0; i < rows; ++i) {
    constexpr double most = 1e100; // limit, so that differences of energies stay finite
    RectificationStep step;
    step.search = searches[i].is_string() ? searches[i].get<std::string>() : "";
    step.bin_size = sizes[i].is_number() ? sizes[i].get<double>() : 0;
    step.energy = energies[i].is_number() ? energies[i].get<double>() : most;
    if (!(std::abs(step.energy) < most))
      step.energy = std::numeric_limits<double>::quiet_NaN();
    steps.push_back(step);
  }
  return steps;
}

/** The searches in the order of their start. */
std::vector<std::string>
searchesOf(const std::vector<RectificationStep>& steps)
{
  std::vector<std::string> searches;
  for (const RectificationStep& step : steps)
    if (std::find(searches.begin(), searches.end(), step.search) == searches.end())
      searches.push_back(step.search);
  return searches;
}

const char*
colorOf(const std::string& search, const std::vector<std::string>& searches)
{
  const auto found = std::find(searches.begin(), searches.end(), search);
  return palette[static_cast<std::size_t>(found - searches.begin()) % palette.size()];
}

std::string
coordinate(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

class Chart {
public:
  explicit Chart(const std::vector<RectificationStep>& steps)
  : steps_(steps)
  , searches_(searchesOf(steps))
  , heights_(energiesAboveLowest(steps))
  , range_(shownRange(heights_))
  , last_(static_cast<double>(std::max<std::size_t>(steps.size(), 2) - 1))
  {}

  std::string
  svg() const
  {
    return "<svg viewBox=\"0 0 " + coordinate(width) + " " + coordinate(height) +
           "\" role=\"img\" aria-label=\"Energy above the lowest over the steps of the "
           "search\">\n<clipPath id=\"frame\"><rect x=\"0\" y=\"" +
           coordinate(top) + "\" width=\"" + coordinate(width) + "\" height=\"" +
           coordinate(height - top) + "\"/></clipPath>\n" + axes() +
           "<g clip-path=\"url(#frame)\" fill=\"none\" stroke-width=\"2\" "
           "stroke-linejoin=\"round\" stroke-linecap=\"round\">\n" +
           curves() + "</g>\n</svg>\n";
  }

  std::string
  legend() const
  {
    std::string html = "<p class=\"legend\">Searches:";
    for (const std::string& search : searches_)
      html += std::string(" <span style=\"color:") + colorOf(search, searches_) +
              "\">\xE2\x97\x8F " + htmlText(search) + "</span>";
    return html + "</p>\n";
  }

private:
  double
  column(double step) const
  {
    return left + step / last_ * (width - left - right);
  }

  double
  row(double energy) const
  {
    // limits lines that leave the picture, as the range of coordinates in browsers is
    // limited
    const double shown = std::min(energy, 100 * range_.most);
    return height - bottom -
           (shown - range_.least) / range_.length() * (height - top - bottom);
  }

  static std::string
  line(double x0, double y0, double x1, double y1)
  {
    return "<line x1=\"" + coordinate(x0) + "\" y1=\"" + coordinate(y0) + "\" x2=\"" +
           coordinate(x1) + "\" y2=\"" + coordinate(y1) + "\"/>";
  }

  static std::string
  label(double x, double y, const char* anchor, const std::string& text)
  {
    return "<text x=\"" + coordinate(x) + "\" y=\"" + coordinate(y) +
           "\" text-anchor=\"" + anchor + "\">" + text + "</text>\n";
  }

  std::string
  axes() const
  {
    const double floor = height - bottom;
    std::string lines, texts;
    const double step = std::max(1.0, roundLength(last_ / 4));
    for (int i = 0; i * step <= last_; ++i) {
      const double x = column(i * step);
      lines += line(x, floor, x, floor + 6);
      texts += label(x, floor + 26, "middle", numberText(i * step));
    }
    const double rise = roundLength(range_.length() / 4);
    for (int i = 0; i * rise <= range_.most; ++i) {
      const double y = row(i * rise);
      lines += line(left - 6, y, left, y);
      texts += label(left - 10, y + 5, "end", numberText(i * rise));
    }
    lines += line(left, top, left, floor) + line(left, floor, width - right, floor);
    return "<g stroke=\"#555\">" + lines + "</g>\n" + texts +
           label(width - right, height - 6, "end", "steps");
  }

  /** Draws a line for each run of comparable steps, with a dot at its start. */
  std::string
  curves() const
  {
    std::string html;
    bool is_drawing = false;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const bool is_shown = std::isfinite(heights_[i]);
      const bool goes_on =
          is_shown && is_drawing && areComparable(steps_[i - 1], steps_[i]);
      if (is_drawing && !goes_on)
        html += "\"/>\n";
      is_drawing = is_shown;
      if (!is_shown)
        continue;
      const std::string x = coordinate(column(static_cast<double>(i)));
      const std::string y = coordinate(row(heights_[i]));
      const std::string color = colorOf(steps_[i].search, searches_);
      if (goes_on)
        html += " " + x + " " + y;
      else
        html += "<circle cx=\"" + x + "\" cy=\"" + y + "\" r=\"3.5\" fill=\"" + color +
                "\"/><path stroke=\"" + color + "\" d=\"M" + x + " " + y + " L" + x +
                " " + y;
    }
    return html + (is_drawing ? "\"/>\n" : "");
  }

  const std::vector<RectificationStep>& steps_;
  std::vector<std::string> searches_;
  std::vector<double> heights_;
  EnergyRange range_;
  double last_;
};

} // namespace

std::string
energyFigure(const Json& json)
{
  const std::vector<RectificationStep> steps = stepsOf(json);
  if (steps.empty())
    return {};
  const Chart chart(steps);
  return chart.svg() + chart.legend();
}

} // namespace pcl::acmap
