// An outside project under mpirun: a message goes from rank to rank, and each adds a byte.
#include <pcl/mpi/mpi_ranks.h>

#include <iostream>

namespace {

/** \return the message after it has passed all ranks; only rank 0 has it */
pcl::Ranks::Bytes
passAround(pcl::Ranks& ranks)
{
  const auto own = static_cast<std::uint8_t>(ranks.rank());
  const std::size_t last = ranks.size() - 1;
  pcl::Ranks::Bytes bytes;
  if (own > 0)
    bytes = ranks.receive(own - 1);
  bytes.push_back(own);
  if (own < last)
    ranks.send(own + 1, bytes);
  else if (last > 0)
    ranks.send(0, bytes);
  return own == 0 && last > 0 ? ranks.receive(last) : bytes;
}

} // namespace

int
main(int argc, char** argv)
{
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &provided);
  int result = 0;
  {
    pcl::MpiRanks ranks(MPI_COMM_WORLD);
    const pcl::Ranks::Bytes bytes = passAround(ranks);
    if (ranks.rank() == 0) {
      std::cout << ranks.size() << " ranks passed " << bytes.size() << " bytes\n";
      result = bytes.size() == ranks.size() && ranks.size() > 1 ? 0 : 1;
    }
  }
  MPI_Finalize();
  return result;
}
