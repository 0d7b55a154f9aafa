#include "experiments/truth/check_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

namespace lode::experiments::truth {
namespace {

using testing::HasSubstr;

CheckedView view_with(std::uint64_t n_edge, std::size_t n_unexplained) {
  CheckedView view{"front", " --eye 1,2,3 --look-at 0,0,0", {}};
  view.check.picture.verdicts.resize(100);
  view.check.picture.pixels[std::size_t(Verdict::edge)] = n_edge;
  view.check.picture.pixels[std::size_t(Verdict::unexplained)] = n_unexplained;
  for (std::size_t i = 0; i < std::min(n_unexplained, kMaxExamples); ++i) {
    view.check.picture.examples.push_back({{int(i), 7}, {3, 14}, {raster::kNoId, raster::kNoId}, 0.25f, "it is wrong"});
  }
  view.check.edges.length_px = 1000.0;  // at 2δ: 5.52 samples
  return view;
}

TEST(CheckReport, SumsViewsUp) {
  const CheckReport report{"model.glb", {10, 10}, {view_with(6, 0), view_with(1, 2)}};
  EXPECT_EQ(report.unexplained(), 2u);
  const nlohmann::json json = nlohmann::json::parse(check_json(report));
  EXPECT_EQ(json["pixels"], 200);
  EXPECT_EQ(json["different"], 9);
  EXPECT_EQ(json["explained"]["edge"], 7);
  EXPECT_EQ(json["unexplained"], 2);
  EXPECT_EQ(json["cameras"].size(), 2u);
}

TEST(CheckReport, TheEdgeBoundHoldsUpToTheNextWholeSample) {
  EXPECT_TRUE(view_with(6, 0).check.edge_bound_holds());
  EXPECT_FALSE(view_with(7, 0).check.edge_bound_holds());
  const CheckReport report{"model.glb", {10, 10}, {view_with(6, 0), view_with(7, 0)}};
  EXPECT_FALSE(nlohmann::json::parse(check_json(report))["edge_bound_holds"]);
}

TEST(CheckReport, NamesUnexplainedPixelsWithTheCommandThatShowsThem) {
  std::ostringstream err;
  EXPECT_EQ(conclude({"model.glb", {640, 400}, {view_with(0, 1)}}, err), Status::check_failed);
  EXPECT_EQ(err.str(),
            "lodestone: pixel 0,7: raster (3, 14) at depth 0.25, rays nothing: it is wrong\n"
            "  lodestone explain model.glb 0,7 --size 640x400 --eye 1,2,3 --look-at 0,0,0\n");
}

TEST(CheckReport, QuotesAPathThatTheShellWouldTakeApart) {
  std::ostringstream err;
  EXPECT_EQ(conclude({"my model's.glb", {64, 64}, {view_with(0, 1)}}, err), Status::check_failed);
  EXPECT_THAT(err.str(), HasSubstr(R"(lodestone explain 'my model'\''s.glb' 0,7)"));
}

TEST(CheckReport, PassesWhereAllIsExplained) {
  std::ostringstream err;
  EXPECT_EQ(conclude({"model.glb", {640, 400}, {view_with(8, 0), view_with(3, 0)}}, err), Status::done);
  EXPECT_EQ(err.str(), "");
}

TEST(CheckReport, NamesTenInAll) {
  std::ostringstream err;
  EXPECT_EQ(conclude({"model.glb", {640, 400}, {view_with(0, 8), view_with(0, 12)}}, err), Status::check_failed);
  const std::string text = err.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 20);
}

}  // namespace
}  // namespace lode::experiments::truth
