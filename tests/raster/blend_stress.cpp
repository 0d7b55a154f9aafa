#include <gtest/gtest.h>

#include "blend_oracle.h"
#include "stress_count.h"

namespace lode::raster {
namespace {

TEST(Blend8Stress, EveryEquationEqualsTheRationalResultForEverySourceDestinationAlpha) {
  const auto n = test::stress_count("(source, destination, alpha) cases per equation", 1u << 24, 1u << 24);
  ASSERT_EQ(n, 256u * 256u * 256u);
  for (const Blend blend : {Blend::over, Blend::add}) {
    int wrong = 0;
    for (int s = 0; s < 256; ++s) wrong += test::wrong_blends(blend, s);
    EXPECT_EQ(wrong, 0) << "equation " << static_cast<int>(blend);
  }
}

}  // namespace
}  // namespace lode::raster
