#include <pcl/core/exceptions.h>
#include <pcl/mpi/mpi_ranks.h>

#include <algorithm>
#include <utility>

namespace pcl {

namespace {

constexpr std::size_t part_bytes = std::size_t{1} << 30; // MPI counts in ints
constexpr int length_tag = 1, part_tag = 2;

/** Forgets the requests when all are complete. */
bool
areComplete(std::vector<MPI_Request>& requests)
{
  int are_complete = 0;
  MPI_Testall(static_cast<int>(requests.size()),
              requests.data(),
              &are_complete,
              MPI_STATUSES_IGNORE);
  if (are_complete)
    requests.clear();
  return are_complete != 0;
}

} // namespace

MpiRanks::MpiRanks(MPI_Comm communicator)
: communicator_(communicator)
{
  int is_initialised = 0, provided = MPI_THREAD_SINGLE, rank = 0, size = 1;
  MPI_Initialized(&is_initialised);
  if (is_initialised)
    MPI_Query_thread(&provided);
  if (provided < MPI_THREAD_SERIALIZED)
    throw acmap::BadArgument(
        "MPI has to be initialised with MPI_THREAD_SERIALIZED at least");
  MPI_Comm_rank(communicator_, &rank);
  MPI_Comm_size(communicator_, &size);
  rank_ = static_cast<std::size_t>(rank);
  size_ = static_cast<std::size_t>(size);
  incoming_.resize(size_);
}

void
MpiRanks::beginSending(std::size_t to, const Bytes& bytes)
{
  const auto rank = static_cast<int>(to);
  const std::uint64_t length = bytes.size();
  MPI_Send(&length, 1, MPI_UINT64_T, rank, length_tag, communicator_);
  for (std::size_t begin = 0; begin < bytes.size(); begin += part_bytes)
    MPI_Isend(bytes.data() + begin,
              static_cast<int>(std::min(part_bytes, bytes.size() - begin)),
              MPI_BYTE,
              rank,
              part_tag,
              communicator_,
              &sending_.emplace_back());
}

bool
MpiRanks::isSent()
{
  return areComplete(sending_);
}

bool
MpiRanks::tryReceiving(std::size_t from, Bytes& bytes)
{
  const auto rank = static_cast<int>(from);
  Incoming& message = incoming_[from];
  if (message.parts.empty()) {
    int has_arrived = 0;
    MPI_Iprobe(rank, length_tag, communicator_, &has_arrived, MPI_STATUS_IGNORE);
    if (!has_arrived)
      return false;
    std::uint64_t length = 0;
    MPI_Recv(
        &length, 1, MPI_UINT64_T, rank, length_tag, communicator_, MPI_STATUS_IGNORE);
    message.bytes.resize(length);
    // MPI_Recv would keep a processor busy, which the sender may need.
    for (std::size_t begin = 0; begin < length; begin += part_bytes)
      MPI_Irecv(message.bytes.data() + begin,
                static_cast<int>(std::min(part_bytes, length - begin)),
                MPI_BYTE,
                rank,
                part_tag,
                communicator_,
                &message.parts.emplace_back());
  }
  if (!areComplete(message.parts))
    return false;
  bytes = std::exchange(message.bytes, {});
  return true;
}

} // namespace pcl
