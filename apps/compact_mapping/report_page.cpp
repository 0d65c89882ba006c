#include "report_page.h"

#include "page_seconds.h"
#include "page_text.h"
#include "page_values.h"

#include <pcl/core/output_file.h>

#include <filesystem>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;

std::string
titleOf(const Json& report)
{
  const std::string input = textOf(report, "input");
  return input.empty() ? "Compact map" : "Compact map of " + htmlText(input);
}

/** The content security policy prevents a browser from loading anything, whatever the
 * page contains. */
std::string
head(const Json& report)
{
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
         "img-src data:; style-src 'unsafe-inline'\">\n<title>" +
         titleOf(report) + "</title>\n<style>" + pageStyle() + "</style>\n</head>\n";
}

std::string
origin(const Json& report)
{
  const std::string tool = textOf(report, "tool"), version = textOf(report, "version"),
                    start = textOf(report, "starting_point");
  std::string text = htmlText(tool);
  if (!version.empty())
    text += (text.empty() ? "version " : " ") + htmlText(version);
  if (!start.empty())
    text += (text.empty() ? "from: " : ", from: ") + htmlText(start);
  return text.empty() ? "" : "<p class=\"origin\">" + text + "</p>\n";
}

std::string
commandLine(const Json& report)
{
  const std::vector<std::string> arguments = textsOf(report, "command_line");
  return arguments.empty()
             ? ""
             : "<pre><code>" + htmlText(shellText(arguments)) + "</code></pre>\n";
}

std::string
pictures(const Json& report, const std::string& folder)
{
  std::string html;
  for (const Json& picture : fieldOf(report, "pictures")) {
    const std::string name = textOf(picture, "file");
    if (!name.empty())
      html += pictureFigure((std::filesystem::path(folder) / name).string(),
                            name,
                            textOf(picture, "caption"));
  }
  return html.empty()
             ? ""
             : "<h2>Pictures</h2>\n<div class=\"pictures\">\n" + html + "</div>\n";
}

std::string
energies(const Json& report)
{
  const std::string figure = energyFigure(detailOf(report, "steps"));
  return figure.empty()
             ? ""
             : "<h2>Energy of the rectification</h2>\n" + figure +
                   "<p class=\"legend\">Energies are comparable only within one search "
                   "and size of bins: each is drawn above the lowest of its kind, and "
                   "the line breaks where the kind changes. Those far above the others "
                   "leave the picture.</p>\n";
}

} // namespace

std::string
reportPage(const Json& report, const std::string& picture_folder)
{
  return head(report) + "<body>\n<header>\n<h1>" + titleOf(report) + "</h1>\n" +
         origin(report) + "</header>\n<main>\n" + resultParagraph(report) +
         warningBox(report) + commandLine(report) + truthTable(report) +
         pictures(report, picture_folder) + energies(report) + planesTable(report) +
         secondsTable(report) + summaryTables(report) + "</main>\n</body>\n</html>\n";
}

void
saveReportPage(const std::string& path,
               const Json& report,
               const std::string& picture_folder)
{
  const std::string page = reportPage(report, picture_folder);
  OutputFile file(path);
  file.write(page.data(), page.size());
  file.commit();
}

} // namespace pcl::acmap
