#include <pcl/core/carmen_log.h>
#include <pcl/core/exceptions.h>

#include "files/byte_source.h"
#include "files/carmen_reader.h"
#include "files/text_number.h"

#include <pcl/core/impl/arguments.h>
#include <pcl/core/output_file.h>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <locale>
#include <new>
#include <set>
#include <sstream>
#include <vector>

namespace pcl::acmap {

namespace {

constexpr std::size_t max_unpacked = std::size_t{1} << 30;
constexpr std::size_t chunk = std::size_t{1} << 16;

class Inflater {
public:
  explicit Inflater(const ByteSource& source)
  : source_(source)
  {
    constexpr int largest_window_of_gzip = 15 + 16;
    if (::inflateInit2(&stream_, largest_window_of_gzip) != Z_OK)
      throw std::bad_alloc();
  }

  ~Inflater()
  {
    ::inflateEnd(&stream_);
  }

  Inflater(const Inflater&) = delete;
  Inflater&
  operator=(const Inflater&) = delete;

  void
  append(unsigned char* packed, std::size_t bytes, std::string& text)
  {
    stream_.next_in = packed;
    stream_.avail_in = static_cast<uInt>(bytes);
    do {
      if (at_end_ && ::inflateReset(&stream_) != Z_OK)
        throw std::bad_alloc();
      step(text);
    } while (stream_.avail_in > 0 || (stream_.avail_out == 0 && !at_end_));
  }

  bool
  atEnd() const
  {
    return at_end_;
  }

private:
  void
  step(std::string& text)
  {
    stream_.next_out = unpacked_.data();
    stream_.avail_out = static_cast<uInt>(unpacked_.size());
    const int state = ::inflate(&stream_, Z_NO_FLUSH);
    if (state == Z_MEM_ERROR)
      throw std::bad_alloc();
    if (state != Z_OK && state != Z_STREAM_END && state != Z_BUF_ERROR)
      source_.fail("its compression is damaged");
    at_end_ = state == Z_STREAM_END;
    const std::size_t got = unpacked_.size() - stream_.avail_out;
    if (got > max_unpacked - text.size())
      source_.fail("unpacks to more than 1 GiB");
    text.append(reinterpret_cast<const char*>(unpacked_.data()), got);
  }

  const ByteSource& source_;
  z_stream stream_{};
  std::array<unsigned char, chunk> unpacked_;
  bool at_end_ = false;
};

} // namespace

bool
isGzip(const std::string& path)
{
  ByteSource source(path);
  std::array<unsigned char, 2> magic{};
  if (source.remaining() < magic.size())
    return false;
  source.read(magic.data(), magic.size());
  return magic[0] == 0x1f && magic[1] == 0x8b;
}

std::string
unpackGzip(ByteSource& source)
{
  std::string text;
  Inflater inflater(source);
  std::vector<unsigned char> packed(chunk);
  while (source.remaining() > 0) {
    const auto bytes =
        static_cast<std::size_t>(std::min<std::uint64_t>(chunk, source.remaining()));
    source.read(packed.data(), bytes);
    inflater.append(packed.data(), bytes, text);
  }
  if (!inflater.atEnd())
    source.fail("is truncated: its compression has no end");
  return text;
}

} // namespace pcl::acmap

