/// `list`, and that what it lists can be used.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/experiments/run_program.h"

namespace lode::tests {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

nlohmann::json listed(const Arguments& more) {
  Arguments arguments = {"list", "--json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome run = run_lodestone(arguments);
  EXPECT_EQ(run.status, 0) << run.err;
  return nlohmann::json::parse(run.out);
}

/// Renders the scene, one pixel.
int render_status(const std::string& scene) { return run_lodestone({"render", scene, "--size", "1x1"}).status; }

TEST(List, HasScenesTechniquesAndExperiments) {
  const auto all = listed({});
  EXPECT_EQ(all.size(), 3u);
  EXPECT_EQ(all["scenes"][0]["name"], "sphere");
  EXPECT_EQ(all["techniques"][0]["name"], "plain");
  EXPECT_TRUE(all["experiments"].is_array());
  EXPECT_GE(listed({"techniques"}).size(), 1u);
}

TEST(List, ScenesTakeTheParametersThatAreListed) {
  const auto scenes = listed({"scenes"})["scenes"];
  for (const auto& scene : scenes) {
    const std::string name = scene["name"];
    // Large ones are made in tests of their own; those of kits need models.
    const bool drawn = !name.starts_with("kit_") && name != "town179" && name != "interior124";
    if (drawn) {
      EXPECT_EQ(render_status(name), 0) << name;
    }
    for (const auto& p : scene["parameters"]) {
      const std::string word = name + ":" + p["name"].get<std::string>() + "=";
      if (drawn) {
        EXPECT_EQ(render_status(word + p["default"].dump()), 0) << word;
        EXPECT_EQ(render_status(word + p["low"].dump()), 0) << word;
      }
      EXPECT_EQ(render_status(word + "1e300"), 3) << word;
      EXPECT_EQ(render_status(word + "-1e300"), 3) << word;
      if (p["whole"]) {
        EXPECT_EQ(render_status(word + "8.5"), 3) << word;
      }
    }
  }
}

TEST(List, TextHasDefaultsAndRanges) {
  const Outcome run = run_lodestone({"list", "scenes"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.out, HasSubstr("\n  interior124  A flat of"));  // the longest name
  EXPECT_THAT(run.out, HasSubstr("\n  torus        A ring around the y axis"));
  EXPECT_THAT(run.out, ContainsRegex("\n    tube=0.4 +radius of the tube \\(1e-06 to 1e\\+06\\)"));
  EXPECT_THAT(run.out, Not(HasSubstr("plain")));
  EXPECT_THAT(run_lodestone({"list"}).out, HasSubstr("techniques:\n  plain"));
}

TEST(List, TechniquesSayWhatTheyPromise) {
  const auto techniques = listed({"techniques"})["techniques"];
  const auto promise_of = [&](const std::string& name) -> std::string {
    for (const auto& technique : techniques) {
      if (technique["name"] == name) return technique["promise"];
    }
    return "not listed";
  };
  EXPECT_EQ(promise_of("plain"), "exact");
  EXPECT_EQ(promise_of("inner_boxes"), "conservative, continuous");
  EXPECT_EQ(promise_of("hierarchical_z"), "conservative, sampled");
  EXPECT_EQ(promise_of("image_reuse"), "approximate");
  EXPECT_THAT(run_lodestone({"list", "techniques"}).out, HasSubstr("The scene as it is: every object is drawn; exact\n"));
  EXPECT_FALSE(listed({"scenes"})["scenes"][0].contains("promise"));
}

TEST(List, AnotherKindIsWrongUsage) {
  const Outcome run = run_lodestone({"list", "colours"});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err, "lodestone: list: expected scenes, techniques or experiments, found \"colours\"\n");
}

}  // namespace
}  // namespace lode::tests
