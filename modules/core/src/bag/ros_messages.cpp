#include "bag/byte_cursor.h"
#include "clouds/point_cloud_readers.h"
#include "files/byte_source.h"
#include "images/image_codecs.h"

#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/ros_messages.h>
#include <pcl/core/trajectory.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pcl {

namespace acmap {

namespace {

/** \brief Reads a serialized message: numbers of CDR are aligned, those of ROS 1 are not. */
class RosCursor {
public:
  RosCursor(std::string_view bytes,
            const std::string& name,
            RosSerialization serialization)
  : cursor_(bytes, name)
  , is_cdr_(serialization == RosSerialization::Cdr)
  {
    if (!is_cdr_)
      return;
    constexpr std::uint16_t little_endian = 0x0100; // as two bytes in their order
    if (const auto kind = cursor_.number<std::uint16_t>(); kind != little_endian)
      cursor_.fail("is serialized in another way than little-endian CDR");
    cursor_.take(2); // options
  }

  [[noreturn]] void
  fail(const std::string& fault) const
  {
    cursor_.fail(fault);
  }

  template <typename Number>
  Number
  number()
  {
    align(sizeof(Number));
    return cursor_.number<Number>();
  }

  std::uint32_t
  count()
  {
    return number<std::uint32_t>();
  }

  std::string_view
  bytes()
  {
    return cursor_.take(count());
  }

  /** \brief Text; the length of CDR counts its final zero. */
  std::string
  text()
  {
    std::string_view characters = bytes();
    if (is_cdr_ && !characters.empty() && characters.back() == '\0')
      characters.remove_suffix(1);
    return std::string(characters);
  }

  template <int size>
  Eigen::Matrix<double, size, 1>
  numbers()
  {
    Eigen::Matrix<double, size, 1> values;
    for (double& value : values)
      value = number<double>();
    return values;
  }

  RosHeader
  header()
  {
    RosHeader header;
    if (!is_cdr_)
      number<std::uint32_t>(); // number of the message
    header.stamp = is_cdr_ ? static_cast<double>(number<std::int32_t>())
                           : static_cast<double>(number<std::uint32_t>());
    header.stamp += 1e-9 * number<std::uint32_t>();
    header.frame = text();
    return header;
  }

  /** \brief A position and a quaternion x, y, z, w. */
  Eigen::Isometry3d
  pose()
  {
    const Eigen::Vector3d place = numbers<3>();
    const Eigen::Vector4d turn = numbers<4>();
    const double norm = turn.norm();
    if (!place.allFinite() || !(norm > 0.5 && norm < 2))
      fail("has a pose that is no rigid motion");
    Eigen::Isometry3d pose(Eigen::Quaterniond(turn).normalized());
    pose.translation() = place;
    return pose;
  }

private:
  void
  align(std::size_t size)
  {
    if (!is_cdr_)
      return;
    constexpr std::size_t encapsulation = 4; // alignment counts from its end
    const std::size_t over = (cursor_.place() - encapsulation) % size;
    if (over > 0)
      cursor_.take(size - over);
  }

