#include "report/quality_page.h"

#include "report/report_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;

/** \brief The numbers of a list of at least this many; entries that are none are NaN. */
std::optional<std::vector<double>>
numbersOf(const Json& list, std::size_t minimum)
{
  if (!list.is_array() || list.size() < minimum)
    return std::nullopt;
  std::vector<double> numbers;
  for (const Json& one : list)
    numbers.push_back(one.is_number() ? one.get<double>()
                                      : std::numeric_limits<double>::quiet_NaN());
  return numbers;
}

bool
areFinite(const std::vector<double>& numbers, std::size_t count)
{
  return std::all_of(numbers.begin(),
                     numbers.begin() + static_cast<std::ptrdiff_t>(count),
                     [](double number) { return std::abs(number) < 1e6; });
}

std::string
formatted(const char* format, double value)
{
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

/** \brief A coordinate of a drawing. */
std::string
at(double value)
{
  std::string text = formatted("%.2f", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.')
    text.pop_back();
  return text == "-0" ? "0" : text;
}

// Scales

struct FigureText {
  const char* key;
  const char* name;
  const char* meaning;
  double factor; ///< of the formatted value
  const char *format, *limit_format;
};

constexpr std::array<FigureText, 4> figure_texts = {
    {{"sharpness",
      "Sharpness",
      "How far apart several observations see the same place of floor, ceiling and "
      "walls, without "
      "noise; of one observation, how uneven these are.",
      1000,
      "%.1f mm",
      "%g mm"},
     {"coverage",
      "Coverage",
      "How much of floor, ceiling and walls of the rooms was seen.",
      100,
      "%.0f %%",
      "%g %%"},
     {"rays",
      "Agreement of rays",
      "How many rays of the sensor pass through no surface of the map.",
      100,
      "%.1f %%",
      "%g %%"},
     {"overlap",
      "Overlap",
      "How much the observation that is joined worst shares with the others.",
      100,
      "%.0f %%",
      "%g %%"}}};

/** \brief A bar of three zones, bad, between and good, with a mark at the value. */
std::string
scaleOf(double value, double good, double bad, const FigureText& text)
{
  constexpr double width = 300, zone = width / 3, top = 16, height = 12;
  std::string svg =
      "<svg class=\"scale\" viewBox=\"0 0 300 46\" role=\"img\" aria-label=\"" +
      std::string(text.name) + " from bad to good\">";
  constexpr const char* colors[] = {"#d9805f", "#ecd58c", "#7fb98b"};
  for (int k = 0; k < 3; ++k)
    svg += "<rect x=\"" + at(k * zone) + "\" y=\"" + at(top) + "\" width=\"" +
           at(zone) + "\" height=\"" + at(height) + "\" fill=\"" + colors[k] + "\"/>";
  const auto label = [&](double x, const char* anchor, const std::string& words) {
    svg += "<text x=\"" + at(x) + "\" y=\"43\" text-anchor=\"" + anchor + "\">" +
           words + "</text>";
  };
  label(0, "start", "bad");
  label(zone, "middle", formatted(text.limit_format, text.factor * bad));
  label(2 * zone, "middle", formatted(text.limit_format, text.factor * good));
  label(width, "end", "good");
  if (std::isfinite(value)) {
    const double x =
        std::clamp(zone + zone * (value - bad) / (good - bad), 7.0, width - 7);
    svg += "<path d=\"M" + at(x) + " " + at(top + height) + "l-7 -20h14z\"/>";
  }
  return svg + "</svg>";
}

// Places

using Corners = std::vector<std::pair<double, double>>;

Corners
cornersOf(const Json& outline)
{
  Corners corners;
  if (outline.is_array())
    for (const Json& corner : outline)
      if (const auto place = numbersOf(corner, 2); place && areFinite(*place, 2))
        corners.emplace_back((*place)[0], (*place)[1]);
  return corners;
}

/** \brief Blue for what is sharp, over yellow, to red for what is rough. */
std::string
colorOf(double roughness)
{
  constexpr double rough = 0.03; // metres
  if (!std::isfinite(roughness))
    return "#777";
  constexpr std::array<std::array<double, 3>, 3> stops = {
      {{38, 98, 166}, {222, 178, 46}, {178, 30, 40}}};
  const double share = 2 * std::clamp(roughness / rough, 0.0, 1.0);
  const auto first = std::min<std::size_t>(static_cast<std::size_t>(share), 1);
  const double part = share - static_cast<double>(first);
  std::string color = "rgb(";
  for (std::size_t k = 0; k < 3; ++k)
    color +=
        formatted("%.0f", (1 - part) * stops[first][k] + part * stops[first + 1][k]) +
        (k < 2 ? "," : ")");
  return color;
}

/** \brief Draws a plan, in metres; y of the plan points up. */
class PlaceDrawing {
public:
  PlaceDrawing(const Json& plan, const Json& roughness, const Json& positions)
  : plan_(plan)
  , roughness_(numbersOf(roughness, 0).value_or(std::vector<double>()))
  , positions_(positions)
  {
    for (const Json& room : listOf("rooms"))
      extend(cornersOf(room));
    for (const Json& one : listOf("furniture"))
      extend(cornersOf(one));
    if (positions_.is_array())
      for (const Json& position : positions_)
        if (const auto eye = flat(fieldOf(position, "eye")))
          extend({*eye});
    for (const Json& wall : listOf("walls"))
      if (const auto line = numbersOf(wall, 4); line && areFinite(*line, 4))
        extend({{(*line)[0], (*line)[1]}, {(*line)[2], (*line)[3]}});
  }

  std::string
  draw()
  {
    if (!(right_ > left_) || !(top_ > bottom_))
      return {};
    unit_ = std::max(right_ - left_, top_ - bottom_) / 100; // of strokes and letters
    const double margin = 4 * unit_;
    const double width = right_ - left_ + 2 * margin,
                 height = top_ - bottom_ + 2 * margin + 6 * unit_;
    svg_ = "<svg class=\"places\" viewBox=\"" + at(left_ - margin) + " " +
           at(-top_ - margin) + " " + at(width) + " " + at(height) +
           "\" role=\"img\" aria-label=\"The map from above\">" + patterns();
    for (const Json& room : listOf("rooms"))
      addShape(cornersOf(room), "fill=\"#f4f2ec\"");
    addUnseen("ceiling", "url(#unseen-above)", false);
    addUnseen("floor", "url(#unseen)", false);
    for (const Json& one : listOf("furniture"))
      addShape(cornersOf(one),
               "fill=\"#dcd8cd\" stroke=\"#8d8877\" stroke-width=\"" + at(0.2 * unit_) +
                   "\"");
    addUnseen("wall", "url(#unseen)", true);
    addWalls();
    addPositions();
    addScaleBar();
    return svg_ + "</svg>";
  }

private:
  const Json&
  listOf(const char* name) const
  {
    static const Json nothing = Json::array();
    const Json& list = fieldOf(plan_, name);
    return list.is_array() ? list : nothing;
  }

  void
  extend(const Corners& corners)
  {
    for (const auto& [x, y] : corners) {
      left_ = std::min(left_, x);
      right_ = std::max(right_, x);
      bottom_ = std::min(bottom_, y);
      top_ = std::max(top_, y);
    }
  }

  static std::string
  place(double x, double y)
  {
    return at(x) + " " + at(-y);
  }

  std::string
  patterns() const
  {
    const auto pattern = [&](const char* name, const char* color, int angle) {
      const std::string size = at(1.6 * unit_);
      return "<pattern id=\"" + std::string(name) +
             "\" patternUnits=\"userSpaceOnUse\" width=\"" + size + "\" height=\"" +
             size + "\" patternTransform=\"rotate(" + std::to_string(angle) +
             ")\"><path d=\"M0 0V" + size + "\" stroke=\"" + color +
             "\" stroke-width=\"" + at(0.7 * unit_) + "\"/></pattern>";
    };
    return "<defs>" + pattern("unseen", "#5c6670", 45) +
           pattern("unseen-above", "#c3cad1", -45) + "</defs>";
  }

  void
  addShape(const Corners& corners, const std::string& style)
  {
    if (corners.size() < 3)
      return;
    std::string path;
    for (const auto& [x, y] : corners)
      path += (path.empty() ? "M" : "L") + place(x, y);
    svg_ += "<path d=\"" + path + "Z\" " + style + "/>";
  }

  /** \brief Hatches the squares in which something of a role is unseen. */
  void
  addUnseen(const char* role, const char* fill, bool is_upright)
  {
    const Json& size = fieldOf(plan_, "patch_size");
    double side = size.is_number() ? std::clamp(size.get<double>(), 0.0, 100.0) : 0;
    if (is_upright) // walls are lines in a plan
      side = std::max(side, 2 * unit_);
    std::string path;
    for (const Json& patch : listOf("unseen"))
      if (const auto where = numbersOf(patch, 3);
          where && areFinite(*where, 2) && patch[2] == Json(role))
        path += "M" + place((*where)[0] - side / 2, (*where)[1] + side / 2) + "h" +
                at(side) + "v" + at(side) + "h" + at(-side) + "z";
    if (!path.empty())
      svg_ += "<path d=\"" + path + "\" fill=\"" + fill + "\"/>";
  }

  void
  addWalls()
  {
    for (const Json& wall : listOf("walls")) {
      const auto line = numbersOf(wall, 5);
      if (!line || !areFinite(*line, 5))
        continue;
      const double plane = (*line)[4];
      const double roughness =
          plane >= 0 && plane < static_cast<double>(roughness_.size())
              ? roughness_[static_cast<std::size_t>(plane)]
              : std::numeric_limits<double>::quiet_NaN();
      svg_ += "<path d=\"M" + place((*line)[0], (*line)[1]) + "L" +
              place((*line)[2], (*line)[3]) + "\" stroke=\"" + colorOf(roughness) +
              "\" stroke-width=\"" + at(1.1 * unit_) + "\"><title>plane " +
              formatted("%.0f", plane) +
              (std::isfinite(roughness) ? ": " + formatted("%.1f mm", 1000 * roughness)
                                        : "") +
              "</title></path>";
    }
  }

  /** \brief A vector of the map seen from above. */
  std::optional<std::pair<double, double>>
  flat(const Json& vector) const
  {
    const Json& axes = fieldOf(plan_, "axes");
    const auto numbers = numbersOf(vector, 3);
    if (!axes.is_array() || axes.size() < 2 || !numbers || !areFinite(*numbers, 3))
      return std::nullopt;
    std::array<double, 2> result{};
    for (const std::size_t axis : {0, 1}) {
      const auto direction = numbersOf(axes[axis], 3);
      if (!direction || !areFinite(*direction, 3))
        return std::nullopt;
      for (const std::size_t k : {0, 1, 2})
        result[axis] += (*direction)[k] * (*numbers)[k];
    }
    return std::pair(result[0], result[1]);
  }

  void
  addPositions()
  {
    if (!positions_.is_array())
      return;
    std::string numbers; // above all arrows
    int number = 0;
    for (const Json& position : positions_) {
      ++number;
      const auto eye = flat(fieldOf(position, "eye")),
                 direction = flat(fieldOf(position, "direction"));
      if (!eye || !direction)
        continue;
      const double angle = 180 / 3.14159265358979323846 *
                           std::atan2(-direction->second, direction->first);
      const std::string begin = "<g transform=\"translate(" +
                                place(eye->first, eye->second) + ") scale(" +
                                at(0.8 * unit_) + ")";
      svg_ += begin + " rotate(" + at(angle) +
              ")\"><path d=\"M0 0L14 -8A16 16 0 0 1 14 8Z\" fill=\"#7a3fa0\" "
              "fill-opacity=\".25\"/><path d=\"M3 -.7H10V-2.4L15 0L10 2.4V.7H3Z\" "
              "fill=\"#7a3fa0\"/></g>";
      numbers += begin +
                 "\"><circle r=\"3\" fill=\"#7a3fa0\"/><text "
                 "text-anchor=\"middle\" y=\"1.6\" font-size=\"4.4\" "
                 "fill=\"#fff\">" +
                 std::to_string(number) + "</text></g>";
    }
    svg_ += numbers;
  }

  void
  addScaleBar()
  {
    const double width = right_ - left_;
    double length = 0.1;
    for (const double next : {0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0})
      if (next <= width / 3)
        length = next;
    svg_ += "<path d=\"M" + place(left_, bottom_ - 5 * unit_) + "h" + at(length) +
            "\" stroke=\"#333\" stroke-width=\"" + at(0.6 * unit_) +
            "\"/><text font-size=\"" + at(3 * unit_) + "\" x=\"" +
            at(left_ + length + unit_) + "\" y=\"" + at(-bottom_ + 6 * unit_) + "\">" +
            at(length) + " m</text>";
  }

  const Json& plan_;
  std::vector<double> roughness_;
  const Json& positions_;
  double left_ = std::numeric_limits<double>::infinity(), right_ = -left_,
         bottom_ = left_, top_ = right_;
  double unit_ = 1;
  std::string svg_;
};

} // namespace

Json
figuresOf(const Json& quality)
{
  Json figures = Json::array();
  for (const FigureText& text : figure_texts) {
    const Json& figure = fieldOf(quality, text.key);
    const auto limits =
        numbersOf(Json::array({fieldOf(figure, "good"), fieldOf(figure, "bad")}), 2);
    if (!areFinite(*limits, 2) || (*limits)[0] == (*limits)[1])
      continue;
    const double value = numbersOf(Json::array({fieldOf(figure, "value")}), 1)->front();
    figures.push_back(
        {{"name", text.name},
         {"value",
          std::isfinite(value) ? formatted(text.format, text.factor * value)
                               : "not known"},
         {"meaning", text.meaning},
         {"advice", fieldOf(figure, "advice")},
         {"scale", scaleOf(value, (*limits)[0], (*limits)[1], text)}});
  }
  return figures;
}

std::string
placeDrawing(const Json& plan, const Json& roughness, const Json& positions)
{
  return PlaceDrawing(plan, roughness, positions).draw();
}

std::string
energyDrawing(const Json& steps)
{
  const auto energies = numbersOf(fieldOf(steps, "energy"), 1);
  if (!energies)
    return {};
  const Json &searches = fieldOf(steps, "search"), &sizes = fieldOf(steps, "bin_size");
  const auto kindOf = [&](std::size_t step) {
    const auto text = [&](const Json& list) {
      return list.is_array() && step < list.size() ? list[step].dump(-1, ' ', true)
                                                   : std::string();
    };
    return std::pair(text(searches), text(sizes));
  };
  std::map<std::pair<std::string, std::string>, double> lowest;
  for (std::size_t k = 0; k < energies->size(); ++k)
    if (std::isfinite((*energies)[k])) {
      double& minimum = lowest.try_emplace(kindOf(k), (*energies)[k]).first->second;
      minimum = std::min(minimum, (*energies)[k]);
    }
  std::vector<double> heights, sorted;
  for (std::size_t k = 0; k < energies->size(); ++k) {
    heights.push_back(std::isfinite((*energies)[k]) ? (*energies)[k] - lowest[kindOf(k)]
                                                    : (*energies)[k]);
    if (std::isfinite(heights.back()))
      sorted.push_back(heights.back());
  }
  if (sorted.empty())
    return {};
  std::sort(sorted.begin(), sorted.end());
  // those far above the others leave the picture
  const double maximum = std::max(sorted[sorted.size() - 1 - sorted.size() / 40], 1e-6);
  constexpr double width = 640, left = 64, base = 214;
  const auto x = [&](std::size_t step) {
    return left + (width - left - 8) * static_cast<double>(step) /
                      static_cast<double>(std::max<std::size_t>(heights.size(), 2) - 1);
  };
  const auto y = [&](double above) {
    return std::max(4.0, base - (base - 12) * above / maximum);
  };
  std::string path;
  for (std::size_t k = 0; k < heights.size(); ++k) {
    if (!std::isfinite(heights[k]))
      continue;
    const bool goes_on =
        k > 0 && std::isfinite(heights[k - 1]) && kindOf(k - 1) == kindOf(k);
    path += (goes_on ? "L" : "M") + at(x(k)) + " " + at(y(heights[k])) +
            (goes_on ? "" : "h.1"); // so that a single step is a dot
  }
  std::string svg =
      "<svg class=\"energy\" viewBox=\"0 0 640 240\" role=\"img\" aria-label=\"Energy "
      "over "
      "the steps of each search\"><path d=\"M64 4V214H632\" stroke=\"#888\" "
      "fill=\"none\"/>";
  for (const double share : {0.0, 0.5, 1.0})
    svg += "<text x=\"58\" y=\"" + at(y(share * maximum) + 4) +
           "\" text-anchor=\"end\">" + formatted("%.3g", share * maximum) + "</text>";
  svg += "<text x=\"632\" y=\"234\" text-anchor=\"end\">" +
         std::to_string(heights.size()) + " steps</text>";
  return svg + "<path d=\"" + path +
         "\" stroke=\"#2662a6\" stroke-width=\"2\" "
         "stroke-linejoin=\"round\" stroke-linecap=\"round\" fill=\"none\"/></svg>";
}

} // namespace pcl::acmap