namespace pcl {

namespace {

using acmap::ByteSource;
using acmap::Words;

constexpr double pi = 3.14159265358979323846;

std::string_view
nextWord(Words& words, std::uint64_t beams, const ByteSource& source)
{
  std::string_view word;
  if (!words.next(word))
    source.failAtLine("announces " + std::to_string(beams) +
                      " beams, and has fewer numbers than these and what follows them");
  return word;
}

template <typename Number>
Number
nextNumber(Words& words, std::uint64_t beams, const ByteSource& source)
{
  const std::string_view word = nextWord(words, beams, source);
  Number value = 0;
  if (!acmap::parseNumber(word, value))
    source.failAtLine(acmap::inQuotes(word) + " is no number");
  return value;
}

constexpr double default_sweep = pi; // radians

// From right to left; an even number of beams excludes the last direction.
double
stepOf(std::size_t beams, double sweep)
{
  return sweep / static_cast<double>(beams % 2 == 1 ? beams - 1 : beams);
}

void
setSweep(PlanarScan& scan, double sweep)
{
  scan.first_angle = sweep / 2;
  scan.angle_step = -stepOf(scan.ranges.size(), sweep);
}

std::uint64_t
readBeams(Words& words, const ByteSource& source)
{
  std::string_view word;
  std::uint64_t beams = 0;
  if (!words.next(word) || !acmap::parseCount(word, beams) || beams < 2)
    source.failAtLine(acmap::inQuotes(word) + " is no number of beams (2 or more)");
  return beams;
}

// The number of beams is not trusted: memory is only allocated for numbers that exist.
PlanarScan
readRanges(Words& words, std::uint64_t beams, const ByteSource& source)
{
  PlanarScan scan;
  scan.maximum_range = std::numeric_limits<float>::infinity();
  for (std::uint64_t i = 0; i < beams; ++i)
    scan.ranges.push_back(nextNumber<float>(words, beams, source));
  return scan;
}

// Sets the pose of the laser x y theta, and the stamp.
void
setPose(PlanarScan& scan,
        double x,
        double y,
        double theta,
        double stamp,
        const ByteSource& source)
{
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(theta))
    source.failAtLine("its pose is not finite");
  if (!std::isfinite(stamp))
    source.failAtLine("its stamp is not finite");
  scan.pose = {0.0 - y, x, 0.0 - theta}; // 0 - 0 avoids -0
  scan.stamp = stamp;
}

// Reads the rest of a line after FLASER, but not the sweep.
PlanarScan
readScan(Words& words, const ByteSource& source)
{
  const std::uint64_t beams = readBeams(words, source);
  PlanarScan scan = readRanges(words, beams, source);
  // x y theta of the laser, the same of the odometry, stamp
  std::array<double, 7> tail{};
  for (double& value : tail)
    value = nextNumber<double>(words, beams, source);
  setPose(scan, tail[0], tail[1], tail[2], tail[6], source);
  return scan;
}

// Reads the rest of a line after ROBOTLASER1.
PlanarScan
readRobotScan(Words& words, const ByteSource& source)
{
  // type, first angle, sweep, step, maximum range, accuracy, kind of remissions
  std::array<double, 7> head{};
  for (double& value : head)
    value = nextNumber<double>(words, 0, source);
  const std::uint64_t beams = readBeams(words, source);
  PlanarScan scan = readRanges(words, beams, source);
  std::uint64_t remissions = 0;
  if (!acmap::parseCount(nextWord(words, beams, source), remissions))
    source.failAtLine("its number of remissions is no number");
  for (std::uint64_t i = 0; i < remissions; ++i)
    nextWord(words, beams, source);
  // x y theta of the laser, the same of the robot, its two speeds, three lengths, stamp
  std::array<double, 12> tail{};
  for (double& value : tail)
    value = nextNumber<double>(words, beams, source);
  setPose(scan, tail[0], tail[1], tail[2], tail[11], source);
  const double step =
      head[3] != 0 ? head[3] : head[2] / (static_cast<double>(beams) - 1);
  if (!std::isfinite(head[1]) || !std::isfinite(step) || step == 0)
    source.failAtLine("its beams have no angles");
  scan.first_angle = 0.0 - head[1];
  scan.angle_step = 0.0 - step;
  if (head[4] > 0)
    scan.maximum_range = static_cast<float>(head[4]);
  return scan;
}

// The sweep that a parameter of a log states, in degrees or radians.
std::optional<double>
sweepOfParameter(Words& words)
{
  std::string_view name, word;
  double value = 0;
  if (!words.next(name) || name != "laser_front_laser_fov" || !words.next(word) ||
      !acmap::parseNumber(word, value) || !(value > 0 && value <= 360))
    return {};
  return value > 2 * pi ? value * pi / 180 : value;
}

std::string
degreesText(double radians)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(3);
  text << radians * 180 / pi;
  return text.str();
}

