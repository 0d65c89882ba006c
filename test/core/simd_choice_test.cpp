#include <pcl/core/impl/simd_choice.h>

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace pcl::acmap::test {
namespace {

/** Sets an environment variable and restores the old value. */
class Environment {
public:
  explicit Environment(const char* value)
  {
    if (const char* before = std::getenv(name))
      before_ = before;
    set(value);
  }

  ~Environment()
  {
    set(before_ ? before_->c_str() : nullptr);
  }

private:
  static constexpr const char* name = "ACMAP_SIMD";

  static void
  set(const char* value)
  {
    if (value)
      setenv(name, value, 1);
    else
      unsetenv(name);
  }

  std::optional<std::string> before_;
};

TEST(SimdChoice, BaseForbidsAvx2)
{
  const Environment base("base");
  EXPECT_FALSE(isAvx2Chosen());
}

#if defined(__x86_64__) || defined(__i386__)
TEST(SimdChoice, OtherwiseTheProcessorDecides)
{
  const bool has_avx2 = __builtin_cpu_supports("avx2");
  for (const char* value :
       {static_cast<const char*>(nullptr), "", "avx2", "basement"}) {
    const Environment other(value);
    EXPECT_EQ(isAvx2Chosen(), has_avx2) << (value ? value : "not set");
  }
}
#endif

} // namespace
} // namespace pcl::acmap::test
