// The example of notes/adding_a_technique.md, from its header to a row beside the others.
#include <gtest/gtest.h>

#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <iterator>

#include "examples/adding_a_technique/distance_culling.h"
#include "experiments/harness/culling_case.h"
#include "experiments/harness/scene_hash.h"
#include "geometry/procedural.h"

namespace lode::tests {
namespace {

using namespace experiments;

TEST(AddingATechnique, TakesAHeaderAndAnEntry) {
  const TechniqueEntry entry{"distance_culling",
                             "Objects farther than a limit are left out",
                             {{"limit", "world units", 0, 1e9, 100}},
                             [](const ParameterValues& v) {
                               return AnyTechnique(techniques::DistanceCulling{v.at("limit")});
                             }};
  geometry::Scene scene;
  geometry::add_instance(scene, geometry::sphere({-0.6, 0.0, 0.0}, 0.5, 12, 6));
  geometry::add_instance(scene, geometry::sphere({1.5, 0.0, -10.0}, 0.5, 12, 6));
  const techniques::World world(scene, {}, true, 1);
  const raster::RenderOptions options{.threads = 1};
  const Method method{"distance_culling", {&entry, read_parameters("method", entry.parameters, "limit=8")}, false};
  PreparedMethod prepared(method, world, options);
  PreparedMethod* const methods[] = {&prepared};
  CullingCase one;
  one.scene = one.path = "two balls";
  one.scene_hash = hash_of(scene);
  one.frames = {0}, one.size_px = {80, 60}, one.n_rounds = 0;
  geometry::look_at(one.cameras.emplace_back(), {0.0, 0.0, 5.0}, {0.0, 0.0, 0.0});
  const CaseResult result = run_culling_case(one, world, methods, KeptResults(""), options, [] {});
  // The far ball is 14.5 units away: culled, though it can be seen, so that the row tells of an error.
  EXPECT_EQ(result.results[0].number("culled"), 1.0);
  EXPECT_EQ(result.results[0].number("false_objects"), 1.0);
  EXPECT_GT(result.results[0].number("false_px"), 0.0);
  EXPECT_EQ(result.results[0].text("promise"), "approximate");
}

TEST(AddingATechnique, HasANoteThatShowsTheHeaderAsItIs) {
  const auto text_of = [](const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  };
  const std::string source = LODESTONE_SOURCE_DIR;
  const std::string header = text_of(source + "/examples/adding_a_technique/distance_culling.h");
  ASSERT_FALSE(header.empty());
  EXPECT_NE(text_of(source + "/notes/adding_a_technique.md").find(header), std::string::npos);
}

}  // namespace
}  // namespace lode::tests
