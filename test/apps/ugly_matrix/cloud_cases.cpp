#include "clouds.h"
#include "input_cases.h"

#include <filesystem>
#include <limits>
#include <sstream>

namespace pcl::acmap::test {
namespace {

/** A cloud as text in PCD format, with all digits of its numbers. */
std::string
pcdOf(const std::vector<Eigen::Vector3d>& points, const std::string& fields = "x y z")
{
  std::ostringstream text;
  text.precision(17);
  text << "VERSION 0.7\nFIELDS " << fields
       << "\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " << points.size()
       << "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " << points.size()
       << "\nDATA ascii\n";
  for (const Eigen::Vector3d& p : points)
    text << p.x() << " " << p.y() << " " << p.z() << "\n";
  return text.str();
}

/** A wall 1 m by 1 m in front of the sensor, with a roughness of 2 mm. */
std::vector<Eigen::Vector3d>
wall()
{
  SheetSampling sampling;
  sampling.columns = sampling.rows = 40;
  sampling.spacing = 0.025;
  sampling.noise = 0.08;
  std::vector<Eigen::Vector3d> points;
  for (const PointXYZ& p : makeJitteredPlane(sampling).cloud)
    points.emplace_back(p.x, p.y, p.z + 2);
  return points;
}

std::vector<Eigen::Vector3d>
changed(const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& change)
{
  std::vector<Eigen::Vector3d> points = wall();
  for (Eigen::Vector3d& p : points)
    p = change(p);
  return points;
}

struct UglyFile {
  Ugliness kind;
  std::string name;
  std::string what;
  std::string bytes;
};

std::vector<UglyFile>
uglyClouds()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Eigen::Vector3d> twice = wall();
  const std::size_t once = twice.size();
  twice.reserve(2 * once);
  std::copy_n(twice.begin(), once, std::back_inserter(twice));
  return {
      {Ugliness::NanOnly, "nan.pcd", nan_points, pcdOf(changed([&](const auto&) {
         return Eigen::Vector3d(nan, nan, nan);
       }))},
      {Ugliness::OnePoint, "one.pcd", one_point, pcdOf({{0, 0, 2}})},
      {Ugliness::Doubled, "doubled.pcd", doubled_points, pcdOf(twice)},
      {Ugliness::WrongFields,
       "fields.pcd",
       "fields `x y intensity`",
       pcdOf(wall(), "x y intensity")},
      {Ugliness::Huge, "vast.pcd", vast_points, pcdOf(changed([](const auto& p) {
         return Eigen::Vector3d(p * 1e30);
       }))},
      {Ugliness::Huge, "far.pcd", far_points, pcdOf(changed([](const auto& p) {
         return Eigen::Vector3d(p * 0.04 + Eigen::Vector3d::Constant(1e8));
       }))},
      {Ugliness::Millimetres,
       "millimetres.pcd",
       millimetre_points,
       pcdOf(changed([](const auto& p) { return Eigen::Vector3d(p * 1000); }))},
  };
}

} // namespace

std::vector<UglyCase>
cloudCases(const CommandFor& command,
           const std::map<std::string, UglyOutcome>& outcomes)
{
  const auto write = [](const std::string& name, const std::string& bytes) {
    return [name, bytes](const TemporaryFolder& folder) { folder.write(name, bytes); };
  };
  const std::string good = "cloud.pcd";
  CaseList list(write(good, pcdOf(wall())), command(good), outcomes);
  list.addFile(good);
  for (const std::string device : {"/dev/zero", "/dev/null"})
    list.addRun(Ugliness::Device, "`" + device + "`", device, command(device));
  for (const UglyFile& file : uglyClouds())
    list.addRun(file.kind,
                file.what,
                file.name,
                command(file.name),
                write(file.name, file.bytes));
  const std::string odd = odd_cloud;
  list.addRun(Ugliness::Names, odd, odd, command(odd), [odd](const auto& folder) {
    std::filesystem::create_directory(folder.path("Messung Nr. 1"));
    folder.write(odd, pcdOf(wall()));
  });
  return list.cases();
}

} // namespace pcl::acmap::test
