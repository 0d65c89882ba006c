#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace pcl::acmap {

/** \brief Bytes of a known number, from a file or from memory, read from front to back.
 *
 * Readers ask \ref remaining before they take memory, so that a header cannot make them
 * allocate more than its file can back. Every fault is an InputFileException that begins
 * with the name of the source.
 */
class ByteSource {
public:
  /** \brief Longest line that \ref readLine accepts; what is longer is no text. */
  static constexpr std::size_t maximum_line = 256 * 1024;

  /** \throws InputFileException when the path is missing, unreadable, empty or no file */
  explicit ByteSource(const std::string& path);

  /** \brief Reads from memory that the caller keeps alive. */
  ByteSource(std::string name, const void* data, std::size_t size);

  ~ByteSource();
  ByteSource(const ByteSource&) = delete;
  ByteSource&
  operator=(const ByteSource&) = delete;

  /** \brief Bytes from here to the end. */
  std::uint64_t
  remaining() const
  {
    return unread_ + windowSize();
  }

  void
  read(void* to, std::size_t bytes);

  void
  skip(std::uint64_t bytes);

  /** \brief Gives the next line without its end (LF or CR LF); valid until the next call.
   * \return false when nothing is left */
  bool
  readLine(std::string_view& line);

  /** \brief Like \ref readLine, past blank lines. */
  bool
  readFilledLine(std::string_view& line);

  [[noreturn]] void
  fail(const std::string& fault) const;

  /** \brief As \ref fail, naming the line read last. */
  [[noreturn]] void
  failAtLine(const std::string& fault) const;

private:
  std::size_t
  windowSize() const
  {
    return static_cast<std::size_t>(window_end_ - window_);
  }

  bool
  refill();

  void
  readFile(char* to, std::size_t bytes);

  std::string name_;
  int descriptor_ = -1;
  std::uint64_t unread_ = 0; // bytes of the file after the window
  std::unique_ptr<char[]> buffer_;
  const char* window_ = nullptr;
  const char* window_end_ = nullptr;
  std::size_t line_ = 0;
};

} // namespace pcl::acmap
