#include "small_session.h"

#include "run_tool.h"

#include <gtest/gtest.h>

namespace pcl::acmap::test {

void
filmSmallSession(const std::string& session)
{
  const ToolRun rig = runTool(ACMAP_SIMULATED_RIG,
                              {"-o",
                               session,
                               "--scene",
                               "corridor_drive",
                               "--observations",
                               "3",
                               "--patterns",
                               "3"});
  ASSERT_EQ(rig.exit_code, 0) << rig.err;
}

} // namespace pcl::acmap::test
