#include "frame_codec.h"

#include <pcl/acquisition/frame_file.h>
#include <pcl/core/output_file.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace pcl {

namespace acmap {

namespace {

/** \brief An open file whose header was read and is consistent with its length. */
struct OpenFrame {
  std::ifstream file;
  std::vector<std::uint8_t> bytes; ///< content that was read so far
  std::uint64_t file_bytes = 0;
  FrameHeader header;
};

void
readMore(OpenFrame& frame, const std::string& path, std::size_t bytes)
{
  const std::size_t begun = frame.bytes.size();
  frame.bytes.resize(begun + bytes);
  frame.file.read(reinterpret_cast<char*>(frame.bytes.data() + begun),
                  static_cast<std::streamsize>(bytes));
  if (!frame.file)
    throw InputFileException(path + ": could not be read to its end");
}

OpenFrame
openFrame(const std::string& path)
{
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    throw InputFileException(path + ": " +
                             (error ? error.message() : "No such file or directory"));
  if (!std::filesystem::is_regular_file(status))
    throw InputFileException(path + ": is not a regular file");
  OpenFrame frame;
  frame.file_bytes = std::filesystem::file_size(path, error);
  frame.file.open(path, std::ios::binary);
  if (error || !frame.file)
    throw InputFileException(path + ": " + std::strerror(errno));
  readMore(frame, path, std::min<std::uint64_t>(frame.file_bytes, frame_header_bytes));
  frame.header = decodeFrameHeader(path, frame.bytes.data(), frame.file_bytes);
  return frame;
}

} // namespace

FrameHeader
loadFrameHeader(const std::string& path)
{
  return openFrame(path).header;
}

} // namespace acmap

void
saveTrinocularFrame(const std::string& path, const TrinocularFrame& frame)
{
  const std::vector<std::uint8_t> bytes = acmap::encodeFrame(frame);
  acmap::OutputFile file(path);
  file.write(bytes.data(), bytes.size());
  file.commit();
}

TrinocularFrame
loadTrinocularFrame(const std::string& path)
{
  acmap::OpenFrame frame = acmap::openFrame(path);
  acmap::readMore(frame, path, frame.file_bytes - frame.bytes.size());
  return acmap::decodeFrame(path, frame.bytes);
}

} // namespace pcl
