/// What may change between a run and its resumption.
#include "io/checkpoint/compare_scenes.h"

#include <gmock/gmock.h>

namespace abut {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

TEST(ForbiddenChanges, NoneOfTheSameSceneInAnyOrderOfKeys) {
    EXPECT_THAT(forbidden_changes(R"({"a": 1, "b": [1, {"c": 2}]})", R"({"b": [1, {"c": 2}], "a": 1})"), IsEmpty());
    EXPECT_THAT(forbidden_changes(R"({"a": 1})", R"({"a": 1.0})"), IsEmpty());
}

TEST(ForbiddenChanges, EndTitleAndOutputAreFree) {
    EXPECT_THAT(
        forbidden_changes(
            R"({"time": {"end": 1}, "title": "a", "abut_version": "0.1", "output": {"every": 1, "grid": {"write": true}}})",
            R"({"time": {"end": 2}, "title": "b", "abut_version": "0.2", "$schema": "x",
                        "output": {"grid": {"write": false, "arrays": ["mass"]}, "live": true, "pairs": true}})")
            .size(),
        1U)
        << "but whether there is pairs.csv";
    EXPECT_THAT(forbidden_changes(R"({"output": {"pairs": true}})", R"({"output": {"pairs": false}})"),
                ElementsAre("/output/pairs: was true, is false"));
}

TEST(ForbiddenChanges, FilesMayLieElsewhere) {
    EXPECT_THAT(forbidden_changes(R"({"images": [{"file": "/a/b.png", "pixel": 1}]})",
                                  R"({"images": [{"file": "/c/b.png", "pixel": 2}]})"),
                ElementsAre("/images/0/pixel: was 1, is 2"));
    EXPECT_THAT(forbidden_changes(R"({"profile": 1})", R"({"profile": 2})").size(), 1U);
}

TEST(ForbiddenChanges, NothingElseIs) {
    EXPECT_THAT(forbidden_changes(R"({"time": {"end": 1, "cfl": 0.4}})", R"({"time": {"end": 1, "cfl": 0.3}})"),
                ElementsAre("/time/cfl: was 0.4, is 0.3"));
    EXPECT_THAT(forbidden_changes(R"({"a": {"b": 1}, "time": {"end": 1}})", R"({"c": [1], "time": {"end": 1}})"),
                UnorderedElementsAre("/a: {\"b\":1} is gone", "/c: [1] was not there"));
    EXPECT_THAT(
        forbidden_changes(R"({"bodies": [{"name": "x"}]})", R"({"bodies": [{"name": "y"}, {"name": "z"}]})"),
        UnorderedElementsAre("/bodies/0/name: was \"x\", is \"y\"", "/bodies/-: {\"name\":\"z\"} was not there"));
    EXPECT_THAT(forbidden_changes(R"({"bodies": [1, 2, 3]})", R"({"bodies": [1]})").size(), 2U);
    // Names that only begin or end like a free one.
    EXPECT_THAT(forbidden_changes(R"({"outputs": {"every": 1}, "title2": 1, "x": {"title": 1}})",
                                  R"({"outputs": {"every": 2}, "title2": 2, "x": {"title": 2}})")
                    .size(),
                3U);
}

TEST(ForbiddenChanges, WholeSectionsThatComeOrGo) {
    // Whether a scene has `output` or `time` at all: a resolved scene always has; no way around the rules.
    EXPECT_THAT(forbidden_changes(R"({"time": {"end": 1}})", R"({})").size(), 1U);
    EXPECT_THAT(forbidden_changes(R"({"output": {"pairs": true}})", R"({"output": 5})").size(), 1U);
}

TEST(ForbiddenChanges, LongValuesAreShortened) {
    const std::string text = "{\"a\": \"" + std::string(500, 'x') + "\"}";
    const auto changes = forbidden_changes(text, R"({"a": ""})");
    ASSERT_EQ(changes.size(), 1U);
    EXPECT_LT(changes[0].size(), 100U);
}

} // namespace
} // namespace abut
