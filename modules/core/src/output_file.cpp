#include <pcl/core/output_file.h>

#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void
fail(const std::string& path, const std::string& fault)
{
  throw OutputFileException(path + ": " + fault);
}

fs::path
nameBeside(const fs::path& target)
{
  static std::atomic<unsigned> number{0};
  constexpr std::size_t longest = 200; // keeps the whole below the usual limit of 255
  return target.parent_path() /
         ("." + target.filename().string().substr(0, longest) + ".tmp-" +
          std::to_string(::getpid()) + "-" + std::to_string(number++));
}

} // namespace

std::string
followLinks(const std::string& path)
{
  std::error_code error;
  const fs::path target = fs::canonical(path, error);
  return error ? path : target.string();
}

OutputFile::OutputFile(const std::string& path)
: path_(path)
{
  const fs::path target = followLinks(path);
  struct stat status;
  const bool exists = ::stat(target.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode))
    fail(path, "is a folder");
  if (target.filename().empty())
    fail(path, "names no file");
  if (exists && ::access(target.c_str(), W_OK) != 0)
    fail(path, std::strerror(errno));
  target_ = target.string();
  if (exists && !S_ISREG(status.st_mode)) {
    file_ = std::fopen(target_.c_str(), "wb"); // a device or pipe has no old content
  }
  else {
    do {
      temporary_ = nameBeside(target).string();
      file_ = std::fopen(temporary_.c_str(), "wbx");
    } while (!file_ && errno == EEXIST);
  }
  if (!file_)
    fail(path, std::strerror(errno));
  if (exists && !temporary_.empty())
    ::fchmod(::fileno(file_), status.st_mode & 07777);
}

OutputFile::~OutputFile()
{
  if (file_)
    std::fclose(file_);
  if (!temporary_.empty())
    std::remove(temporary_.c_str());
}

void
OutputFile::write(const void* data, std::size_t bytes)
{
  if (std::fwrite(data, 1, bytes, file_) != bytes)
    fail(path_, std::strerror(errno));
}

void
OutputFile::commit()
{
  std::FILE* const file = file_;
  file_ = nullptr;
  if (std::fclose(file) != 0)
    fail(path_, std::strerror(errno));
  if (temporary_.empty())
    return;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0)
    fail(path_, std::strerror(errno));
  temporary_.clear();
}

} // namespace pcl::acmap
