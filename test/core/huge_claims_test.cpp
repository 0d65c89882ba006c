#include "sanitized.h"
#include "temporary_folder.h"

#include <pcl/core/carmen_log.h>
#include <pcl/core/disparity_image.h>
#include <pcl/core/image_file.h>
#include <pcl/core/map_file.h>
#include <pcl/core/mesh_file.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/core/rig_calibration.h>
#include <pcl/core/trajectory.h>
#include <pcl/core/trinocular_rig.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/resource.h>

#include <functional>

namespace pcl::acmap::test {
namespace {

/** A short file that claims to contain billions of items. */
struct HugeClaim {
  const char* name; ///< with the extension that its reader requires
  std::string bytes;
  std::function<void(const std::string& path)> read;
};

void
PrintTo(const HugeClaim& claim, std::ostream* stream)
{
  *stream << claim.name;
}

std::string
pcd(const std::string& width,
    const std::string& height,
    const std::string& points,
    const std::string& data,
    const std::string& count = "1")
{
  return "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 " + count +
         "\nWIDTH " + width + "\nHEIGHT " + height + "\nPOINTS " + points + "\nDATA " +
         data + "\n" + std::string(48, '\1');
}

/** Sizes in front of the data of a compressed PCD. */
std::string
compressedPcd(const std::string& packed, const std::string& unpacked)
{
  const std::string text = pcd("300000000", "1", "300000000", "binary_compressed");
  return text.substr(0, text.size() - 48) + packed + unpacked + std::string(16, '\1');
}

std::string
ply(const std::string& vertices, const std::string& faces, const std::string& list)
{
  return "ply\nformat binary_little_endian 1.0\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         faces + "\nproperty list uint int vertex_indices\nend_header\n" +
         std::string(36, '\1') + list + std::string(12, '\0');
}

std::string
png(const std::string& width, const std::string& height)
{
  return "\x89PNG\r\n\x1a\n" + std::string("\0\0\0\rIHDR", 8) + width + height +
         std::string("\x10\0\0\0\0", 5) + std::string(24, '\0');
}

std::string
rig(const std::string& width, const std::string& more)
{
  return "%YAML:1.0\n---\nwidth: " + width +
         "\nheight: 480\nfocal_length: 500\ncenter_x: 3\ncenter_y: 3\n"
         "baseline_horizontal: 0.1\nbaseline_vertical: 0\ndisparity_sigma: 0.1\n" +
         more;
}

std::string
repeated(const std::string& text, std::size_t count)
{
  std::string all;
  all.reserve(count * text.size());
  for (std::size_t i = 0; i < count; ++i)
    all += text;
  return all;
}

std::vector<HugeClaim>
hugeClaims()
{
  const auto cloud = [](const std::string& path) { loadPointCloud(path); };
  const auto mesh = [](const std::string& path) { loadTriangleMesh(path); };
  const auto color = [](const std::string& path) { loadRgbImage(path); };
  const auto grey = [](const std::string& path) { loadGrayImage16(path); };
  const auto disparities = [](const std::string& path) { loadPfm(path); };
  const auto map = [](const std::string& path) { loadMapFile(path); };
  const auto rectified = [](const std::string& path) { loadTrinocularRig(path); };
  const auto log = [](const std::string& path) { loadCarmenLog(path); };
  const auto poses = [](const std::string& path) { loadTrajectory(path); };
  const std::string largest = "18446744073709551615";
  const std::string full(4, '\xff'), half("\xff\xff\xff\x7f");
  return {
      {"ascii.pcd", pcd("4000000000", "1", "4000000000", "ascii"), cloud},
      {"binary.pcd", pcd("4000000000", "1", "4000000000", "binary"), cloud},
      {"wide.pcd", pcd("4294967295", "4294967295", largest, "binary"), cloud},
      {"wraps.pcd", pcd("4294967296", "4294967296", "0", "binary"), cloud},
      {"count.pcd", pcd("4", "1", "4", "binary", "4000000000"), cloud},
      {"packed.pcd", compressedPcd(full, full), cloud},
      {"ratio.pcd",
       compressedPcd(std::string("\x10\0\0\0", 4), "\1\xa4\x93\xd6"),
       cloud},
      {"vertices.ply", ply("4000000000", "1", ""), mesh},
      {"faces.ply", ply("3", "4000000000", ""), mesh},
      {"list.ply", ply("3", "1", full), mesh},
      {"wraps.ply", ply(largest, largest, full), cloud},
      {"far.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 4000000000\n", mesh},
      {"back.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 -4000000000\n", mesh},
      {"wraps.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 4294967299\n", mesh},
      {"largest.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 18446744073709551619\n", mesh},
      {"zero.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 0 1 2\n", mesh},
      {"row.xyz", "4000000000\n", cloud},
      {"wide.png", png(half, std::string("\0\0\0\1", 4)), color},
      {"large.png",
       png(std::string("\0\0\x40\0", 4), std::string("\0\0\x40\0", 4)),
       color},
      {"depth.png", png(half, half), grey},
      {"wide.pgm", "P5\n4000000000 4000000000\n255\n00", color},
      {"wide.ppm", "P6\n65536 4096\n255\n00", color},
      {"wide.pfm", "Pf\n40000 40000\n-1.0\n0000", disparities},
      {"huge.pfm", "Pf\n4000000000 4000000000\n-1.0\n0000", disparities},
      {"beams.log", "FLASER 4000000000 1.0 1.0 0 0 0 0 0 0 1 host 1\n", log},
      {"wraps.log", "FLASER " + largest + " 1.0 1.0 0 0 0 0 0 0 1 host 1\n", log},
      {"number.tum", "1 2 3 4 5 6 7 1e999\n", poses},
      {"wide.yaml", rig("4000000000", ""), rectified},
      {"deep.yaml", rig("640", "a: " + std::string(100000, '[')), rectified},
      {"deepBlock.yaml", rig("640", repeated("- ", 100000)), rectified},
      {"deepMap.yaml", rig("640", "a: " + repeated("{a: ", 100000)), rectified},
      {"many.yaml", rig("640", "a: [" + repeated("1,", 4000000) + "1]\n"), rectified},
      {"aliases.yaml",
       rig("640", "a: &a [1, 1]\nb: &b [*a, *a]\nc: &c [*b, *b]\nd: [*c, *c]\n"),
       rectified},
      {"merge.yaml", rig("640", "<<: *a\n"), rectified},
      {"twice.yaml", rig("640", "width: 640\n"), rectified},
      {"matrix.yaml",
       rig("640",
           "camera_reference:\n  camera_matrix: !!opencv-matrix\n    rows: 4000000000\n"
           "    cols: 4000000000\n    dt: d\n    data: [1]\n"),
       [](const std::string& path) { loadRigCalibration(path); }},
      {"deep.json", std::string(1000000, '['), map},
      {"deepMap.json", "{\"planes\":" + repeated("{\"a\":", 300000), map},
      {"observation.json",
       R"({"planes":[{"id":18446744073709551615,"coefficients":[0,0,1,1]}]})",
       map},
  };
}

class HugeClaims : public testing::TestWithParam<HugeClaim> {};

std::size_t
peakMegabytes()
{
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) / 1024;
}

TEST_P(HugeClaims, AreHeldAgainstTheFile)
{
  const TemporaryFolder folder;
  const std::string path = folder.write(GetParam().name, GetParam().bytes);
  const std::size_t before = peakMegabytes();
  EXPECT_THAT(
      [&] { GetParam().read(path); },
      testing::ThrowsMessage<InputFileException>(testing::HasSubstr(GetParam().name)));
  EXPECT_LT(peakMegabytes(), before + (is_sanitized ? 1000 : 200));
}

INSTANTIATE_TEST_SUITE_P(Files, HugeClaims, testing::ValuesIn(hugeClaims()));

} // namespace
} // namespace pcl::acmap::test
