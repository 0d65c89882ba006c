#include "frame_codec.h"

#include "image_packing.h"
#include "little_endian.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/file_format.h>
#include <pcl/core/impl/size_text.h>

#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <optional>

namespace pcl::acmap {

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr char magic[] = "ACFRAME\n";
constexpr std::size_t magic_bytes = sizeof(magic) - 1;
constexpr std::size_t checksum_bytes = sizeof(std::uint32_t);
constexpr std::uint64_t max_pixels = std::uint64_t{1} << 28;

std::string
cameraFault(std::size_t camera, const std::string& fault)
{
  return std::string(nameOf(static_cast<RigCamera>(camera))) + " camera: " + fault;
}

std::string
faultOfImage(const ImageRecord& image)
{
  if (image.channels != 1 && image.channels != 3)
    return std::to_string(image.channels) + " channels, 1 or 3 are legal";
  if ((image.width == 0) != (image.height == 0))
    return "an image of " + sizeText(image) + " pixels";
  if (std::uint64_t{image.width} * image.height > max_pixels)
    return sizeText(image) + " pixels, at most 2^28 are legal";
  return "";
}

/** Checks the packing and the number of bytes of an image in a header; empty if they
 * are valid. */
std::string
faultOfPacking(const ImageRecord& image)
{
  if (image.packing > 1)
    return "packing " + std::to_string(image.packing) + " is not known";
  const bool fits =
      image.packing == 0
          ? image.bytes == image.values()
          : image.bytes < image.values() &&
                image.values() / max_values_per_packed_byte <= image.bytes;
  return fits ? ""
              : std::to_string(image.bytes) + " bytes cannot hold " + sizeText(image) +
                    " pixels of " + std::to_string(image.channels) + " channels";
}

std::uint64_t
fileBytes(const FrameHeader& header)
{
  std::uint64_t bytes = frame_header_bytes + checksum_bytes;
  for (const ImageRecord& image : header.images)
    bytes += image.bytes;
  return bytes;
}

void
putHeader(std::uint8_t*& to, const FrameHeader& header)
{
  to = std::copy_n(magic, magic_bytes, to);
  putNumber(to, static_cast<std::uint32_t>(file_formats::frame));
  putNumber(to, header.number);
  putNumber(to, static_cast<std::uint32_t>(header.observation));
  putNumber(to, static_cast<std::uint32_t>(header.pattern));
  putNumber(to, header.stamp);
  for (const ImageRecord& image : header.images) {
    for (const auto value : {image.width, image.height, image.channels, image.packing})
      putNumber(to, value);
    putNumber(to, image.bytes);
  }
}

FrameHeader
takeHeader(const std::uint8_t* data)
{
  FrameHeader header;
  header.number = takeNumber<std::uint64_t>(data);
  header.observation = static_cast<std::int32_t>(takeNumber<std::uint32_t>(data));
  header.pattern = static_cast<std::int32_t>(takeNumber<std::uint32_t>(data));
  header.stamp = takeNumber<std::uint64_t>(data);
  for (ImageRecord& image : header.images) {
    for (auto* const value :
         {&image.width, &image.height, &image.channels, &image.packing})
      *value = takeNumber<std::uint32_t>(data);
    image.bytes = takeNumber<std::uint64_t>(data);
  }
  return header;
}

[[noreturn]] void
fail(const std::string& name, const std::string& fault)
{
  throw InputFileException(name + ": " + fault);
}

[[noreturn]] void
failInFrame(const std::string& name, std::uint64_t number, const std::string& fault)
{
  fail(name, "frame " + std::to_string(number) + ": " + fault);
}

void
requireLength(const std::string& name, const FrameHeader& header, std::uint64_t bytes)
{
  const std::uint64_t needed = fileBytes(header);
  if (bytes < needed)
    failInFrame(name,
                header.number,
                "is truncated: " + std::to_string(needed) +
                    " bytes are needed, it has " + std::to_string(bytes));
  if (bytes > needed)
    failInFrame(name,
                header.number,
                std::to_string(bytes - needed) + " bytes too many follow its end");
}

CameraImage
takeImage(const ImageRecord& record, const std::uint8_t* data, bool& is_whole)
{
  CameraImage image;
  image.width = static_cast<std::int32_t>(record.width);
  image.height = static_cast<std::int32_t>(record.height);
  image.channels = static_cast<std::int32_t>(record.channels);
  if (record.packing == 0) {
    image.values.assign(data, data + record.bytes);
    return image;
  }
  image.values.resize(static_cast<std::size_t>(record.values()));
  is_whole = unpackImage(data, static_cast<std::size_t>(record.bytes), image);
  return image;
}

} // namespace

