
#include <gtest/gtest.h>
#include <pcl/core/fields_json.h>

namespace pcl::acmap::test {
namespace {

enum class Outcome { Kept, Refused };
constexpr std::array<const char*, 2> outcome_names{"kept", "refused"};

struct Step {
  double length = 0.5;
};

template <typename Visitor>
void
visitFields(const Step& step, Visitor&& visit)
{
  visit({"length", "m"}, step.length);
}

struct InnerReport : Report {
  std::size_t points = 3;
};

template <typename Visitor>
void
visitFields(const InnerReport& report, Visitor&& visit)
{
  visit({"points"}, report.points);
}

/** Each kind of value. */
struct OuterReport : Report {
  Outcome outcome = Outcome::Refused;
  std::string reason = "why";
  std::array<std::size_t, 2> outcomes{4, 5};
  Eigen::Vector3d up{0, -1, 0};
  std::vector<Step> steps{{}, {}};
  std::optional<Step> first, last = Step{2};
  InnerReport inner;
  std::array<double, 2> factors{1, 2};
  std::vector<double> moved{0.25};
};

template <typename Visitor>
void
visitFields(const OuterReport& report, Visitor&& visit)
{
  visit({"outcome"}, Named{report.outcome, outcome_names});
  visit({"reason"}, report.reason);
  visit({"outcomes"}, Named{report.outcomes, outcome_names});
  visit({"up"}, report.up);
  visit({"steps"}, report.steps);
  visit({"first"}, report.first);
  visit({"last"}, report.last);
  visit({"inner"}, report.inner);
  visit({"factors"}, report.factors);
  visit({"moved", "m"}, report.moved);
}

TEST(FieldsJson, EachKindOfValueHasItsForm)
{
  OuterReport report;
  report.inner.seconds = {{"look", 1}};
  EXPECT_EQ(fieldsOf(report).dump(),
            R"({"outcome":"refused","reason":"why","outcomes":{"kept":4,"refused":5},)"
            R"("up":[0.0,-1.0,0.0],"steps":[{"length":0.5},{"length":0.5}],)"
            R"("last":{"length":2.0},"inner":{"points":3,"seconds":{"look":1.0}},)"
            R"("factors":[1.0,2.0],"moved":[0.25]})");
}

TEST(FieldsJson, FilesMayHaveOtherKeysInTheSameOrder)
{
  const nlohmann::ordered_json json = fieldsOf(
      OuterReport(),
      {{"reason", "refused"}, {"outcomes"}, {"up"}, {"steps"}, {"last"}, {"inner"}});
  EXPECT_EQ(
      json.dump(),
      R"({"outcome":"refused","refused":"why","factors":[1.0,2.0],"moved":[0.25]})");
}

TEST(FieldsJson, AReportHasItsSecondsAtTheEnd)
{
  InnerReport report;
  report.seconds = {{"look", 1}, {"find", 2}};
  EXPECT_EQ(jsonOf(report).dump(), R"({"points":3,"seconds":{"look":1.0,"find":2.0}})");
}

TEST(FieldsJson, RowsBecomeColumns)
{
  EXPECT_EQ(columnsOf(std::vector<Step>{{1}, {2}}).dump(), R"({"length":[1.0,2.0]})");
  EXPECT_EQ(columnsOf(std::vector<Step>()).dump(), R"({"length":[]})");
}

TEST(FieldsJson, AnEnumeratorWithoutANameIsRefused)
{
  EXPECT_THROW(nameIn(outcome_names, static_cast<Outcome>(2)), std::out_of_range);
}

} // namespace
} // namespace pcl::acmap::test