  ByteCursor cursor_;
  bool is_cdr_;
};

/** \brief Bytes of a pixel in raw images of known encodings, and where its colours are. */
struct ColorEncoding {
  const char* name;
  std::size_t bytes;
  std::array<std::size_t, 3> places; ///< of red, green, blue
};

constexpr std::array<ColorEncoding, 8> color_encodings = {{{"rgb8", 3, {0, 1, 2}},
                                                           {"bgr8", 3, {2, 1, 0}},
                                                           {"8UC3", 3, {2, 1, 0}},
                                                           {"rgba8", 4, {0, 1, 2}},
                                                           {"bgra8", 4, {2, 1, 0}},
                                                           {"8UC4", 4, {2, 1, 0}},
                                                           {"mono8", 1, {0, 0, 0}},
                                                           {"8UC1", 1, {0, 0, 0}}}};

bool
contains(const std::string& text, const char* part)
{
  return text.find(part) != std::string::npos;
}

[[noreturn]] void
refuseImage(const std::string& name, const std::string& fault)
{
  throw InputFileException(name + ": " + fault);
}

/** \brief Checks that a raw image has its pixels.
 * \param[in] bytes of a pixel */
void
requirePixels(const RosImage& image, std::size_t bytes, const std::string& name)
{
  try {
    requireImageSize(image.width, image.height, 1, image.data.size() / bytes);
  }
  catch (const DamagedImage& error) {
    refuseImage(name, error.what());
  }
  if (image.row_bytes < bytes * image.width ||
      image.data.size() < std::uint64_t{image.row_bytes} * image.height)
    refuseImage(name,
                "has " + std::to_string(image.data.size()) + " bytes in rows of " +
                    std::to_string(image.row_bytes) + ", too few for " +
                    sizeText(image) + " pixels");
}

/** \brief Calls for each pixel of a raw image with its bytes. */
template <typename Use>
void
forEachPixel(const RosImage& image, std::size_t bytes, const Use& use)
{
  for (std::uint32_t row = 0; row < image.height; ++row) {
    const char* pixel = image.data.data() + std::size_t{row} * image.row_bytes;
    for (std::uint32_t column = 0; column < image.width; ++column, pixel += bytes)
      use(pixel);
  }
}

template <typename Number>
Number
numberAt(const char* place, bool is_big_endian)
{
  std::array<char, sizeof(Number)> bytes;
  std::copy_n(place, bytes.size(), bytes.begin());
  if (is_big_endian)
    std::reverse(bytes.begin(), bytes.end());
  Number number;
  std::memcpy(&number, bytes.data(), sizeof number);
  return number;
}

/** \brief Where red and blue are in a square of two by two pixels of a Bayer pattern, as row
 * times two plus column; green is on the other diagonal. */
struct BayerPattern {
  const char* name;
  std::size_t red, blue;
};

constexpr std::array<BayerPattern, 4> bayer_patterns = {{{"bayer_rggb8", 0, 3},
                                                         {"bayer_bggr8", 3, 0},
                                                         {"bayer_gbrg8", 2, 1},
                                                         {"bayer_grbg8", 1, 2}}};

/** \brief Each pixel gets the colours of its square. */
RgbImage
colorsOfBayer(const RosImage& image,
              const BayerPattern& pattern,
              const std::string& name)
{
  requirePixels(image, 1, name);
  if (image.width < 2 || image.height < 2)
    refuseImage(name, "is too small for a Bayer pattern: " + sizeText(image));
  RgbImage colors{static_cast<std::int32_t>(image.width),
                  static_cast<std::int32_t>(image.height),
                  {}};
  colors.values.reserve(std::size_t{3} * image.width * image.height);
  for (std::uint32_t row = 0; row < image.height; ++row)
    for (std::uint32_t column = 0; column < image.width; ++column) {
      // an odd last row or column belongs to the square before it
      const std::size_t top = std::min(row, image.height - 2) / 2 * 2,
                        left = std::min(column, image.width - 2) / 2 * 2;
      const auto at = [&](std::size_t place) {
        const std::size_t offset =
            (top + place / 2) * image.row_bytes + left + place % 2;
        return static_cast<std::uint8_t>(image.data[offset]);
      };
      const std::size_t green = pattern.red == 0 || pattern.red == 3 ? 1 : 0;
      colors.values.push_back(at(pattern.red));
      colors.values.push_back(
          static_cast<std::uint8_t>((at(green) + at(3 - green) + 1) / 2));
      colors.values.push_back(at(pattern.blue));
    }
  return colors;
}

/** \brief Colours of BT.601 in its limited range, two pixels in four bytes.
 * \param[in] luma place of the first brightness: 0 for Y U Y V, 1 for U Y V Y */
RgbImage
colorsOfYuv422(const RosImage& image, std::size_t luma, const std::string& name)
{
  requirePixels(image, 2, name);
  if (image.width % 2 != 0)
    refuseImage(name, "has an odd width, which YUV 4:2:2 does not allow");
  RgbImage colors{static_cast<std::int32_t>(image.width),
                  static_cast<std::int32_t>(image.height),
                  {}};
  colors.values.reserve(std::size_t{3} * image.width * image.height);
  std::size_t column = 0;
  forEachPixel(image, 2, [&](const char* pixel) {
    const char* const pair = pixel - 2 * (column++ % 2);
    const auto value = [](char byte) {
      return static_cast<double>(static_cast<std::uint8_t>(byte));
    };
    const double y = 1.164 * (value(pixel[luma]) - 16), u = value(pair[1 - luma]) - 128,
                 v = value(pair[3 - luma]) - 128;
    for (const double color : {y + 1.596 * v, y - 0.392 * u - 0.813 * v, y + 2.017 * u})
      colors.values.push_back(
          static_cast<std::uint8_t>(std::lround(std::clamp(color, 0.0, 255.0))));
  });
  return colors;
}

ImageBytes
imageBytes(std::string_view data)
{
  return {data.begin(), data.end()};
}

RgbImage
decodedColors(const RosImage& image, const std::string& name)
{
  const ImageBytes bytes = imageBytes(image.data);
  try {
    if (isPng(bytes))
      return decodePng(bytes);
    if (isJpeg(bytes))
      return decodeJpeg(bytes);
  }
  catch (const DamagedImage& error) {
    refuseImage(name, error.what());
  }
  refuseImage(name, "is compressed as '" + image.encoding + "', JPEG and PNG are read");
}

/** \brief How numbers of a compressed image become depths. */
struct DepthQuantization {
  bool is_inverse = false; ///< metres = a / (number - b); else millimetres
  double a = 0, b = 0;
};

DepthImage
decodedDepths(const RosImage& image, const std::string& name)
{
  std::string_view data = image.data;
  DepthQuantization quantization;
  if (contains(image.encoding, "compressedDepth")) {
    ByteCursor header(data, name);
    header.number<std::int32_t>(); // always the same
    quantization.a = header.number<float>();
    quantization.b = header.number<float>();
    quantization.is_inverse = contains(image.encoding, "32FC1");
    data = header.take(header.remaining());
  }
  const ImageBytes bytes = imageBytes(data);
  if (!isPng(bytes))
    refuseImage(name,
                "is compressed as '" + image.encoding + "', depths are read from PNG");
  GrayImage16 numbers;
  try {
    numbers = decodeGrayPng(bytes);
  }
  catch (const DamagedImage& error) {
    refuseImage(name, error.what());
  }
  DepthImage depths{numbers.width, numbers.height, {}};
  depths.metres.reserve(numbers.values.size());
  for (const std::uint16_t number : numbers.values) {
    const double metres = quantization.is_inverse
                              ? quantization.a / (number - quantization.b)
                              : 0.001 * number;
    const bool is_measured = number > 0 && metres > 0 && std::isfinite(metres);
    depths.metres.push_back(is_measured ? static_cast<float>(metres) : 0.0F);
  }
  return depths;
}

/** \brief The pose of a frame in a frame, both by name, of a transform or an odometry. */
RosTransform
transformOf(RosCursor& cursor)
{
  RosTransform transform;
  transform.header = cursor.header();
  transform.child = cursor.text();
  transform.T_parent_child = cursor.pose();
  return transform;
}

/** \brief The fields of a cloud as those of a record without gaps. */
std::vector<SourceField>
fieldsOfRecord(std::vector<PCLPointField> fields,
               std::uint32_t point_step,
               const RosCursor& cursor)
{
  std::stable_sort(fields.begin(), fields.end(), [](const auto& a, const auto& b) {
    return a.offset < b.offset;
  });
  std::vector<SourceField> record;
  std::uint64_t end = 0;
  const auto pad = [&](std::uint64_t begin) {
    if (begin > end)
      record.push_back(
          {"_", PCLPointField::UINT8, static_cast<std::int64_t>(begin - end), 0});
  };
  for (const PCLPointField& field : fields) {
    const std::uint64_t size = sizeOfType(field.datatype);
    if (size == 0)
      cursor.fail("has a field " + field.name.substr(0, 50) + " of unknown type " +
                  std::to_string(field.datatype));
    if (field.offset < end)
      cursor.fail("has fields that overlap");
    pad(field.offset);
    record.push_back(
        {field.name, field.datatype, std::max<std::int64_t>(field.count, 1), 0});
    end = field.offset + size * std::max<std::uint64_t>(field.count, 1);
  }
  if (end > point_step)
    cursor.fail("has fields beyond its points of " + std::to_string(point_step) +
                " bytes");
  pad(point_step);
  return record;
}

} // namespace

} // namespace acmap