FrameHeader
headerOf(const TrinocularFrame& frame)
{
  FrameHeader header{frame.number, frame.observation, frame.pattern, frame.stamp, {}};
  for (std::size_t camera = 0; camera < frame.images.size(); ++camera) {
    const CameraImage& image = frame.images[camera];
    ImageRecord& record = header.images[camera];
    record.width = static_cast<std::uint32_t>(image.width);
    record.height = static_cast<std::uint32_t>(image.height);
    record.channels = static_cast<std::uint32_t>(image.channels);
    record.bytes = image.values.size();
  }
  return header;
}

std::string
faultOf(const FrameHeader& header)
{
  if (header.observation < 0)
    return "observation " + std::to_string(header.observation) + ", it counts from 0";
  if (header.pattern < TrinocularFrame::no_pattern)
    return "pattern " + std::to_string(header.pattern) + ", it counts from -1 (none)";
  const ImageRecord& reference = header.images.front();
  if (reference.width == 0)
    return cameraFault(0, "has no image");
  for (std::size_t camera = 0; camera < header.images.size(); ++camera) {
    const ImageRecord& image = header.images[camera];
    std::string fault = faultOfImage(image);
    if (fault.empty())
      fault = faultOfPacking(image);
    if (!fault.empty())
      return cameraFault(camera, fault);
    if (image.width > 0 &&
        (image.width != reference.width || image.height != reference.height))
      return cameraFault(camera,
                         sizeText(image) + " pixels, the reference has " +
                             sizeText(reference) + " pixels");
  }
  return "";
}

std::uint32_t
checksumOf(const std::uint8_t* data, std::size_t bytes)
{
  return static_cast<std::uint32_t>(::crc32_z(0, data, bytes));
}

std::vector<std::uint8_t>
encodeFrame(const TrinocularFrame& frame)
{
  FrameHeader header = headerOf(frame);
  const std::string fault = faultOf(header);
  if (!fault.empty())
    throw acmap::BadArgument("frame " + std::to_string(frame.number) + ": " + fault);
  std::array<std::optional<Bytes>, 3> packed;
  for (std::size_t camera = 0; camera < packed.size(); ++camera) {
    if (frame.images[camera].empty())
      continue;
    packed[camera] = packImage(frame.images[camera]);
    if (packed[camera]) {
      header.images[camera].packing = 1;
      header.images[camera].bytes = packed[camera]->size();
    }
  }
  Bytes bytes(fileBytes(header));
  std::uint8_t* to = bytes.data();
  putHeader(to, header);
  for (std::size_t camera = 0; camera < packed.size(); ++camera) {
    const Bytes& image = packed[camera] ? *packed[camera] : frame.images[camera].values;
    to = std::copy(image.begin(), image.end(), to);
  }
  putNumber(to, checksumOf(bytes.data(), bytes.size() - checksum_bytes));
  return bytes;
}

FrameHeader
decodeFrameHeader(const std::string& name,
                  const std::uint8_t* data,
                  std::uint64_t file_bytes)
{
  if (file_bytes < magic_bytes || std::memcmp(data, magic, magic_bytes) != 0)
    fail(name, file_bytes == 0 ? "is empty" : "is no frame file");
  if (file_bytes < frame_header_bytes)
    fail(name, "is truncated within its header");
  data += magic_bytes;
  const auto file_version = takeNumber<std::uint32_t>(data);
  const std::string newer = faultOfFormat(file_version, file_formats::frame);
  if (file_version == 0 || !newer.empty())
    fail(name, newer.empty() ? "is of version 0, which there is not" : newer);
  const FrameHeader header = takeHeader(data);
  const std::string fault = faultOf(header);
  if (!fault.empty())
    failInFrame(name, header.number, fault);
  requireLength(name, header, file_bytes);
  return header;
}

TrinocularFrame
decodeFrame(const std::string& name, const std::vector<std::uint8_t>& bytes)
{
  const FrameHeader header = decodeFrameHeader(name, bytes.data(), bytes.size());
  const std::size_t checked = bytes.size() - checksum_bytes;
  const std::uint8_t* told = bytes.data() + checked;
  if (takeNumber<std::uint32_t>(told) != checksumOf(bytes.data(), checked))
    failInFrame(name, header.number, "its checksum is wrong, the file is damaged");
  TrinocularFrame frame;
  frame.number = header.number;
  frame.observation = header.observation;
  frame.pattern = header.pattern;
  frame.stamp = header.stamp;
  const std::uint8_t* data = bytes.data() + frame_header_bytes;
  for (std::size_t camera = 0; camera < frame.images.size(); ++camera) {
    bool is_whole = true;
    frame.images[camera] = takeImage(header.images[camera], data, is_whole);
    if (!is_whole)
      failInFrame(
          name, header.number, cameraFault(camera, "its image cannot be unpacked"));
    data += header.images[camera].bytes;
  }
  return frame;
}

} // namespace pcl::acmap
