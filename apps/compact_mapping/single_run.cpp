#include "compact_mapping/run_ranks.h"

#include <cstdlib>

namespace pcl::acmap {

RunRanks::RunRanks(int&, char**&) {}

RunRanks::~RunRanks() = default;

void
RunRanks::abort(int exit_code) const
{
  std::exit(exit_code);
}

} // namespace pcl::acmap
