// Compiled with the flags of the build and run when CMake configures (notes/numerics.md): ends with status 0 if
// arithmetic is plain IEEE, else prints the first thing that is not.
#include <cfloat>
#include <cstdio>
#include <limits>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "fast-math is on"
#endif
#if !defined(FLT_EVAL_METHOD) || FLT_EVAL_METHOD != 0
#error "float expressions are computed in another precision than float"
#endif

namespace {

// Loops over arrays whose values the compiler cannot know, as the rasterizer's are: what it would do there, it does here.
constexpr int kN = 16;
volatile double opaque_zero = 0.0;

int failed(const char* what) {
  std::printf("%s\n", what);
  return 1;
}

/// Quotients by one divisor are an invitation to compute its reciprocal once: 5 · (1/49) differs from 5/49.
bool divides() {
  const double divisor = 49.0 + opaque_zero;
  const double five = 5.0 + opaque_zero;
  volatile double q5 = five / divisor;
  volatile double q6 = (five + 1.0) / divisor;
  volatile double q7 = (five + 2.0) / divisor;
  volatile double q8 = (five + 3.0) / divisor;
  return q5 == 5.0 / 49.0 && q6 == 6.0 / 49.0 && q7 == 7.0 / 49.0 && q8 == 8.0 / 49.0;
}

}  // namespace

int main() {
  double a[kN], b[kN], c[kN], product_sum[kN], resummed[kN];
  for (int i = 0; i < kN; ++i) {
    a[i] = 1.0 + 0x1p-30 + opaque_zero;
    b[i] = 1.0 - 0x1p-30 + opaque_zero;
    c[i] = -1.0 + opaque_zero;
  }
  for (int i = 0; i < kN; ++i) product_sum[i] = a[i] * b[i] + c[i];  // 1 − 2⁻⁶⁰ rounds to 1; fused it is −2⁻⁶⁰
  for (int i = 0; i < kN; ++i) {
    if (product_sum[i] != 0.0) return failed("a * b + c is contracted to a fused multiply-add");
  }

  for (int i = 0; i < kN; ++i) {
    a[i] = 0x1p60 + opaque_zero;
    b[i] = 1.0 + opaque_zero;
  }
  for (int i = 0; i < kN; ++i) resummed[i] = (a[i] + b[i]) - a[i];  // 1 is lost
  for (int i = 0; i < kN; ++i) {
    if (resummed[i] != 0.0) return failed("sums are reordered");
  }

  if (!divides()) return failed("division is done by a reciprocal");

  const double nan = std::numeric_limits<double>::quiet_NaN() + opaque_zero;
  if (nan == nan) return failed("NaN compares equal to itself");
  const double minus_zero = -0.0 * (1.0 + opaque_zero);
  if (!(1.0 / minus_zero < 0.0)) return failed("the sign of zero is lost");
  volatile float smallest = FLT_MIN;
  volatile float denormal = smallest * 0.5f;
  if (!(denormal > 0.0f)) return failed("denormals are flushed to zero");
  return 0;
}
