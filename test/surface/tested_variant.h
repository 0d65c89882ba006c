#pragma once

#include <gtest/gtest.h>

namespace pcl::acmap::test {

/** \brief A test of one variant of the DeWall kernel, which the program selects by
 * ACMAP_DEWALL. It is skipped on a processor without its instructions. */
class VariantTest : public testing::Test {
protected:
  void
  SetUp() override
  {
#ifdef ACMAP_TEST_NEEDS_AVX2
    if (!__builtin_cpu_supports("avx2"))
      GTEST_SKIP() << "the processor has no AVX2";
#endif
  }
};

} // namespace pcl::acmap::test
