/// Scenes of real models say what is missing. (kit_scenes_stress.cpp looks at the scenes themselves.)

#include "geometry/procedural/kit_scenes.h"

#include <gtest/gtest.h>

#include <string>

#include "geometry/error.h"

namespace lode::geometry {
namespace {

TEST(KitScenesErrors, AFolderThatIsNotThereIsOneLineThatNamesTheFile) {
  try {
    (void)kit_city("no/such/folder", 1);
    FAIL() << "expected an Error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("no/such/folder/road_"), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace lode::geometry
