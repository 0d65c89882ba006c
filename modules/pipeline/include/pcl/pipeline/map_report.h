#pragma once

#include <pcl/core/export.h>

#include <string>
#include <utility>
#include <vector>

namespace pcl {

struct CompactMap;
struct CompactMappingReport;
struct FloorPlan;

/** \brief The report on a map: the contents of report.json, as a page for a browser and as
 * the last lines of a summary.
 *
 * What a report does not have is left out of both, and a damaged one gives an emptier
 * page.
 * \code
 * pcl::CompactMapping mapping;
 * mapping.setInputCloud (cloud);
 * pcl::CompactMap map;
 * mapping.compute (map);
 * pcl::saveCompactMap ("map", map);
 * const pcl::MapReport report (map, mapping.getReport ());
 * report.savePage ("map/report.html", "map");
 * for (const auto& [name, value] : report.summary ())
 *   std::cout << name << ": " << value << "\n";
 * \endcode
 * \ingroup pipeline */
class ACMAP_EXPORT MapReport {
public:
  /** \param[in] text JSON, as report.json has it
   * \throws BadArgumentException if it is no JSON */
  explicit MapReport(std::string text);

  /** \brief The report of a map that was just made.
   * \param[in] report on this map */
  MapReport(const CompactMap& map, const CompactMappingReport& report);

  /** \brief JSON in one line. */
  const std::string&
  text() const
  {
    return text_;
  }

  /** \brief An HTML page that needs no other file and no network: how good the map is,
   * where it is rough, what was not seen, its pictures, planes and times.
   * \param[in] folder of the map: its pictures become part of the page, other files are
   * linked */
  std::string
  page(const std::string& folder) const;

  /** \brief Writes the \ref page into a file.
   * \throws OutputFileException when it could not be written completely */
  void
  savePage(const std::string& path, const std::string& folder) const;

  /** \brief The lines of a summary, name and value: is the map good, what is in it, how
   * exact is it, and what was not seen. */
  std::vector<std::pair<std::string, std::string>>
  summary() const;

private:
  std::string text_;
};

/** \brief Reads report.json.
 * \throws InputFileException when it cannot be read, or is no JSON \ingroup pipeline */
ACMAP_EXPORT MapReport
loadMapReport(const std::string& path);

namespace acmap {

/** \brief The parts of a map in its report, in the order of map.json: "planes",
 * "rooms", "openings", "cylinders", "boxes", "recesses", and its frame: "up", "tilt_deg",
 * "shift"; metres, a JSON object. */
ACMAP_EXPORT std::string
mapDetailsText(const CompactMap& map);

/** \brief The plan of a map in its report, for the picture of the page: "rooms" and
 * "furniture" (outlines), "walls" (x, y, x, y, plane), "openings" (x, y, x, y), "unseen"
 * (x, y, side of the square; and its role), all in metres of the plan; "axes", the axes of
 * the plan in the map frame; a JSON object.
 * \param[in] plan of this map */
ACMAP_EXPORT std::string
planDetailsText(const CompactMap& map, const FloorPlan& plan);

} // namespace acmap

} // namespace pcl
