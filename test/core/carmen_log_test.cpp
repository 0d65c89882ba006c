#include "messages.h"
#include "temporary_folder.h"
#include "test_data.h"

#include <pcl/core/carmen_log.h>
#include <pcl/core/random.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

constexpr double pi = 3.14159265358979323846;

std::string
textOf(double value)
{
  std::ostringstream text;
  text.precision(17);
  text << value;
  return text.str();
}

/** A FLASER message whose odometry differs from its pose. */
std::string
message(
    const std::vector<float>& ranges, double x, double y, double theta, double stamp)
{
  std::string line = "FLASER " + std::to_string(ranges.size());
  for (const float range : ranges)
    line += " " + textOf(range);
  for (const double value : {x, y, theta, x + 7, y - 7, theta + 1, stamp})
    line += " " + textOf(value);
  return line + " host " + textOf(stamp + 100) + "\n";
}

std::vector<float>
randomRanges(std::size_t beams, Random& random)
{
  std::vector<float> ranges;
  for (std::size_t i = 0; i < beams; ++i)
    ranges.push_back(static_cast<float>(1 + 9 * random.uniform()));
  return ranges;
}

std::string
gzipped(const std::string& text)
{
  std::string packed(::compressBound(text.size()) + 64, '\0');
  z_stream stream{};
  if (::deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("deflateInit2");
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const bool done = ::deflate(&stream, Z_FINISH) == Z_STREAM_END;
  packed.resize(stream.total_out);
  ::deflateEnd(&stream);
  if (!done)
    throw std::runtime_error("deflate");
  return packed;
}

CarmenLog
logOf(const std::string& bytes)
{
  const TemporaryFolder folder;
  return loadCarmenLog(folder.write("a log", bytes));
}

std::string
faultOf(const std::string& bytes)
{
  return messageOf<InputFileException>([&] { logOf(bytes); });
}

struct Written {
  std::vector<std::vector<float>> ranges;
  std::string text;
};

Written
writeLog(std::size_t scans)
{
  Random random(3);
  Written log;
  log.text = "# a comment\nPARAM robot_length 0.5 0 host 0\n\n";
  for (std::size_t i = 0; i < scans; ++i) {
    const auto number = static_cast<double>(i);
    log.ranges.push_back(randomRanges(i % 2 == 0 ? 180 : 361, random));
    log.text += "ODOM 0 0 0 0 0 0 1 host 1\n";
    log.text += message(log.ranges.back(),
                        0.25 * number,
                        3 - number,
                        0.1 * number,
                        1e9 + 0.125 * number);
  }
  return log;
}

void
expectRead(const Written& log, const std::string& bytes)
{
  const CarmenLog read = logOf(bytes);
  EXPECT_EQ(read.other_messages, 1 + log.ranges.size());
  ASSERT_EQ(read.scans.size(), log.ranges.size());
  for (std::size_t i = 0; i < read.scans.size(); ++i) {
    const PlanarScan& scan = read.scans[i];
    const auto number = static_cast<double>(i);
    EXPECT_EQ(scan.ranges, log.ranges[i]);
    EXPECT_EQ(scan.pose.x, number - 3); // y points to the left
    EXPECT_EQ(scan.pose.z, 0.25 * number);
    EXPECT_EQ(scan.pose.theta, -0.1 * number);
    EXPECT_EQ(scan.stamp, 1e9 + 0.125 * number);
    for (const float range : scan.ranges)
      EXPECT_LT(range, scan.maximum_range);
  }
}

TEST(CarmenLog, SurvivesItsFilePlainAndPacked)
{
  const Written log = writeLog(20);
  expectRead(log, log.text);
  expectRead(log, gzipped(log.text));
  const std::size_t half = log.text.find("\nODOM", log.text.size() / 2) + 1;
  expectRead(log, gzipped(log.text.substr(0, half)) + gzipped(log.text.substr(half)));
}

TEST(CarmenLog, LineEndsOfWindowsAndAMissingLastOneAreRead)
{
  Written log = writeLog(3);
  log.text.pop_back();
  expectRead(log, log.text);
  std::string windows;
  for (const char c : log.text)
    windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expectRead(log, windows + "\r\n");
}

/** Position of a beam's echo in the map. */
Eigen::Vector3d
echoOf(const PlanarScan& scan, std::size_t beam)
{
  const double angle = scan.first_angle + static_cast<double>(beam) * scan.angle_step;
  const double range = scan.ranges[beam];
  return isometryOf(scan.pose) *
         Eigen::Vector3d(range * std::sin(angle), 0, range * std::cos(angle));
}

TEST(CarmenLog, BeamsSweepFromTheRightToTheLeft)
{
  // At (10, 20), rotated to the left by 90 degrees: ahead is +y, right is +x.
  for (const std::size_t beams : {180, 181, 360, 361}) {
    const CarmenLog log =
        logOf(message(std::vector<float>(beams, 2.0F), 10, 20, pi / 2, 0));
    const PlanarScan& scan = log.scans.at(0);
    const auto inMap = [](double x, double y) { return Eigen::Vector3d(-y, 0, x); };
    EXPECT_TRUE(echoOf(scan, 0).isApprox(inMap(12, 20), 1e-12)) << beams;
    EXPECT_TRUE(echoOf(scan, beams / 2).isApprox(inMap(10, 22), 1e-12)) << beams;
    const Eigen::Vector3d last = echoOf(scan, beams - 1);
    EXPECT_EQ(last.isApprox(inMap(8, 20), 1e-12), beams % 2 == 1) << beams;
  }
}

TEST(CarmenLog, ReadingsWithoutEchoAreBeyondTheMaximum)
{
  Random random(9);
  std::string text;
  for (int i = 0; i < 60; ++i) {
    std::vector<float> ranges = randomRanges(180, random);
    for (std::size_t beam = 0; beam < 5; ++beam)
      ranges[beam] = 51.05F + 0.01F * static_cast<float>(beam);
    ranges[20] = i == 4 ? 2200.0F : ranges[20]; // an outlier
    text += message(ranges, i, 0, 0, i);
  }
  const float maximum = logOf(text).scans.at(0).maximum_range;
  EXPECT_LT(maximum, 51.05F);
  EXPECT_GT(maximum, 50.0F);
}

TEST(CarmenLog, FarWallsAreNoMissingEchoes)
{
  // A square room seen from its centre: the corners are the farthest points.
  std::vector<float> ranges;
  for (int i = 0; i < 180; ++i) {
    const double angle = (i - 90) * pi / 180;
    ranges.push_back(static_cast<float>(
        5 / std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle)))));
  }
  std::string text;
  for (int i = 0; i < 50; ++i)
    text += message(ranges, 0, 0, 0, i);
  EXPECT_GT(logOf(text).scans.at(0).maximum_range,
            *std::max_element(ranges.begin(), ranges.end()));
}

