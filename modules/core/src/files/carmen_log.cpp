#include <pcl/core/carmen_log.h>
#include <pcl/core/exceptions.h>

#include "files/byte_source.h"
#include "files/carmen_reader.h"
#include "files/text_number.h"

#include <pcl/core/output_file.h>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <locale>
#include <new>
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

// From right to left; an even number of beams excludes the last direction.
void
setSweep(PlanarScan& scan)
{
  const std::size_t beams = scan.ranges.size();
  scan.first_angle = pi / 2;
  scan.angle_step = -pi / static_cast<double>(beams % 2 == 1 ? beams - 1 : beams);
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

// Reads the rest of a line after FLASER. The number of beams is not trusted: memory is
// only allocated for numbers that exist.
PlanarScan
readScan(Words& words, const ByteSource& source)
{
  const std::uint64_t beams = readBeams(words, source);
  PlanarScan scan;
  for (std::uint64_t i = 0; i < beams; ++i)
    scan.ranges.push_back(nextNumber<float>(words, beams, source));
  // x y theta of the laser, the same of the odometry, stamp
  std::array<double, 7> tail{};
  for (double& value : tail)
    value = nextNumber<double>(words, beams, source);
  if (!std::isfinite(tail[0]) || !std::isfinite(tail[1]) || !std::isfinite(tail[2]))
    source.failAtLine("its pose is not finite");
  if (!std::isfinite(tail[6]))
    source.failAtLine("its stamp is not finite");
  scan.pose = {0.0 - tail[1], tail[0], 0.0 - tail[2]}; // 0 - 0 avoids -0
  scan.stamp = tail[6];
  setSweep(scan);
  return scan;
}

std::size_t
countBetween(const std::vector<float>& readings, double minimum, double below)
{
  return static_cast<std::size_t>(
      std::count_if(readings.begin(), readings.end(), [=](float reading) {
        return reading >= minimum && reading < below;
      }));
}

/** \brief Finds the reading above which readings are not distances. Lasers report a
 * missing echo by a large value or a few similar ones (SICK: 81.83, 81.87, 81.91 m, or
 * 32.759 to 32.767 m if they count millimetres), so that many beams have the same
 * reading, and hardly any beams a slightly smaller one.
 * \param[in] readings metres, finite, positive; reordered */
float
rangeWithoutEcho(std::vector<float>& readings)
{
  constexpr double width = 0.01; // relative to the reading
  // over the number of slightly smaller readings
  constexpr std::size_t clear_excess = 10;
  constexpr std::size_t beams_to_a_wild_one = 10000;
  if (readings.empty())
    return 0.0F;
  const auto top = readings.end() - 1 - readings.size() / beams_to_a_wild_one;
  std::nth_element(readings.begin(), top, readings.end());
  const double reading = *top;
  const double minimum = (1.0 - width) * reading;
  const std::size_t here =
      countBetween(readings, minimum, std::numeric_limits<double>::infinity());
  const std::size_t less =
      countBetween(readings, (1.0 - 2.0 * width) * reading, minimum);
  if (here > clear_excess * (less + 1))
    return static_cast<float>(minimum);
  return std::nextafter(*std::max_element(top, readings.end()),
                        std::numeric_limits<float>::infinity());
}

void
setMaximumRange(std::vector<PlanarScan>& scans)
{
  std::vector<float> readings;
  for (const PlanarScan& scan : scans)
    std::copy_if(scan.ranges.begin(),
                 scan.ranges.end(),
                 std::back_inserter(readings),
                 [](float range) { return std::isfinite(range) && range > 0.0F; });
  const float maximum = rangeWithoutEcho(readings);
  for (PlanarScan& scan : scans)
    scan.maximum_range = maximum;
}

/** x y theta of a log: x forward, y left, theta counter-clockwise. */
void
writePose(const PlanarPose& pose, std::ostream& text)
{
  text << ' ' << pose.z << ' ' << 0.0 - pose.x << ' ' << 0.0 - pose.theta;
}

void
writeScan(const PlanarScan& scan, const PlanarPose& odometry, std::ostream& text)
{
  PlanarScan as_read = scan;
  setSweep(as_read);
  if (scan.ranges.size() < 2 || as_read.first_angle != scan.first_angle ||
      as_read.angle_step != scan.angle_step)
    throw acmap::BadArgument("the beams of a scan do not sweep 180 degrees from right "
                             "to left, as those of a CARMEN log do");
  text << "FLASER " << scan.ranges.size();
  text.precision(std::numeric_limits<float>::max_digits10);
  for (const float range : scan.ranges)
    text << ' ' << range;
  text.precision(std::numeric_limits<double>::max_digits10);
  writePose(scan.pose, text);
  writePose(odometry, text);
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
acmap::readCarmenLog(ByteSource& source)
{
  CarmenLog log;
  for (std::string_view line; source.readLine(line);) {
    Words words(line);
    std::string_view kind;
    if (!words.next(kind) || kind.front() == '#')
      continue;
    if (kind == "FLASER")
      log.scans.push_back(readScan(words, source));
    else
      ++log.other_messages;
  }
  if (log.scans.empty())
    source.fail("has no FLASER message");
  setMaximumRange(log.scans);
  return log;
}

CarmenLog
loadCarmenLog(const std::string& path)
{
  const bool packed = acmap::isGzip(path);
  ByteSource file(path);
  if (!packed)
    return acmap::readCarmenLog(file);
  const std::string text = acmap::unpackGzip(file);
  ByteSource unpacked(path, text.data(), text.size());
  return acmap::readCarmenLog(unpacked);
}

} // namespace pcl
