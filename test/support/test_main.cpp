#include <gtest/gtest.h>

/** \brief Returns 0 if no test failed, 1 if a test failed or there was no test, 77 if
 * all tests were skipped, which ctest reports. */
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
