#pragma once

#include "clouds.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/progress.h>

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <limits>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief A call that a public class must reject, and substrings of the message: the
 * value, the valid range, the unit. */
template <typename Class>
struct RefusedCall {
  std::function<void(Class&)> call;
  std::vector<std::string> words;
};

/** \brief What most traits of a class have in common. */
template <typename ClassT>
struct CommonTraits {
  using Class = ClassT;
  using Calls = std::vector<RefusedCall<Class>>;

  static Class
  make()
  {
    return {};
  }

  template <typename Output>
  static bool
  isEmpty(const Output& output)
  {
    return output.empty();
  }

  static std::size_t
  invalidPoints(const Class& object)
  {
    return object.getReport().invalid_points;
  }

  /** Appends calls of a setter with values that it must refuse. The message contains the
   * value and other words. */
  template <typename Setter, typename Value>
  static void
  refuse(Calls& calls,
         Setter set,
         const std::vector<Value>& values,
         const std::vector<std::string>& words)
  {
    for (const Value value : values) {
      std::ostringstream text;
      text << value;
      calls.push_back(
          {[set, value](Class& object) { std::invoke(set, object, value); }, words});
      calls.back().words.push_back(text.str());
    }
  }
};

/** \brief Invalid values of every number that must be positive. */
inline const std::vector<double> nonsense{-0.5,
                                          std::numeric_limits<double>::quiet_NaN(),
                                          std::numeric_limits<double>::infinity()};

/** \brief The words of a public header, independent of line breaks in comments.
 * \param[in] path below the folder of the modules */
inline std::string
headerText(const std::string& path)
{
  std::ifstream file(ACMAP_SOURCE_DIR "/modules/" + path);
  std::string text;
  for (std::string word; file >> word;)
    text += word == "*" ? "" : word + " ";
  return text;
}

/** \brief Does a message name the parameter, its value, its range and its unit, as
 * requireInRange does? */
inline bool
namesRange(const std::string& message)
{
  static const std::regex form("[: ]*[A-Za-z].* = [^ ]+ is refused: it must be within "
                               "\\[[^ ]+, [^ ]+\\] [^ ].*");
  return std::regex_match(message, form);
}

/** \brief Setters with invalid values throw, explain why, and change nothing. \a Traits
 * as in \ref ClassContract.
 * \param[in] make creates an object in its initial state */
template <typename Traits, typename Make>
void
expectNonsenseRefused(const Make& make)
{
  for (const auto& refused : Traits::refusedCalls()) {
    typename Traits::Class object = make();
    const std::string before = Traits::parameters(object);
    try {
      refused.call(object);
      ADD_FAILURE() << "nonsense was accepted: " << Traits::parameters(object);
    }
    catch (const BadArgumentException& error) {
      for (const std::string& word : refused.words) {
        EXPECT_NE(std::string(error.what()).find(word), std::string::npos)
            << '"' << word << "\" is not in \"" << error.what() << '"';
        EXPECT_TRUE(word.front() != '[' || namesRange(error.what())) << error.what();
      }
    }
    EXPECT_EQ(Traits::parameters(object), before);
  }
}

/** \brief Clouds that every class must accept, even if the result is empty. */
inline std::vector<std::pair<std::string, Cloud>>
degenerateClouds()
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  Cloud invalid;
  invalid.resize(50, PointXYZ(nan, nan, nan));
  invalid.is_dense = false;
  return {{"no point", {}},
          {"one point", makeRandomBox(1, 1)},
          {"two points", makeRandomBox(2, 1)},
          {"points in line", makeCollinear(40)},
          {"points in one place", makeCoincident(1000)},
          {"no valid point", invalid},
          {"two points far out", withOutlier(makeRandomBox(1, 1), 1e9F)}};
}

/** \brief The common contract of the library's classes, with one test per requirement.
 * A class takes part with a traits type:
 *
 * - `Class`, `Output` (equality comparable);
 * - `setInput (Class&, const Cloud&)`, `run (Class&, Output&)`;
 * - `isEmpty (const Output&)`, `sentinel ()`: an output that no run can produce;
 * - `refusedCalls ()`: setters with invalid values;
 * - `parameters (const Class&)`: all parameters as text;
 * - `invalidPoints (const Class&)`: the number of invalid points in the report;
 * - `header`: the path of the public header below `modules`. */
template <typename Traits>
class ClassContract : public testing::Test {
protected:
  using Class = typename Traits::Class;
  using Output = typename Traits::Output;

  static Output
  outputOf(Class& object, const Cloud& cloud)
  {
    Output output = Traits::sentinel();
    Traits::setInput(object, cloud);
    Traits::run(object, output);
    return output;
  }

  static Output
  outputOf(const Cloud& cloud)
  {
    Class object;
    return outputOf(object, cloud);
  }

  const Cloud cloud_ = makeJitteredPlane({60, 60, 0.02, 0.25, 0.1, 5}).cloud;
  const Cloud other_cloud_ = makeRoom(0.2, 0.1, 3);
};

TYPED_TEST_SUITE_P(ClassContract);

