#include "messages.h"
#include "temporary_folder.h"

#include <pcl/core/impl/yaml_node.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

template <typename Action>
std::string
faultOf(const Action& action)
{
  return messageOf<InputFileException>(action);
}

TEST(YamlNode, GivesScalarsListsAndMaps)
{
  const YamlNode document = parseYaml("a.yaml",
                                      "name: a corridor # so it is called\n"
                                      "long: 65\n"
                                      "flat: -2.5e-3\n"
                                      "yes: true\n"
                                      "list: [1, 2,\n   3]\n"
                                      "maps:\n  - box: {a: 1}\n  - box: {a: 2}\n");
  EXPECT_EQ(document.at("name").text(), "a corridor");
  EXPECT_EQ(document.at("long").count(0, 100), 65u);
  EXPECT_EQ(document.at("flat").number(-1, 1), -2.5e-3);
  EXPECT_TRUE(document.at("yes").boolean());
  EXPECT_EQ(document.at("list").list(3, 3)[2].number(0, 9), 3.0);
  EXPECT_EQ(document.at("maps").list(0, 9)[1].at("box").at("a").count(0, 9), 2u);
  EXPECT_EQ(document.find("missing"), nullptr);
}

TEST(YamlNode, ReadsTheHeaderOfOpenCv)
{
  EXPECT_EQ(parseYaml("a", "%YAML:1.0\n---\nfocal: 520.\n").at("focal").number(0, 1e4),
            520.0);
}

TEST(YamlNode, NamesFileLineColumnAndKey)
{
  const YamlNode document =
      parseYaml("s.yaml", "a: 1\nb: [1, 2]\nc: {d: x}\nn: .nan\nbig: 1e999\nempty:\n");
  const auto fault = [&](const char* key, const auto& read) {
    return faultOf([&] { read(document.at(key)); });
  };
  const auto number = [](const YamlNode& node) { node.number(0, 0.5); };
  EXPECT_THAT(fault("a", number), HasSubstr("s.yaml: line 1, column 4: a: '1'"));
  EXPECT_THAT(fault("b", number), HasSubstr("line 2, column 4: b: a single value"));
  EXPECT_THAT(fault("n", number), HasSubstr("line 4"));
  EXPECT_THAT(fault("big", number), HasSubstr("line 5"));
  EXPECT_THAT(fault("empty", number), HasSubstr("line 6"));
  EXPECT_THAT(fault("b", [](const YamlNode& node) { node.list(3, 3); }),
              HasSubstr("a list of 3 values is needed here, not of 2"));
  EXPECT_THAT(fault("c", [](const YamlNode& node) { node.at("e"); }),
              HasSubstr("line 3, column 4: c: key 'e' is missing"));
  EXPECT_THAT(fault("c", [](const YamlNode& node) { node.at("d").count(0, 9); }),
              HasSubstr("line 3, column 8: d: 'x'"));
  EXPECT_THAT(fault("c",
                    [](const YamlNode& node) {
                      node.requireKeys({"e", "f"});
                    }),
              HasSubstr("line 3, column 5: key 'd' is not known here; known are e, f"));
  EXPECT_THAT(fault("a", [](const YamlNode& node) { node.boolean(); }),
              HasSubstr("true or false"));
  EXPECT_THAT(fault("a", [](const YamlNode& node) { node.keys(); }),
              HasSubstr("a map of keys"));
}

/** An invalid document, and a part of the error message. */
struct BadYaml {
  const char* name;
  std::string text;
  const char* fault;
};

void
PrintTo(const BadYaml& bad, std::ostream* stream)
{
  *stream << bad.name;
}

class BadYamlTest : public testing::TestWithParam<BadYaml> {};

TEST(YamlNode, FaultsAreOnePrintableLine)
{
  const YamlNode document = parseYaml("s.yaml", "\"a\\n\\e[2J\": x\n");
  const YamlNode& key = document.keys().front();
  EXPECT_THAT(faultOf([&] { document.at(key.text()).number(0, 1); }),
              HasSubstr("a??[2J: 'x' is refused"));
  EXPECT_THAT(faultOf([] { parseYaml("s.yaml", "a: \"\\\x1b\"\n"); }),
              EndsWith("unknown escape character: ?"));
}

TEST_P(BadYamlTest, IsRefused)
{
  const std::string fault = faultOf([] { parseYaml("bad.yaml", GetParam().text); });
  EXPECT_THAT(fault, HasSubstr("bad.yaml: "));
  EXPECT_THAT(fault, HasSubstr(GetParam().fault));
}

std::string
repeated(const std::string& text, std::size_t count)
{
  std::string all;
  for (std::size_t i = 0; i < count; ++i)
    all += text;
  return all;
}

INSTANTIATE_TEST_SUITE_P(
    Texts,
    BadYamlTest,
    testing::Values(
        BadYaml{"brace", "a: 1\nb: {c: 2\n", "line"},
        BadYaml{"tab", "a:\n\t- 1\n", "line 2"},
        BadYaml{
            "twice", "a: 1\nb: 2\na: 3\n", "line 3, column 1: key 'a' stands twice"},
        BadYaml{"anchor", "a: &x 1\nb: *x\n", "line 1, column 4: anchors"},
        BadYaml{"alias", "b: *x\n", "line 1"},
        BadYaml{"list", "- 1\n- 2\n", "has no map"},
        BadYaml{"word", "hello\n", "has no map"},
        BadYaml{"comments", "# nothing\n", "has no map"},
        BadYaml{"deep", "a: " + repeated("[", 100000), "nested more than 64 deep"},
        BadYaml{"deepMap", repeated("{a: ", 100000), "nested more than 64 deep"},
        BadYaml{"many", "a: [" + repeated("1,", 300001) + "1]", "300000 values"},
        BadYaml{"mapAsKey", "{[1, 2]: 3}\n", "a single value"},
        BadYaml{"bytes", std::string("a: \xff\xfe\x00 \x01: [\n", 11), ""}));

TEST(YamlFile, OfNoUseIsRefused)
{
  const TemporaryFolder folder;
  EXPECT_THAT(faultOf([&] { loadYaml(folder.path("none.yaml")); }),
              HasSubstr("none.yaml: "));
  EXPECT_THAT(faultOf([&] { loadYaml(folder.write("empty.yaml", "")); }),
              HasSubstr("is empty"));
  const std::string large(std::size_t{17} << 20, ' ');
  EXPECT_THAT(faultOf([&] { loadYaml(folder.write("large.yaml", large)); }),
              HasSubstr("more than a YAML file"));
}

} // namespace
} // namespace pcl::acmap::test