bool
isStepOf(double step, const std::initializer_list<double>& degrees)
{
  return std::any_of(degrees.begin(), degrees.end(), [&](double known) {
    return std::abs(step * 180 / pi - known) < 0.01 * known;
  });
}

// The sweep of common lasers that have another one than the default, by their number of
// beams; degrees, 0: none
int
otherSweepOf(std::size_t beams)
{
  struct Laser {
    std::size_t beams;
    int sweep;
  };
  constexpr std::array<Laser, 10> lasers = {{{271, 270},
                                             {541, 270},
                                             {811, 270},
                                             {1081, 270},
                                             {682, 240},
                                             {683, 240},
                                             {726, 240},
                                             {101, 100},
                                             {201, 100},
                                             {401, 100}}};
  for (const Laser& laser : lasers)
    if (laser.beams == beams)
      return laser.sweep;
  return 0;
}

// What a log has instead of scans, for a message.
class MessageKinds {
public:
  void
  add(std::string_view kind)
  {
    constexpr std::size_t most = 8;
    if (kinds_.size() < most)
      kinds_.insert(acmap::inPrint(kind, 20));
  }

  std::string
  told() const
  {
    std::string text;
    for (const std::string& kind : kinds_)
      text += (text.empty() ? ", but " : ", ") + kind;
    return text + (kinds_.count("RAWLASER1") > 0 ? ": scans without poses" : "");
  }

private:
  std::set<std::string> kinds_;
};

// Sets the beams of FLASER messages, and tells what is odd of them.
class Sweeps {
public:
  explicit Sweeps(std::optional<double> stated)
  : stated_(stated)
  , is_given_(stated.has_value())
  {}

  void
  takeParameter(Words& words)
  {
    if (const auto sweep = sweepOfParameter(words); sweep && !is_given_)
      stated_ = sweep;
  }

  void
  set(PlanarScan& scan, CarmenLog& log, const ByteSource& source)
  {
    const std::size_t beams = scan.ranges.size();
    const int other = otherSweepOf(beams);
    if (!stated_ && other > 0)
      source.failAtLine(std::to_string(beams) +
                        " beams are those of lasers that sweep " +
                        std::to_string(other) +
                        " degrees, not 180, and no PARAM laser_front_laser_fov states "
                        "it: --laser-fov " +
                        std::to_string(other) + " or --laser-fov 180 does");
    log.sweep = stated_.value_or(default_sweep);
    log.is_sweep_stated = stated_.has_value();
    setSweep(scan, log.sweep);
    if (beams == told_beams_)
      return;
    told_beams_ = beams;
    const double step = -scan.angle_step;
    const bool is_usual =
        isStepOf(step, {1, 0.5, 0.25}) ||
        (stated_ && isStepOf(step, {2, 1.0 / 3, 1.0 / 6, 0.36, 360.0 / 1024, 0.125}));
    if (!is_usual && log.remarks.empty())
      log.remarks.push_back(source.name() + ": " + std::to_string(beams) +
                            " beams in " + degreesText(log.sweep) + " degrees are " +
                            degreesText(step) +
                            " degrees apart, as of no common laser; --laser-fov states "
                            "another sweep");
  }

private:
  std::optional<double> stated_;
  bool is_given_;
  std::size_t told_beams_ = 0;
};

/** x y theta of a log: x forward, y left, theta counter-clockwise. */
void
writePose(const PlanarPose& pose, std::ostream& text)
{
  text << ' ' << pose.z << ' ' << 0.0 - pose.x << ' ' << 0.0 - pose.theta;
}

/** What precedes the number of beams in a ROBOTLASER1 message. */
void
writeRobotHead(const PlanarScan& scan, std::ostream& text)
{
  const double sweep =
      std::abs(scan.angle_step) * static_cast<double>(scan.ranges.size() - 1);
  const float range = std::isfinite(scan.maximum_range) ? scan.maximum_range : 0;
  text << "ROBOTLASER1 0 " << 0.0 - scan.first_angle << ' ' << sweep << ' '
       << 0.0 - scan.angle_step << ' ' << range << " 0 0 ";
}

