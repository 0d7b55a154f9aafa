#include "raster/reference/exact_sum.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>

#include "hashed_numbers.h"

namespace lode::raster::reference {
namespace {

double random_double(test::HashedNumbers& numbers, int largest_exponent) {
  const double size = std::ldexp(numbers.unit() - 0.5, numbers.between(-largest_exponent, largest_exponent));
  return numbers.below(8) == 0 ? std::rint(size) : size;
}

TEST(ExactSum, OfProductsThatCancelIsWithinOneUlpOfTheRationalSum) {
  test::HashedNumbers numbers(1);
  for (int k = 0; k < 20'000; ++k) {
    // (x·y + z)·f − x·y·f up to a little, in pieces of any size: most of the sum cancels.
    const double x = random_double(numbers, 300), y = random_double(numbers, 27), z = random_double(numbers, 300);
    const double f = random_double(numbers, 100), rest = random_double(numbers, 400);
    ExactSum inner;
    inner.add_product(x, y);
    inner.add(z);
    ExactSum sum;
    sum.add_product(inner, f);
    sum.add_product(x, -y);
    sum.add_product(inner, -f);
    sum.add(rest);
    const mpq_class exact = mpq_class(rest) - mpq_class(x) * mpq_class(y);
    const double got = sum.value();
    const double ulp = std::nextafter(std::abs(got), INFINITY) - std::abs(got);
    ASSERT_LE(abs(mpq_class(got) - exact), mpq_class(ulp)) << "case " << k;
  }
}

TEST(ExactSum, OfNothingOrOfWhatCancelsIsZero) {
  ExactSum sum;
  EXPECT_EQ(sum.value(), 0.0);
  sum.add_product(0.1, 0.3);
  sum.add_product(-0.3, 0.1);
  EXPECT_EQ(sum.value(), 0.0);
}

}  // namespace
}  // namespace lode::raster::reference
