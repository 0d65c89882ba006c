#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace pcl::acmap {

/** \brief A sequence of bytes of known size, from a file or from memory, that is read
 * sequentially.
 *
 * Readers check \ref remaining before they allocate memory, so that a wrong header
 * cannot cause larger allocations than the file justifies. Every fault is an
 * InputFileException that begins with the name of the source. */
class ByteSource {
public:
  /** \brief Maximum length of a line that \ref readLine accepts; a longer one is not
   * considered text. */
  static constexpr std::size_t maximum_line = 256 * 1024;

  /** \throws InputFileException when the path is missing, unreadable, empty or not a
   * regular file */
  explicit ByteSource(const std::string& path);

  /** \brief Reads from memory that must outlive this object. */
  ByteSource(std::string name, const void* data, std::size_t size);

  ~ByteSource();
  ByteSource(const ByteSource&) = delete;
  ByteSource&
  operator=(const ByteSource&) = delete;

  const std::string&
  name() const
  {
    return name_;
  }

  /** \brief Number of bytes from the beginning to the end. */
  std::uint64_t
  size() const
  {
    return size_;
  }

  /** \brief Number of bytes from the current position to the end. */
  std::uint64_t
  remaining() const
  {
    return unread_ + windowSize();
  }

  void
  read(void* to, std::size_t bytes);

  void
  skip(std::uint64_t bytes);

  /** \brief Continues at an offset from the beginning; lines are no longer counted.
   * \param[in] offset at most the size of the source */
  void
  moveTo(std::uint64_t offset);

  /** \brief Returns the bytes that follow, without moving on: at least \a minimum of
   * them, fewer at the end of the source. Valid until the next call.
   * \param[in] minimum at most \ref maximum_line */
  std::string_view
  ahead(std::size_t minimum);

  /** \brief Returns the next line without its end (LF or CR LF); valid until the next
   * call.
   * \return false at the end of the source */
  bool
  readLine(std::string_view& line);

  /** \brief Like \ref readLine, but skips blank lines. */
  bool
  readFilledLine(std::string_view& line);

  [[noreturn]] void
  fail(const std::string& fault) const;

  /** \brief Like \ref fail, but also reports the number of the line that was read last.
   */
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
  std::uint64_t size_ = 0;
  std::uint64_t unread_ = 0; // number of bytes of the file after the window
  std::unique_ptr<char[]> buffer_;
  const char* window_ = nullptr;
  const char* window_end_ = nullptr;
  std::size_t line_ = 0;
};

} // namespace pcl::acmap