TEST(CarmenLog, RangesThatAreNoNumbersAreKept)
{
  const CarmenLog log = logOf(
      "FLASER 4 nan 1.5 inf -1 0 0 0 0 0 0 5 host 5\nFLASER 2 nan nan 0 0 0 0 0 0 6 "
      "host 6\n");
  ASSERT_EQ(log.scans.size(), 2U);
  const PlanarScan& scan = log.scans[0];
  EXPECT_TRUE(std::isnan(scan.ranges.at(0)));
  EXPECT_EQ(scan.ranges.at(1), 1.5F);
  EXPECT_EQ(scan.ranges.at(2), std::numeric_limits<float>::infinity());
  EXPECT_EQ(scan.ranges.at(3), -1.0F);
  EXPECT_GT(scan.maximum_range, 1.5F);
  EXPECT_LT(scan.maximum_range, 2.0F);
  EXPECT_EQ(logOf("FLASER 2 nan -1 0 0 0 0 0 0 6 host 6\n").scans[0].maximum_range, 0);
}

TEST(CarmenLog, FaultsAreNamedWithTheirLine)
{
  const std::string good = message({1, 2, 3}, 0, 0, 0, 0);
  EXPECT_THAT(faultOf(good + "FLASER 3 1 2 3 0 0 0 0 0 0\n"),
              HasSubstr("a log: line 2: announces 3 beams, and has fewer numbers"));
  EXPECT_THAT(faultOf("\nFLASER 1000000000000000000 1 2 3 0 0 0 0 0 0 0 \n"),
              HasSubstr("line 2: announces 1000000000000000000 beams"));
  EXPECT_THAT(faultOf("FLASER 8 1 2 3 0 0 0 0 0 0 1 host 1\n"),
              HasSubstr("line 1: 'host' is no number"));
  EXPECT_THAT(faultOf("FLASER 2 1 2 x 0 0 0 0 0 0 h 0\n"),
              HasSubstr("'x' is no number"));
  EXPECT_THAT(faultOf("FLASER 2 1 2 nan 0 0 0 0 0 0 h 0\n"), HasSubstr("its pose"));
  EXPECT_THAT(faultOf("FLASER 2 1 2 0 0 inf 0 0 0 0 h 0\n"), HasSubstr("its pose"));
  EXPECT_THAT(faultOf("FLASER 2 1 2 0 0 0 0 0 0 nan h 0\n"), HasSubstr("its stamp"));
  for (const char* count : {"0", "1", "-3", "2.5", "1e18", "99999999999999999999", "x"})
    EXPECT_THAT(faultOf("FLASER " + std::string(count) + " 1 2 3 4 5 6 7 8 9 h 0\n"),
                HasSubstr("is no number of beams"));
  EXPECT_THAT(faultOf("FLASER\n"), HasSubstr("is no number of beams"));
}

