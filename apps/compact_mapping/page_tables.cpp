#include "report_page.h"

#include "page_text.h"
#include "page_values.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* unknown = "\xE2\x80\x93"; // a dash

std::string
cell(const std::string& text)
{
  return "<td class=\"number\">" + text + "</td>";
}

/** \param[in] factor converts to the unit that is shown
 * \param[in] digits after the decimal point */
std::string
numberCell(const Json& json, const char* name, double factor, int digits)
{
  const auto number = numberOf(json, name);
  return cell(number ? fixedText(factor * *number, digits) : unknown);
}

/** Equation such as "1.0000 x - 0.0024 y + 0.0000 z - 1.2100 = 0", with typographic
 * minus signs; a line may only break before a sign. */
std::string
equationOf(const Json& plane)
{
  const Json& coefficients = fieldOf(plane, "coefficients");
  if (!coefficients.is_array() || coefficients.size() != 4)
    return unknown;
  constexpr std::array<const char*, 4> factors = {
      "\xC2\xA0x", "\xC2\xA0y", "\xC2\xA0z", ""};
  // resolution: 0.006 degrees for the normal, 0.1 mm for the offset
  constexpr int digits = 4;
  std::string text;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    if (!coefficients[i].is_number() || !std::isfinite(coefficients[i].get<double>()))
      return unknown;
    const double value = coefficients[i].get<double>();
    const std::string size = fixedText(std::abs(value), digits);
    const bool is_negative = fixedText(value, digits) != size;
    if (i > 0)
      text += is_negative ? " \xE2\x88\x92\xC2\xA0" : " +\xC2\xA0";
    else if (is_negative)
      text += "\xE2\x88\x92";
    text += size + factors[i];
  }
  return text + "\xC2\xA0=\xC2\xA0" + "0";
}

using Rows = std::vector<std::pair<std::string, std::string>>;

/** A table of names and values, which are already HTML. */
std::string
tableOf(const Rows& rows)
{
  std::string html = "<table class=\"pairs\">\n<tbody>\n";
  for (const auto& [name, value] : rows)
    html += "<tr><th scope=\"row\">" + name + "</th><td>" + value + "</td></tr>\n";
  return html + "</tbody>\n</table>\n";
}

Rows
truthRows(const Json& truth)
{
  Rows rows;
  const auto add = [&](const char* name, const char* field, const char* unit) {
    if (const auto value = numberOf(truth, field))
      rows.emplace_back(name, numberText(*value) + unit);
  };
  const auto found = numberOf(truth, "main_planes_found");
  const auto planes = numberOf(truth, "main_planes");
  if (found)
    rows.emplace_back("main planes found",
                      numberText(*found) +
                          (planes ? " of " + numberText(*planes) : ""));
  add("mean angle to the true planes", "mean_angle_deg", "\xC2\xB0");
  if (const auto offset = numberOf(truth, "mean_offset_m"))
    rows.emplace_back("mean offset from them", numberText(1000 * *offset) + " mm");
  add("error of the poses before rectification (ATE)", "ate_before_m", " m");
  add("error of the poses after rectification (ATE)", "ate_after_m", " m");
  const auto before = numberOf(truth, "ate_before_m");
  const auto after = numberOf(truth, "ate_after_m");
  if (before && after && *before > 0)
    rows.emplace_back("ATE after : before", numberText(*after / *before));
  if (const auto compactness = numberOf(truth, "compactness"))
    rows.emplace_back("compactness", fixedText(std::floor(*compactness), 0) + " : 1");
  return rows;
}

Rows
summaryRows(const Json& stage)
{
  Rows rows;
  for (const Json& line : fieldOf(stage, "summary"))
    if (line.is_array() && line.size() == 2 && line[0].is_string() &&
        line[1].is_string())
      rows.emplace_back(htmlText(line[0].get<std::string>()),
                        htmlText(line[1].get<std::string>()));
  return rows;
}

} // namespace

std::string
planesTable(const Json& report)
{
  const Json& planes = detailOf(report, "planes");
  if (!planes.is_array() || planes.empty())
    return {};
  std::string html =
      "<h2>Planes</h2>\n<div class=\"wide\">\n<table>\n<thead><tr>"
      "<th class=\"number\">plane</th><th>equation, metres</th>"
      "<th class=\"number\">area, m\xC2\xB2</th><th class=\"number\">rmse, mm</th>"
      "<th class=\"number\">points</th></tr></thead>\n<tbody>\n";
  for (std::size_t i = 0; i < planes.size(); ++i)
    html += "<tr>" + cell(numberText(numberOf(planes[i], "id").value_or(i))) +
            "<td class=\"equation\">" + equationOf(planes[i]) + "</td>" +
            numberCell(planes[i], "area", 1, 2) +
            numberCell(planes[i], "rmse", 1000, 2) +
            numberCell(planes[i], "support", 1, 0) + "</tr>\n";
  return html + "</tbody>\n</table>\n</div>\n";
}

std::string
truthTable(const Json& report)
{
  const Rows rows = truthRows(fieldOf(report, "truth"));
  return rows.empty() ? "" : "<h2>Against the truth</h2>\n" + tableOf(rows);
}

std::string
summaryTables(const Json& report)
{
  std::string html;
  for (const Json& stage : fieldOf(report, "stages")) {
    const Rows rows = summaryRows(stage);
    if (!rows.empty())
      html += "<section>\n<h3>" + htmlText(textOf(stage, "name")) + "</h3>\n" +
              tableOf(rows) + "</section>\n";
  }
  return html.empty() ? ""
                      : "<h2>Stages</h2>\n<div class=\"cards\">\n" + html + "</div>\n";
}

} // namespace pcl::acmap
