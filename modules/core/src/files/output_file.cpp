#include <pcl/core/output_file.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

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

/** Path of an open file, by which an unnamed file can be linked. */
std::string
nameOfOpen(int file)
{
  return "/proc/self/fd/" + std::to_string(file);
}

/** \return -1 if unnamed files are not supported */
int
openUnnamed(const fs::path& folder)
{
  const int file = ::open(
      folder.empty() ? "." : folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
  if (file < 0 || ::access(nameOfOpen(file).c_str(), F_OK) == 0)
    return file;
  ::close(file);
  return -1;
}

/** Links an unnamed file to a path that does not exist yet. */
bool
linkTo(int unnamed, const std::string& path)
{
  return ::linkat(AT_FDCWD,
                  nameOfOpen(unnamed).c_str(),
                  AT_FDCWD,
                  path.c_str(),
                  AT_SYMLINK_FOLLOW) == 0;
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
: path_(shownPath(path))
, target_(followLinks(path))
{
  struct stat status;
  const bool exists = ::stat(target_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode))
    fail(path_, "is a folder");
  if (fs::path(target_).filename().empty())
    fail(path_, "names no file");
  if (exists && ::access(target_.c_str(), W_OK) != 0)
    fail(path_, std::strerror(errno));
  if (exists && !S_ISREG(status.st_mode)) {
    // a device or pipe has no content to keep
    file_ = std::fopen(target_.c_str(), "wb");
    if (!file_)
      fail(path_, std::strerror(errno));
    return;
  }
  openBeside();
  if (exists)
    ::fchmod(::fileno(file_), status.st_mode & 07777);
}

void
OutputFile::openBeside()
{
  const fs::path target = target_;
  unnamed_ = openUnnamed(target.parent_path());
  if (unnamed_ >= 0) {
    const int copy = ::fcntl(unnamed_, F_DUPFD_CLOEXEC, 0);
    file_ = copy < 0 ? nullptr : ::fdopen(copy, "wb");
  }
  else {
    hide();
    file_ = std::fopen(temporary_.c_str(), "wbx");
  }
  if (file_)
    return;
  const std::string fault = std::strerror(errno);
  if (unnamed_ >= 0)
    ::close(unnamed_);
  fail(path_, fault);
}

void
OutputFile::hide()
{
  const fs::path target = target_;
  hidden_.emplace(target.parent_path(), target.filename().string(), path_);
  temporary_ = (hidden_->path() / target.filename()).string();
}

OutputFile::~OutputFile()
{
  if (file_)
    std::fclose(file_);
  if (unnamed_ >= 0)
    ::close(unnamed_);
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
  if (unnamed_ >= 0) {
    if (linkTo(unnamed_, target_))
      return;
    hide(); // a link cannot replace a file, a rename can
    if (!linkTo(unnamed_, temporary_))
      fail(path_, std::strerror(errno));
  }
  if (hidden_ && std::rename(temporary_.c_str(), target_.c_str()) != 0)
    fail(path_, std::strerror(errno));
  hidden_.reset();
}

} // namespace pcl::acmap