TEST(CarmenLog, FilesWithoutScansAreRefused)
{
  EXPECT_THAT(faultOf(""), HasSubstr("is empty"));
  EXPECT_THAT(faultOf("F"), HasSubstr("has no FLASER"));
  EXPECT_THAT(faultOf("# FLASER 2 1 2 0 0 0 0 0 0 0 h 0\nODOM 0 0\n"),
              HasSubstr("has no FLASER message"));
  EXPECT_THAT(
      faultOf("ODOM 1 2 3 0 0 0 4 h 4\nRAWLASER1 0 1\nRAWLASER1 0 2\n"),
      HasSubstr("ROBOTLASER1 message, but ODOM, RAWLASER1: scans without poses"));
  EXPECT_THAT(faultOf(gzipped("")), HasSubstr("is empty"));
  Random random(1);
  std::string garbage;
  for (int i = 0; i < 300000; ++i)
    garbage += static_cast<char>(random.bits());
  EXPECT_FALSE(faultOf(garbage).empty());
  EXPECT_THAT(faultOf(std::string(300000, '\0')), HasSubstr("too long for a line"));
  const TemporaryFolder folder;
  EXPECT_THROW(loadCarmenLog(folder.path("missing")), InputFileException);
  EXPECT_THROW(loadCarmenLog(folder.path("")), InputFileException);
}

TEST(CarmenLog, DamagedCompressionIsNamed)
{
  const std::string packed = gzipped(writeLog(6).text);
  for (const std::size_t size : {std::size_t{2}, packed.size() / 2, packed.size() - 1})
    EXPECT_THAT(faultOf(packed.substr(0, size)), HasSubstr("is truncated")) << size;
  EXPECT_THAT(faultOf("\x1f\x8b" + std::string(500, 'x')), HasSubstr("is damaged"));
  EXPECT_THAT(faultOf(packed + "more"), HasSubstr("is damaged"));
  constexpr std::size_t header = 10; // contains optional metadata such as a time stamp
  for (std::size_t at = header; at < packed.size(); at += 97) {
    std::string changed = packed;
    changed[at] = static_cast<char>(~changed[at]);
    EXPECT_FALSE(faultOf(changed).empty()) << at;
  }
}