bool
RosImage::isDepth() const
{
  return acmap::contains(encoding, "16UC1") || acmap::contains(encoding, "mono16") ||
         acmap::contains(encoding, "32FC1") ||
         acmap::contains(encoding, "compressedDepth");
}

RosHeader
readRosHeader(std::string_view bytes,
              const std::string& name,
              RosSerialization serialization)
{
  return acmap::RosCursor(bytes, name, serialization).header();
}

RosImage
readRosImage(std::string_view bytes,
             const std::string& name,
             RosSerialization serialization)
{
  acmap::RosCursor cursor(bytes, name, serialization);
  RosImage image;
  image.header = cursor.header();
  image.height = cursor.count();
  image.width = cursor.count();
  image.encoding = cursor.text();
  image.is_big_endian = cursor.number<std::uint8_t>() != 0;
  image.row_bytes = cursor.count();
  image.data = cursor.bytes();
  return image;
}

RosImage
readRosCompressedImage(std::string_view bytes,
                       const std::string& name,
                       RosSerialization serialization)
{
  acmap::RosCursor cursor(bytes, name, serialization);
  RosImage image;
  image.is_compressed = true;
  image.header = cursor.header();
  image.encoding = cursor.text();
  image.data = cursor.bytes();
  return image;
}

RosCameraInfo
readRosCameraInfo(std::string_view bytes,
                  const std::string& name,
                  RosSerialization serialization)
{
  acmap::RosCursor cursor(bytes, name, serialization);
  RosCameraInfo info;
  info.header = cursor.header();
  info.height = cursor.count();
  info.width = cursor.count();
  cursor.text(); // name of the model of distortion
  for (std::uint32_t left = cursor.count(); left > 0; --left)
    info.is_distorted |= cursor.number<double>() != 0;
  const Eigen::VectorXd matrix = cursor.numbers<9>();
  info.pinhole = {matrix[0], matrix[4], matrix[2], matrix[5]};
  if (!matrix.allFinite() || !(matrix[0] > 0 && matrix[4] > 0))
    cursor.fail("has no camera: its focal length is not above 0");
  return info;
}

