#include "clouds/e57_scans.h"

#include "files/byte_source.h"

#include <pugixml.hpp>

#include <string>

namespace pcl::acmap {

namespace {

/** \brief The number of an element; one without text is 0. */
double
numberIn(const pugi::xml_node& parent, const char* name)
{
  return parent.child(name).text().as_double(0);
}

/** \throws InputFileException for a pose that is none */
Eigen::Isometry3d
poseIn(const pugi::xml_node& scan, const ByteSource& source)
{
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const pugi::xml_node node = scan.child("pose");
  if (const pugi::xml_node rotation = node.child("rotation")) {
    const Eigen::Quaterniond q(numberIn(rotation, "w"),
                               numberIn(rotation, "x"),
                               numberIn(rotation, "y"),
                               numberIn(rotation, "z"));
    if (!(q.norm() > 0.5 && q.norm() < 2))
      source.fail("a scan has a pose whose rotation is no unit quaternion");
    pose.linear() = q.normalized().toRotationMatrix();
  }
  const pugi::xml_node translation = node.child("translation");
  pose.translation() << numberIn(translation, "x"), numberIn(translation, "y"),
      numberIn(translation, "z");
  if (!pose.translation().allFinite())
    source.fail("a scan has a pose that is no number");
  return pose;
}

std::array<double, 6>
colorLimitsOf(const pugi::xml_node& node, const E57Scan& scan)
{
  std::array<double, 6> limits{};
  const pugi::xml_node given = node.child("colorLimits");
  const char* const names[] = {"colorRed", "colorGreen", "colorBlue"};
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t field = scan.fieldOf(names[c]);
    if (given) {
      limits[2 * c] = numberIn(given, (names[c] + std::string("Minimum")).c_str());
      limits[2 * c + 1] = numberIn(given, (names[c] + std::string("Maximum")).c_str());
    }
    else if (field != E57Scan::none) {
      limits[2 * c] = scan.fields[field].least;
      limits[2 * c + 1] = scan.fields[field].most;
    }
  }
  return limits;
}

E57Scan
scanIn(const pugi::xml_node& node, const E57Pages& pages)
{
  const ByteSource& source = pages.source();
  E57Scan scan;
  const pugi::xml_node points = node.child("points");
  scan.points = points.attribute("recordCount").as_ullong(0);
  scan.section = pages.logical(points.attribute("fileOffset").as_ullong(0));
  scan.fields = e57FieldsIn(points.child("prototype"), source);
  scan.T_map_scan = poseIn(node, source);
  scan.color_limits = colorLimitsOf(node, scan);
  return scan;
}

} // namespace

std::vector<E57Scan>
scansIn(E57Pages& pages)
{
  constexpr std::uint64_t max_expansion = 450; // memory for a byte, as of a packed PCD
  constexpr std::uint64_t point_bytes = 24;
  const ByteSource& source = pages.source();
  const std::string xml = pages.xml();
  pugi::xml_document document;
  if (const auto result = document.load_buffer(xml.data(), xml.size()); !result)
    source.fail("its XML is malformed: " + std::string(result.description()));
  std::vector<E57Scan> scans;
  std::uint64_t points = 0;
  for (const pugi::xml_node& node :
       document.child("e57Root").child("data3D").children("vectorChild")) {
    scans.push_back(scanIn(node, pages));
    if (scans.back().points > max_expansion * source.size() / point_bytes - points)
      source.fail("claims more points than its bytes can have");
    points += scans.back().points;
  }
  if (scans.empty())
    source.fail("has no scan");
  return scans;
}

namespace {

class E57Reader : public ScanReader {
public:
  E57Reader(ByteSource& source, bool verifies)
  : pages_(source)
  {
    if (verifies)
      pages_.requireChecksums();
  }

  std::vector<E57Scan>
  scans() override
  {
    return scansIn(pages_);
  }

  std::unique_ptr<ScanPoints>
  open(const E57Scan& scan) override
  {
    return std::make_unique<E57Points>(scan.fields, scan.section, scan.points, pages_);
  }

  const ByteSource&
  source() const override
  {
    return pages_.source();
  }

private:
  E57Pages pages_;
};

} // namespace

std::unique_ptr<ScanReader>
readerOfE57(ByteSource& source, bool verifies)
{
  return std::make_unique<E57Reader>(source, verifies);
}

} // namespace pcl::acmap