TEST(CarmenLog, IsReadAsItWasWritten)
{
  const TemporaryFolder folder;
  const std::string path = folder.path("corrected.log");
  Random random(4);
  std::string text;
  for (int i = 0; i < 5; ++i)
    text += message(randomRanges(180 + static_cast<std::size_t>(i), random),
                    random.normal(),
                    random.normal(),
                    random.normal(),
                    1e9 + i / 7.0);
  const CarmenLog log = loadCarmenLog(folder.write("given.log", text));
  const std::vector<PlanarPose> odometry(log.scans.size(), PlanarPose{1, 2, 3});
  for (const auto& beside : {std::vector<PlanarPose>(), odometry}) {
    saveCarmenLog(path, log.scans, beside);
    const CarmenLog again = loadCarmenLog(path);
    ASSERT_EQ(again.scans.size(), log.scans.size());
    EXPECT_EQ(again.other_messages, 0U);
    for (std::size_t i = 0; i < log.scans.size(); ++i) {
      EXPECT_EQ(again.scans[i].ranges, log.scans[i].ranges);
      EXPECT_EQ(again.scans[i].stamp, log.scans[i].stamp);
      EXPECT_EQ(again.scans[i].pose.x, log.scans[i].pose.x);
      EXPECT_EQ(again.scans[i].pose.z, log.scans[i].pose.z);
      EXPECT_EQ(again.scans[i].pose.theta, log.scans[i].pose.theta);
    }
  }
  EXPECT_THAT(contentOf(path), HasSubstr(" 2 -1 -3 ")) << "the odometry";
  EXPECT_THROW(saveCarmenLog(path, log.scans, {PlanarPose()}), BadArgumentException);
  PlanarScan still = log.scans[0];
  still.angle_step = 0;
  EXPECT_THROW(saveCarmenLog(path, {still}), BadArgumentException);
  PlanarScan turned = log.scans[0];
  turned.first_angle = -0.75;
  turned.angle_step = 0.25;
  saveCarmenLog(path, {turned}, {PlanarPose{1, 2, 3}});
  EXPECT_THAT(contentOf(path), HasSubstr("ROBOTLASER1 0 0.75 44.75 -0.25 "));
  const CarmenLog again = loadCarmenLog(path);
  ASSERT_EQ(again.scans.size(), 1U);
  EXPECT_EQ(again.scans[0].first_angle, turned.first_angle);
  EXPECT_EQ(again.scans[0].angle_step, turned.angle_step);
  EXPECT_EQ(again.scans[0].ranges, turned.ranges);
  EXPECT_EQ(again.scans[0].pose.x, turned.pose.x);
  EXPECT_EQ(again.scans[0].stamp, turned.stamp);
  EXPECT_THROW(saveCarmenLog(folder.path("none/log"), log.scans), OutputFileException);
}

/** A scan of n beams of 2 m. */
std::string
beamsOf(std::size_t n)
{
  return message(std::vector<float>(n, 2.0F), 0, 0, 0, 0);
}

TEST(CarmenLog, TheSweepMayBeStated)
{
  const CarmenLog assumed = logOf(beamsOf(361));
  EXPECT_EQ(assumed.sweep, pi);
  EXPECT_FALSE(assumed.is_sweep_stated);
  EXPECT_TRUE(assumed.remarks.empty());
  for (const char* value : {"270.0", "4.71238898038469"}) {
    const CarmenLog log = logOf("PARAM laser_front_laser_fov " + std::string(value) +
                                " 0 host 0\n" + beamsOf(541));
    EXPECT_NEAR(log.scans[0].first_angle, 0.75 * pi, 1e-12) << value;
    EXPECT_NEAR(log.scans[0].angle_step, -pi / 360, 1e-12);
    EXPECT_TRUE(log.is_sweep_stated);
    EXPECT_TRUE(log.remarks.empty());
  }
  EXPECT_THAT(
      logOf("PARAM laser_front_laser_fov 270 0 host 0\n" + beamsOf(361)).remarks,
      testing::ElementsAre(HasSubstr("361 beams in 270 degrees are 0.75")));
  EXPECT_THAT(logOf(beamsOf(150)).remarks, testing::SizeIs(1));
  EXPECT_THAT(
      faultOf(beamsOf(541)),
      testing::AllOf(HasSubstr("sweep 270 degrees"), HasSubstr("--laser-fov 270")));
  const TemporaryFolder folder;
  const std::string path = folder.write("log", beamsOf(541));
  EXPECT_NEAR(loadCarmenLog(path, pi).scans[0].angle_step, -pi / 540, 1e-12);
  EXPECT_THROW(loadCarmenLog(path, 0.0), BadArgumentException);
  EXPECT_THROW(loadCarmenLog(path, 7.0), BadArgumentException);
}