void
writeScan(const PlanarScan& scan, const PlanarPose& odometry, std::ostream& text)
{
  const std::size_t beams = scan.ranges.size();
  if (beams < 2 || !std::isfinite(scan.first_angle) ||
      !std::isfinite(scan.angle_step) || scan.angle_step == 0)
    throw acmap::BadArgument(
        "a scan of a CARMEN log has two beams or more, whose angles "
        "are finite and differ");
  const bool is_robot_scan = otherSweepOf(beams) > 0 ||
                             scan.first_angle != default_sweep / 2 ||
                             scan.angle_step != -stepOf(beams, default_sweep);
  text.precision(std::numeric_limits<double>::max_digits10);
  if (is_robot_scan)
    writeRobotHead(scan, text);
  else
    text << "FLASER ";
  text << beams;
  text.precision(std::numeric_limits<float>::max_digits10);
  for (const float range : scan.ranges)
    text << ' ' << range;
  text.precision(std::numeric_limits<double>::max_digits10);
  if (is_robot_scan)
    text << " 0"; // no remissions
  writePose(scan.pose, text);
  writePose(odometry, text);
  if (is_robot_scan)
    text << " 0 0 0 0 0"; // speeds and lengths of the robot
  text << ' ' << scan.stamp << " acmap " << scan.stamp << '\n';
}

} // namespace

void
saveCarmenLog(const std::string& path,
              const std::vector<PlanarScan>& scans,
              const std::vector<PlanarPose>& odometry)
{
  if (!odometry.empty() && odometry.size() != scans.size())
    throw acmap::BadArgument(std::to_string(odometry.size()) +
                             " poses of odometry for " + std::to_string(scans.size()) +
                             " scans");
  acmap::OutputFile file(path);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    writeScan(scans[i], odometry.empty() ? scans[i].pose : odometry[i], text);
    const std::string line = text.str();
    file.write(line.data(), line.size());
  }
  file.commit();
}

CarmenLog
acmap::readCarmenLog(ByteSource& source, std::optional<double> sweep)
{
  CarmenLog log;
  Sweeps sweeps(sweep);
  std::vector<PlanarScan> robot_scans;
  MessageKinds others;
  for (std::string_view line; source.readLine(line);) {
    Words words(line);
    std::string_view kind;
    if (!words.next(kind) || kind.front() == '#')
      continue;
    if (kind == "FLASER") {
      log.scans.push_back(readScan(words, source));
      sweeps.set(log.scans.back(), log, source);
      continue;
    }
    if (kind == "PARAM")
      sweeps.takeParameter(words);
    if (kind == "ROBOTLASER1" && log.scans.empty())
      robot_scans.push_back(readRobotScan(words, source));
    else {
      ++log.other_messages;
      others.add(kind);
    }
  }
  if (log.scans.empty())
    log.scans = std::move(robot_scans); // otherwise they are the same scans again
  else
    log.other_messages += robot_scans.size();
  if (log.scans.empty())
    source.fail("has no FLASER message and no ROBOTLASER1 message" + others.told());
  excludeMissingEchoes(log.scans);
  return log;
}

CarmenLog
loadCarmenLog(const std::string& path, std::optional<double> sweep)
{
  if (sweep && !(*sweep > 0 && *sweep <= 2 * pi))
    acmap::refuseArgument("sweep", *sweep, "within (0, 2 pi] radians");
  const bool packed = acmap::isGzip(path);
  ByteSource file(path);
  if (!packed)
    return acmap::readCarmenLog(file, sweep);
  const std::string text = acmap::unpackGzip(file);
  ByteSource unpacked(path, text.data(), text.size());
  return acmap::readCarmenLog(unpacked, sweep);
}

} // namespace pcl
