#include "experiments/truth/rational.h"

#include <cmath>
#include <limits>

namespace lode::experiments::truth {

double rounded_down(const Rational& number) {
  const double cut = number.get_d();
  return Rational(cut) <= number ? cut : std::nextafter(cut, -std::numeric_limits<double>::infinity());
}

double rounded_up(const Rational& number) {
  const double cut = number.get_d();
  return Rational(cut) >= number ? cut : std::nextafter(cut, std::numeric_limits<double>::infinity());
}

}  // namespace lode::experiments::truth