RosCloud
readRosCloud(std::string_view bytes,
             const std::string& name,
             RosSerialization serialization)
{
  acmap::RosCursor cursor(bytes, name, serialization);
  RosCloud read;
  read.header = cursor.header();
  const std::uint64_t height = cursor.count(), width = cursor.count();
  std::vector<PCLPointField> fields;
  const std::uint32_t count = cursor.count();
  if (count > acmap::max_fields)
    cursor.fail("claims " + std::to_string(count) + " fields");
  for (std::uint32_t i = 0; i < count; ++i) {
    PCLPointField field;
    field.name = cursor.text();
    field.offset = cursor.count();
    field.datatype = cursor.number<std::uint8_t>();
    field.count = cursor.count();
    fields.push_back(field);
  }
  const bool is_big_endian = cursor.number<std::uint8_t>() != 0;
  const std::uint32_t point_step = cursor.count();
  const std::uint32_t row_step = cursor.count();
  const std::string_view data = cursor.bytes();
  if (height > 1 && row_step != point_step * width)
    cursor.fail("has rows of " + std::to_string(row_step) + " bytes for " +
                std::to_string(width) + " points of " + std::to_string(point_step));
  if (width * height == 0 || data.empty()) {
    read.cloud = acmap::layoutWith({},
                                   {{"x", PCLPointField::FLOAT32},
                                    {"y", PCLPointField::FLOAT32},
                                    {"z", PCLPointField::FLOAT32}});
    return read;
  }
  acmap::ByteSource source(name, data.data(), data.size());
  const acmap::FieldLayout layout = acmap::planLayout(
      acmap::fieldsOfRecord(std::move(fields), point_step, cursor), source);
  acmap::requirePointsFit(width * height, layout.source_step, source);
  acmap::describeCloud(read.cloud, layout, width, height);
  acmap::CoordinateCheck check(layout.narrows);
  acmap::RecordBlocks(source, layout, is_big_endian)
      .readAll(static_cast<std::size_t>(width * height), read.cloud.data, check);
  PointCloudFile checked;
  checked.cloud = std::move(read.cloud);
  check.finish(checked);
  read.cloud = std::move(checked.cloud);
  return read;
}

RosScan
readRosScan(std::string_view bytes,
            const std::string& name,
            RosSerialization serialization)
{
  acmap::RosCursor cursor(bytes, name, serialization);
  RosScan scan;
  scan.header = cursor.header();
  scan.first_angle = cursor.number<float>();
  cursor.number<float>(); // the last angle
  scan.angle_step = cursor.number<float>();
  cursor.number<float>(); // time between beams
  cursor.number<float>(); // time between scans
  scan.min_range = cursor.number<float>();
  scan.max_range = cursor.number<float>();
  for (std::uint32_t left = cursor.count(); left > 0; --left)
    scan.ranges.push_back(cursor.number<float>());
  if (!std::isfinite(scan.first_angle) || !std::isfinite(scan.angle_step))
    cursor.fail("has beams whose angles are not finite");
  return scan;
}

