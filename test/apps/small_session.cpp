#include "small_session.h"

#include "run_tool.h"

#include <gtest/gtest.h>

namespace pcl::acmap::test {

void
filmSmallSession(const std::string& session)
{
  runTool(ACMAP_SIMULATED_RIG,
          {"-o",
           session,
           "--scene",
           "corridor_drive",
           "--observations",
           "3",
           "--patterns",
           "3"})
      .succeeded();
}

} // namespace pcl::acmap::test
