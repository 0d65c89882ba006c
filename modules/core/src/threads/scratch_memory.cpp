#include "threads/scratch_pages.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/scratch_memory.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iterator>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

namespace pcl {

namespace acmap {
namespace {

constexpr std::size_t min_resident = std::size_t{16} << 20; // bytes

/** \return descriptor of a new file without a name, or -1 */
int
openNameless(const std::string& folder)
{
#ifdef O_TMPFILE
  const int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file >= 0)
    return file;
#endif
  std::string name = folder + "/.acmap-scratch-XXXXXX"; // of file systems without them
  const int named = ::mkostemp(name.data(), O_CLOEXEC);
  if (named >= 0)
    ::unlink(name.c_str());
  return named;
}

/** \brief Resident memory of this process, in bytes. */
struct Resident {
  std::size_t files = 0;  ///< mapped ones, those of the program included
  std::size_t others = 0; ///< all that is in no file
};

/** The memory of this process, as often as needed: its table stays open. */
class ResidentMemory {
public:
  ResidentMemory()
  : table_(::open("/proc/self/statm", O_RDONLY | O_CLOEXEC))
  {}

  ~ResidentMemory()
  {
    ::close(table_);
  }

  ResidentMemory(const ResidentMemory&) = delete;
  ResidentMemory&
  operator=(const ResidentMemory&) = delete;

  Resident
  now() const
  {
    std::array<char, 128> text{};
    unsigned long size = 0, resident = 0, of_files = 0;
    if (::pread(table_, text.data(), text.size() - 1, 0) <= 0 ||
        std::sscanf(text.data(), "%lu %lu %lu", &size, &resident, &of_files) != 3)
      return {};
    const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    return {of_files * page, (std::max(resident, of_files) - of_files) * page};
  }

private:
  int table_;
};

/** All blocks of this process that are in files. */
class ScratchBlocks {
public:
  static ScratchBlocks&
  all()
  {
    static auto* const blocks = new ScratchBlocks; // arrays may outlive static objects
    return *blocks;
  }

  void
  add(void* memory, std::size_t bytes)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    blocks_[static_cast<char*>(memory)] = bytes;
    size_ += bytes;
  }

  bool
  holds(const void* address)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto after = blocks_.upper_bound(static_cast<const char*>(address));
    return after != blocks_.begin() &&
           address < std::prev(after)->first + std::prev(after)->second;
  }

  /** \ref release must never see what is mapped next at that address: it is forgotten
   * first. Removing the file may take long, and needs no lock. */
  void
  unmap(void* memory, std::size_t bytes)
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      size_ -= blocks_.erase(static_cast<char*>(memory)) * bytes;
    }
    ::munmap(memory, bytes);
  }

  /** Takes pages out of this process, in turns, until there are few enough. Their content
   * stays in the files. All at once would take so long that other threads would bring in
   * as many meanwhile. */
  template <typename AreFew>
  void
  release(const AreFew& are_few)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::size_t left = size_;
    while (left > 0 && !are_few())
      left -= std::min(left, releaseNext());
  }

private:
  /** \return bytes of the part whose turn it was */
  std::size_t
  releaseNext()
  {
    constexpr std::size_t part = std::size_t{32} << 20;
    auto block = blocks_.upper_bound(next_);
    if (block != blocks_.begin() &&
        next_ < std::prev(block)->first + std::prev(block)->second)
      --block;
    else {
      block = block == blocks_.end() ? blocks_.begin() : block;
      next_ = block->first;
    }
    const auto [memory, bytes] = *block;
    const std::size_t size =
        std::min(part, static_cast<std::size_t>(memory + bytes - next_));
    ::madvise(next_, size, MADV_DONTNEED);
    next_ += size;
    return size;
  }

  std::mutex mutex_;
  std::map<char*, std::size_t, std::less<>> blocks_;
  std::size_t size_ = 0; ///< of all blocks
  char* next_ = nullptr; ///< whose turn it is
};

} // namespace

/** What is in effect while a ScratchMemory exists. */
class ScratchScope {
public:
  ScratchScope(std::string folder, std::size_t resident, std::size_t of_process)
  : folder_(std::move(folder))
  , resident_(resident)
  , of_process_(of_process / 4 * 3) // the rest is for what comes before the next check
  , before_(memory_.now().files)
  , watch_([this] { watch(); })
  {}

  ~ScratchScope()
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      is_over_ = true;
    }
    over_.notify_one();
    watch_.join();
  }

  std::size_t
  resident() const
  {
    return resident_;
  }

  void*
  map(std::size_t bytes)
  {
    const int file = openNameless(folder_);
    // Without this, a full disk would end the process when a page is written.
    const bool has_room =
        file >= 0 && ::posix_fallocate(file, 0, static_cast<off_t>(bytes)) == 0;
    void* const memory =
        has_room ? ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0)
                 : MAP_FAILED;
    if (file >= 0)
      ::close(file);
    if (memory == MAP_FAILED) {
      refused += bytes;
      return nullptr;
    }