TYPED_TEST_P(ClassContract, worksAsConstructed)
{
  EXPECT_FALSE(TypeParam::isEmpty(this->outputOf(this->cloud_)));
}

TYPED_TEST_P(ClassContract, settersRefuseNonsenseAndSayWhy)
{
  expectNonsenseRefused<TypeParam>([] { return typename TypeParam::Class(); });
}

TYPED_TEST_P(ClassContract, missingInputIsRefusedAndOutputUntouched)
{
  typename TypeParam::Class object;
  auto output = TypeParam::sentinel();
  EXPECT_THROW(TypeParam::run(object, output), InitFailedException);
  EXPECT_EQ(output, TypeParam::sentinel());
}

TYPED_TEST_P(ClassContract, invalidPointsAreSkippedAndCounted)
{
  typename TypeParam::Class object;
  const Cloud laced = lacedWithNan(this->cloud_, 4);
  EXPECT_FALSE(TypeParam::isEmpty(this->outputOf(object, laced)));
  EXPECT_EQ(TypeParam::invalidPoints(object), laced.size() - this->cloud_.size());
}

TYPED_TEST_P(ClassContract, degenerateInputIsLegalAndExplained)
{
  for (const auto& [name, cloud] : degenerateClouds()) {
    typename TypeParam::Class object;
    EXPECT_TRUE(TypeParam::isEmpty(this->outputOf(object, cloud))) << name;
    EXPECT_FALSE(object.getReport().remarks.empty()) << name;
  }
}

TYPED_TEST_P(ClassContract, cancelledRunLeavesOutputAndObjectUsable)
{
  for (const int allowed_calls : {0, 1, 2, 5}) {
    typename TypeParam::Class object;
    TypeParam::setInput(object, this->cloud_);
    int calls = 0;
    object.setProgressCallback(
        [&](double, const std::string&) { return calls++ < allowed_calls; });
    auto output = TypeParam::sentinel();
    try {
      TypeParam::run(object, output);
      EXPECT_LE(calls, allowed_calls) << "the callback's refusal was ignored";
    }
    catch (const CancelledException&) {
      EXPECT_EQ(calls, allowed_calls + 1);
      EXPECT_EQ(output, TypeParam::sentinel());
    }
    object.setProgressCallback({});
    EXPECT_EQ(this->outputOf(object, this->cloud_), this->outputOf(this->cloud_));
  }
}

TYPED_TEST_P(ClassContract, parametersStayAndRunsDoNotDependOnEarlierOnes)
{
  typename TypeParam::Class object;
  const std::string before = TypeParam::parameters(object);
  const auto first = this->outputOf(object, this->cloud_);
  this->outputOf(object, this->other_cloud_);
  this->outputOf(object, Cloud());
  EXPECT_EQ(this->outputOf(object, this->cloud_), first);
  EXPECT_EQ(this->outputOf(this->cloud_), first);
  EXPECT_EQ(TypeParam::parameters(object), before);
}

TYPED_TEST_P(ClassContract, reportTellsSecondsAndProgressNeverFalls)
{
  typename TypeParam::Class object;
  double last = 0;
  int calls = 0;
  object.setProgressCallback([&](double fraction, const std::string& step) {
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1);
    EXPECT_FALSE(step.empty());
    last = fraction;
    return ++calls > 0;
  });
  this->outputOf(object, this->cloud_);
  EXPECT_GT(calls, 1);
  EXPECT_FALSE(object.getReport().seconds.empty());
  for (const auto& [step, seconds] : object.getReport().seconds) {
    EXPECT_FALSE(step.empty());
    EXPECT_GE(seconds, 0);
  }
}

TYPED_TEST_P(ClassContract, threadsDoNotChangeAByte)
{
  const auto wanted = this->outputOf(this->other_cloud_);
  for (const unsigned threads : {1U, 2U, 8U}) {
    typename TypeParam::Class object;
    object.setNumberOfThreads(threads);
    EXPECT_EQ(this->outputOf(object, this->other_cloud_), wanted)
        << threads << " threads";
  }
}

TYPED_TEST_P(ClassContract, headerSaysWhatAUserMustKnow)
{
  const std::string header = headerText(TypeParam::header);
  for (const char* needed :
       {"Active Stereo Based Compact Mapping", "etres", "O(n", "\\throws", "\\code"})
    EXPECT_NE(header.find(needed), std::string::npos) << needed;
}

REGISTER_TYPED_TEST_SUITE_P(ClassContract,
                            worksAsConstructed,
                            settersRefuseNonsenseAndSayWhy,
                            missingInputIsRefusedAndOutputUntouched,
                            invalidPointsAreSkippedAndCounted,
                            degenerateInputIsLegalAndExplained,
                            cancelledRunLeavesOutputAndObjectUsable,
                            parametersStayAndRunsDoNotDependOnEarlierOnes,
                            reportTellsSecondsAndProgressNeverFalls,
                            threadsDoNotChangeAByte,
                            headerSaysWhatAUserMustKnow);

} // namespace pcl::acmap::test