std::vector<RosTransform>
readRosTransforms(std::string_view bytes,
                  const std::string& name,
                  RosSerialization serialization)
{
  acmap::RosCursor cursor(bytes, name, serialization);
  std::vector<RosTransform> transforms;
  for (std::uint32_t left = cursor.count(); left > 0; --left)
    transforms.push_back(acmap::transformOf(cursor));
  return transforms;
}

RosTransform
readRosOdometry(std::string_view bytes,
                const std::string& name,
                RosSerialization serialization)
{
  acmap::RosCursor cursor(bytes, name, serialization);
  return acmap::transformOf(cursor);
}

RosTransform
readRosPose(std::string_view bytes,
            const std::string& name,
            RosSerialization serialization)
{
  acmap::RosCursor cursor(bytes, name, serialization);
  RosTransform transform;
  transform.header = cursor.header();
  transform.T_parent_child = cursor.pose();
  return transform;
}

std::vector<RosTransform>
readRosPath(std::string_view bytes,
            const std::string& name,
            RosSerialization serialization)
{
  acmap::RosCursor cursor(bytes, name, serialization);
  cursor.header();
  std::vector<RosTransform> poses;
  for (std::uint32_t left = cursor.count(); left > 0; --left) {
    RosTransform pose;
    pose.header = cursor.header();
    pose.T_parent_child = cursor.pose();
    poses.push_back(std::move(pose));
  }
  return poses;
}

Eigen::Isometry3d
readRosBareTransform(std::string_view bytes,
                     const std::string& name,
                     RosSerialization serialization)
{
  return acmap::RosCursor(bytes, name, serialization).pose();
}

double
readRosNumber(std::string_view bytes,
              const std::string& name,
              RosSerialization serialization)
{
  return acmap::RosCursor(bytes, name, serialization).number<float>();
}

RgbImage
colorsOf(const RosImage& image, const std::string& name)
{
  if (image.is_compressed)
    return acmap::decodedColors(image, name);
  for (const acmap::ColorEncoding& encoding : acmap::color_encodings) {
    if (image.encoding != encoding.name)
      continue;
    acmap::requirePixels(image, encoding.bytes, name);
    RgbImage colors{static_cast<std::int32_t>(image.width),
                    static_cast<std::int32_t>(image.height),
                    {}};
    colors.values.reserve(std::size_t{3} * image.width * image.height);
    acmap::forEachPixel(image, encoding.bytes, [&](const char* pixel) {
      for (const std::size_t place : encoding.places)
        colors.values.push_back(static_cast<std::uint8_t>(pixel[place]));
    });
    return colors;
  }
  for (const acmap::BayerPattern& pattern : acmap::bayer_patterns)
    if (image.encoding == pattern.name)
      return acmap::colorsOfBayer(image, pattern, name);
  if (image.encoding == "yuv422" || image.encoding == "uyvy")
    return acmap::colorsOfYuv422(image, 1, name);
  if (image.encoding == "yuv422_yuy2" || image.encoding == "yuyv")
    return acmap::colorsOfYuv422(image, 0, name);
  acmap::refuseImage(
      name,
      "has colours as '" + image.encoding.substr(0, 50) +
          "'; rgb8, bgr8, rgba8, bgra8, mono8, bayer_*8 and yuv422 are read");
}

DepthImage
depthsOf(const RosImage& image, const std::string& name)
{
  if (image.is_compressed)
    return acmap::decodedDepths(image, name);
  const bool is_float = image.encoding == "32FC1";
  if (!is_float && image.encoding != "16UC1" && image.encoding != "mono16")
    acmap::refuseImage(name,
                       "has depths as '" + image.encoding.substr(0, 50) +
                           "'; 16UC1 and 32FC1 are read");
  acmap::requirePixels(image, is_float ? 4 : 2, name);
  DepthImage depths{static_cast<std::int32_t>(image.width),
                    static_cast<std::int32_t>(image.height),
                    {}};
  depths.metres.reserve(std::size_t{image.width} * image.height);
  acmap::forEachPixel(image, is_float ? 4 : 2, [&](const char* pixel) {
    const float metres =
        is_float ? acmap::numberAt<float>(pixel, image.is_big_endian)
                 : 0.001F * acmap::numberAt<std::uint16_t>(pixel, image.is_big_endian);
    depths.metres.push_back(metres > 0 && std::isfinite(metres) ? metres : 0.0F);
  });
  return depths;
}

} // namespace pcl