constexpr const char* robot_scan = "ROBOTLASER1 0 -1.5 3 0.5 30 0.01 0 3 1 2 80 1 7 4 "
                                   "5 0.25 8 9 10 0 0 0 0 0 12.5 host "
                                   "0.5\n";

TEST(CarmenLog, RobotLaserMessagesHaveTheirAngles)
{
  const CarmenLog log = logOf(robot_scan);
  ASSERT_EQ(log.scans.size(), 1U);
  const PlanarScan& scan = log.scans[0];
  EXPECT_EQ(scan.ranges, (std::vector<float>{1, 2, 80}));
  EXPECT_EQ(scan.first_angle, 1.5);
  EXPECT_EQ(scan.angle_step, -0.5);
  EXPECT_EQ(scan.pose.x, -5);
  EXPECT_EQ(scan.pose.z, 4);
  EXPECT_EQ(scan.pose.theta, -0.25);
  EXPECT_EQ(scan.stamp, 12.5);
  EXPECT_GT(scan.maximum_range, 2);
  EXPECT_LE(scan.maximum_range, 30);
  EXPECT_EQ(log.sweep, 0);
  // beside FLASER they are the same scans again
  const CarmenLog both = logOf(robot_scan + beamsOf(180) + robot_scan);
  EXPECT_EQ(both.scans.size(), 1U);
  EXPECT_EQ(both.other_messages, 2U);
  const std::string line = robot_scan;
  const std::size_t end = line.find(" host");
  for (std::size_t length = line.rfind(' ', end - 1); length > 15;
       length = line.rfind(' ', length - 1))
    EXPECT_FALSE(faultOf(line.substr(0, length)).empty()) << length;
  EXPECT_THAT(
      faultOf("ROBOTLASER1 0 -1.5 0 0 30 0 0 2 1 2 0 0 0 0 0 0 0 0 0 0 0 0 1\n"),
      HasSubstr("have no angles"));
}

TEST(CarmenLog, ARobotLaserLogOfOthers)
{
  const std::string name = "H_field/recordings/robotlaser1.log.gz";
  if (!hasTestData(name))
    GTEST_SKIP() << name << " is not in the folder that ACMAP_TEST_DATA names";
  const CarmenLog log = loadCarmenLog(testDataPath(name).string());
  EXPECT_EQ(log.scans.size(), 686U);
  for (const PlanarScan& scan : log.scans) {
    EXPECT_EQ(scan.ranges.size(), 361U);
    EXPECT_EQ(scan.first_angle, 1.570796);
    EXPECT_EQ(scan.angle_step, -0.008727);
    EXPECT_LE(scan.maximum_range, 80);
  }
}

struct RealLog {
  const char* name;
  std::size_t scans, beams;
  float without_echo; // minimum reading without echo, metres
};

class RealCarmenLog : public testing::TestWithParam<RealLog> {};

TEST_P(RealCarmenLog, IsReadWhole)
{
  const RealLog& expected = GetParam();
  const std::string name =
      "C_sequence/carmen2d/" + std::string(expected.name) + "-corrected.log.gz";
  if (!hasTestData(name))
    GTEST_SKIP() << name << " is not in the folder that ACMAP_TEST_DATA names";
  const CarmenLog log = loadCarmenLog(testDataPath(name).string());
  EXPECT_EQ(log.scans.size(), expected.scans);
  for (const PlanarScan& scan : log.scans) {
    EXPECT_EQ(scan.ranges.size(), expected.beams);
    EXPECT_LE(scan.maximum_range, expected.without_echo);
    EXPECT_GT(scan.maximum_range, 0.98F * expected.without_echo);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Data,
    RealCarmenLog,
    testing::Values(RealLog{"infinite-corridor", 1941, 180, 51.05F},
                    RealLog{"intel", 910, 180, 81.83F},
                    RealLog{"csail", 406, 361, 81.91F},
                    RealLog{"orebro", 237, 181, 32.759F}));

} // namespace
} // namespace pcl::acmap::test
