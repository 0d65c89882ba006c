#include <gtest/gtest.h>

/** \brief 0 if no test failed, 1 if one did or there was none to run, 77 if all were
 * skipped, which ctest then tells. */
int
main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  if (const int failure = RUN_ALL_TESTS(); failure != 0)
    return failure;
  const testing::UnitTest& tests = *testing::UnitTest::GetInstance();
  if (tests.test_to_run_count() == 0)
    return 1;
  const bool is_skipped =
      tests.skipped_test_count() > 0 && tests.successful_test_count() == 0;
  return is_skipped ? 77 : 0;
}