#ifdef MADV_NOHUGEPAGE
    // A visit of an array in no order would bring in 2 MB, and the first write into a
    // page that came back takes as long as the pages that the file system keeps together
    // are large.
    ::madvise(memory, bytes, MADV_NOHUGEPAGE);
#endif
    ScratchBlocks::all().add(memory, bytes);
    this->bytes += bytes;
    return memory;
  }

  /** Takes pages out of the process if they are more than allowed.
   * \return could they soon be too many again? */
  bool
  check()
  {
    // A thread that did not wait for another one here would bring in pages meanwhile.
    const std::lock_guard<std::mutex> lock(checking_);
    const Resident now = memory_.now();
    const std::size_t arrays = arraysOf(now);
    const std::size_t others = before_ + now.others;
    const std::size_t allowed =
        std::max(resident_, of_process_ - std::min(of_process_, others));
    if (arrays >= allowed)
      ScratchBlocks::all().release(
          [&] { return arraysOf(memory_.now()) < allowed / 8 * 7; });
    return arrays > allowed / 2;
  }

  std::atomic<std::size_t> bytes{0};
  std::atomic<std::size_t> refused{0};

private:
  /** Bytes of the arrays that are resident. */
  std::size_t
  arraysOf(const Resident& now)
  {
    before_ = std::min(before_, now.files);
    return now.files - before_;
  }

  void
  watch()
  {
    constexpr std::chrono::milliseconds pause(2);
    std::unique_lock<std::mutex> lock(mutex_);
    while (!over_.wait_for(lock, pause, [this] { return is_over_; }))
      check();
  }

  ResidentMemory memory_;
  std::string folder_;
  std::size_t resident_;
  std::size_t of_process_;
  std::mutex checking_;
  std::size_t before_; ///< bytes of mapped files that are not ours: the program
  std::mutex mutex_;
  std::condition_variable over_;
  bool is_over_ = false;
  std::thread watch_; // the last member: it uses the others
};

namespace {

/** The scopes that exist; the last one is in effect. */
class ScratchScopes {
public:
  using ScopePointer = std::shared_ptr<ScratchScope>;

  static ScratchScopes&
  all()
  {
    static auto* const scopes = new ScratchScopes;
    return *scopes;
  }

  void
  add(const ScopePointer& scope)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    scopes_.push_back(scope);
    is_any_ = true;
  }

  void
  remove(const ScopePointer& scope)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    scopes_.erase(std::find(scopes_.begin(), scopes_.end(), scope));
    is_any_ = !scopes_.empty();
  }

  bool
  isAny() const
  {
    return is_any_;
  }

  ScopePointer
  last()
  {
    if (!is_any_)
      return nullptr;
    const std::lock_guard<std::mutex> lock(mutex_);
    return scopes_.empty() ? nullptr : scopes_.back();
  }

private:
  std::mutex mutex_;
  std::vector<ScopePointer> scopes_;
  std::atomic<bool> is_any_{false};
};

} // namespace

void*
mapScratch(std::size_t bytes)
{
  const std::shared_ptr<ScratchScope> scope = ScratchScopes::all().last();
  return scope ? scope->map(bytes) : nullptr;
}

void
keepScratchSmall()
{
  using Clock = std::chrono::steady_clock;
  // A fault brings in 64 KB in some microseconds.
  constexpr std::chrono::microseconds long_pause(1000), short_pause(100);
  static thread_local Clock::time_point next;
  if (!ScratchScopes::all().isAny() || Clock::now() < next)
    return;
  const std::shared_ptr<ScratchScope> scope = ScratchScopes::all().last();
  const bool is_close = scope && scope->check();
  next = Clock::now() + (is_close ? short_pause : long_pause);
}

bool
isInScratch(const void* address)
{
  return ScratchBlocks::all().holds(address);
}

void
unmapLarge(void* memory, std::size_t bytes)
{
  ScratchBlocks::all().unmap(memory, bytes);
}

} // namespace acmap

ScratchMemory::ScratchMemory(const std::string& folder,
                             std::size_t resident,
                             std::size_t of_process)
{
  if (resident < acmap::min_resident)
    throw acmap::BadArgument("scratch memory needs at least 16 MB, " +
                             std::to_string(resident) + " bytes were given");
  const int file = acmap::openNameless(folder);
  if (file < 0)
    throw OutputFileException(folder + ": " + std::strerror(errno));
  ::close(file);
  scope_ = std::make_shared<acmap::ScratchScope>(folder, resident, of_process);
  acmap::ScratchScopes::all().add(scope_);
}

ScratchMemory::~ScratchMemory()
{
  acmap::ScratchScopes::all().remove(scope_);
}

std::size_t
ScratchMemory::getResidentInEffect()
{
  const std::shared_ptr<acmap::ScratchScope> scope = acmap::ScratchScopes::all().last();
  return scope ? scope->resident() : 0;
}

std::size_t
ScratchMemory::getBytes() const
{
  return scope_->bytes;
}

std::size_t
ScratchMemory::getRefused() const
{
  return scope_->refused;
}

} // namespace pcl
