#pragma once

#include "contract.h"

#include <pcl/core/exceptions.h>

#include <map>

namespace pcl::acmap::test {

/** \brief The class contract for classes that process patterns, frames, rigs and
 * matches instead of clouds. A class takes part with a traits type:
 *
 * - `Class`, `Output` (equality comparable);
 * - `make ()`: an object in its initial state, with everything it needs;
 * - `run (Class&, int which, Output&)`: sets the first or second (0, 1) input and calls
 *   the main function;
 * - `isEmpty (const Output&)`, `sentinel ()`: an output that no run can produce;
 * - `refusedCalls ()`: setters with invalid values;
 * - `refusedRuns ()`: runs without input, or with invalid input;
 * - `parameters (const Class&)`: all parameters as text;
 * - `header`: the path of the public header below `modules`. */
template <typename Traits>
class ShotContract : public testing::Test {
protected:
  using Class = typename Traits::Class;
  using Output = typename Traits::Output;

  static Output
  outputOf(Class& object, int which)
  {
    Output output = Traits::sentinel();
    Traits::run(object, which, output);
    return output;
  }

  static Output
  newOutputOf(int which)
  {
    Class object = Traits::make();
    return outputOf(object, which);
  }

  /** \brief Output of a new object, computed once for all tests. */
  static const Output&
  outputOf(int which)
  {
    static std::map<int, Output> outputs;
    if (outputs.count(which) == 0)
      outputs.emplace(which, newOutputOf(which));
    return outputs.at(which);
  }
};

/** \brief A run that must throw, with a name for messages. */
template <typename Class, typename Output>
struct RefusedRun {
  std::string name;
  std::function<void(Class&, Output&)> run;
};

TYPED_TEST_SUITE_P(ShotContract);

TYPED_TEST_P(ShotContract, worksAsConstructed)
{
  EXPECT_FALSE(TypeParam::isEmpty(this->outputOf(0)));
  EXPECT_FALSE(this->outputOf(0) == this->outputOf(1));
}

TYPED_TEST_P(ShotContract, settersRefuseNonsenseAndSayWhy)
{
  expectNonsenseRefused<TypeParam>(TypeParam::make);
}

TYPED_TEST_P(ShotContract, refusedRunLeavesOutputAndObjectUsable)
{
  for (const auto& refused : TypeParam::refusedRuns()) {
    typename TypeParam::Class object = TypeParam::make();
    auto output = TypeParam::sentinel();
    EXPECT_THROW(refused.run(object, output), PCLException) << refused.name;
    EXPECT_EQ(output, TypeParam::sentinel()) << refused.name;
    EXPECT_EQ(this->outputOf(object, 0), this->outputOf(0)) << refused.name;
  }
}

TYPED_TEST_P(ShotContract, parametersStayAndRunsDoNotDependOnEarlierOnes)
{
  typename TypeParam::Class object = TypeParam::make();
  const std::string before = TypeParam::parameters(object);
  const auto first = this->outputOf(object, 0);
  this->outputOf(object, 1);
  EXPECT_EQ(this->outputOf(object, 0), first);
  EXPECT_EQ(this->newOutputOf(0), first);
  EXPECT_EQ(TypeParam::parameters(object), before);
}

REGISTER_TYPED_TEST_SUITE_P(ShotContract,
                            worksAsConstructed,
                            settersRefuseNonsenseAndSayWhy,
                            refusedRunLeavesOutputAndObjectUsable,
                            parametersStayAndRunsDoNotDependOnEarlierOnes);

/** \brief Contract for classes whose report describes their last run. */
template <typename Traits>
class ReportContract : public ShotContract<Traits> {};

TYPED_TEST_SUITE_P(ReportContract);

TYPED_TEST_P(ReportContract, tellsTheSecondsOfTheLastRun)
{
  typename TypeParam::Class object = TypeParam::make();
  EXPECT_TRUE(object.getReport().seconds.empty());
  this->outputOf(object, 0);
  const std::size_t steps = object.getReport().seconds.size();
  EXPECT_GT(steps, 0u);
  for (const auto& [step, seconds] : object.getReport().seconds) {
    EXPECT_FALSE(step.empty());
    EXPECT_GE(seconds, 0);
  }
  this->outputOf(object, 1);
  EXPECT_EQ(object.getReport().seconds.size(), steps);
}

REGISTER_TYPED_TEST_SUITE_P(ReportContract, tellsTheSecondsOfTheLastRun);

/** \brief Contract for multi-threaded classes. */
template <typename Traits>
class ThreadContract : public ShotContract<Traits> {};

TYPED_TEST_SUITE_P(ThreadContract);

TYPED_TEST_P(ThreadContract, threadsDoNotChangeAByte)
{
  const auto wanted = this->outputOf(0);
  for (const unsigned threads : {1U, 2U, 8U}) {
    typename TypeParam::Class object = TypeParam::make();
    object.setNumberOfThreads(threads);
    EXPECT_EQ(this->outputOf(object, 0), wanted) << threads << " threads";
  }
}

REGISTER_TYPED_TEST_SUITE_P(ThreadContract, threadsDoNotChangeAByte);

/** \brief Contract for the documentation in headers. */
template <typename Traits>
class HeaderContract : public testing::Test {};

TYPED_TEST_SUITE_P(HeaderContract);

TYPED_TEST_P(HeaderContract, saysWhatAUserMustKnow)
{
  const std::string header = headerText(TypeParam::header);
  for (const char* needed :
       {"Active Stereo Based Compact Mapping", "O(", "\\throws", "\\code"})
    EXPECT_NE(header.find(needed), std::string::npos) << needed;
}

REGISTER_TYPED_TEST_SUITE_P(HeaderContract, saysWhatAUserMustKnow);

} // namespace pcl::acmap::test
