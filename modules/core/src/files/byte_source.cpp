#include "files/byte_source.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/progress.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace pcl::acmap {

ByteSource::ByteSource(const std::string& path)
: name_(path)
{
  struct stat status;
  if (::stat(path.c_str(), &status) != 0)
    fail(std::strerror(errno));
  if (S_ISDIR(status.st_mode))
    fail("is a folder, not a file");
  if (!S_ISREG(status.st_mode))
    fail("is not a regular file");
  if (status.st_size == 0)
    fail("is empty");
  buffer_.reset(new char[maximum_line]);
  descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0)
    fail(std::strerror(errno));
  size_ = unread_ = static_cast<std::uint64_t>(status.st_size);
}

ByteSource::ByteSource(std::string name, const void* data, std::size_t size)
: name_(std::move(name))
, size_(size)
, window_(static_cast<const char*>(data))
, window_end_(window_ + size)
{
  if (size == 0)
    fail("is empty");
}

ByteSource::~ByteSource()
{
  if (descriptor_ >= 0)
    ::close(descriptor_);
}

void
ByteSource::readFile(char* to, std::size_t bytes)
{
  while (bytes > 0) {
    const ssize_t got = ::read(descriptor_, to, bytes);
    if (got < 0 && errno == EINTR)
      continue;
    if (got < 0)
      fail(std::strerror(errno));
    if (got == 0)
      fail("became shorter while it was read");
    to += got;
    bytes -= static_cast<std::size_t>(got);
    unread_ -= static_cast<std::uint64_t>(got);
  }
}

bool
ByteSource::refill()
{
  const std::size_t kept = windowSize();
  const auto wanted = std::min<std::uint64_t>(unread_, maximum_line - kept);
  if (wanted == 0)
    return false;
  if (kept > 0)
    std::memmove(buffer_.get(), window_, kept);
  readFile(buffer_.get() + kept, static_cast<std::size_t>(wanted));
  window_ = buffer_.get();
  window_end_ = window_ + kept + wanted;
  return true;
}

void
ByteSource::read(void* to, std::size_t bytes)
{
  if (bytes > remaining())
    fail("is truncated: " + std::to_string(bytes) + " bytes are needed, " +
         std::to_string(remaining()) + " follow");
  const std::size_t near = std::min(bytes, windowSize());
  if (near > 0)
    std::memcpy(to, window_, near);
  window_ += near;
  if (bytes > near)
    pollRun();
  if (bytes - near >= maximum_line) {
    readFile(static_cast<char*>(to) + near, bytes - near);
  }
  else if (bytes > near) {
    refill();
    std::memcpy(static_cast<char*>(to) + near, window_, bytes - near);
    window_ += bytes - near;
  }
}

void
ByteSource::skip(std::uint64_t bytes)
{
  if (bytes > remaining())
    fail("is truncated: " + std::to_string(bytes) + " bytes are to be skipped, " +
         std::to_string(remaining()) + " follow");
  const auto near = std::min<std::uint64_t>(bytes, windowSize());
  window_ += near;
  const std::uint64_t far = bytes - near;
  if (far > 0 && ::lseek(descriptor_, static_cast<off_t>(far), SEEK_CUR) < 0)
    fail(std::strerror(errno));
  unread_ -= far;
}

void
ByteSource::moveTo(std::uint64_t offset)
{
  if (offset > size_)
    fail("ends before byte " + std::to_string(offset));
  line_ = 0;
  if (descriptor_ < 0) {
    window_ = window_end_ - (size_ - offset);
    return;
  }
  if (::lseek(descriptor_, static_cast<off_t>(offset), SEEK_SET) < 0)
    fail(std::strerror(errno));
  window_ = window_end_ = buffer_.get();
  unread_ = size_ - offset;
}

std::string_view
ByteSource::ahead(std::size_t minimum)
{
  if (windowSize() < minimum)
    refill();
  return {window_, windowSize()};
}

bool
ByteSource::readLine(std::string_view& line)
{
  const char* end = nullptr;
  do {
    if (windowSize() > 0)
      end = static_cast<const char*>(std::memchr(window_, '\n', windowSize()));
  } while (!end && refill());
  if (windowSize() == 0)
    return false;
  ++line_;
  const char* const stop = end ? end : window_end_;
  line = {window_, static_cast<std::size_t>(stop - window_)};
  if (line.size() >= maximum_line)
    failAtLine("is too long for a line of text");
  if (!line.empty() && line.back() == '\r')
    line.remove_suffix(1);
  window_ = end ? end + 1 : stop;
  return true;
}

bool
ByteSource::readFilledLine(std::string_view& line)
{
  while (readLine(line))
    if (line.find_first_not_of(" \t\r") != std::string_view::npos)
      return true;
  return false;
}

void
ByteSource::fail(const std::string& fault) const
{
  throw InputFileException(name_ + ": " + fault);
}

void
ByteSource::failAtLine(const std::string& fault) const
{
  fail("line " + std::to_string(line_) + ": " + fault);
}

} // namespace pcl::acmap
