/// Writes the number tables of raster/ with MPFR, every entry correctly rounded:
///
///   make_raster_tables srgb > raster/srgb_tables.h
///   make_raster_tables level_of_detail > raster/level_of_detail_table.h
///
/// The tests prove the tables by other formulas; this program only has to be run when a table changes its shape.

#include <mpfr.h>

#include <cstdio>
#include <cstring>

namespace {

constexpr mpfr_prec_t kPrecision_bits = 256;

/// v = ((v + 0.055) / 1.055)^2.4, or v / 12.92 up to 0.04045: IEC 61966-2-1, encoded to linear.
void decode(mpfr_t v) {
  mpfr_t bound, constant;
  mpfr_inits2(kPrecision_bits, bound, constant, static_cast<mpfr_ptr>(nullptr));
  mpfr_set_str(bound, "0.04045", 10, MPFR_RNDN);
  if (mpfr_lessequal_p(v, bound)) {
    mpfr_set_str(constant, "12.92", 10, MPFR_RNDN);
    mpfr_div(v, v, constant, MPFR_RNDN);
  } else {
    mpfr_set_str(constant, "0.055", 10, MPFR_RNDN);
    mpfr_add(v, v, constant, MPFR_RNDN);
    mpfr_set_str(constant, "1.055", 10, MPFR_RNDN);
    mpfr_div(v, v, constant, MPFR_RNDN);
    mpfr_set_str(constant, "2.4", 10, MPFR_RNDN);
    mpfr_pow(v, v, constant, MPFR_RNDN);
  }
  mpfr_clears(bound, constant, static_cast<mpfr_ptr>(nullptr));
}

void write_header(const char* comment) {
  std::printf("#pragma once\n%s///\n/// Written by tests/raster/make_raster_tables.cpp; not edited by hand.\n\n",
              comment);
}

void write_srgb() {
  write_header(
      "/// sRGB by table (C9). kSrgbDecode[c]: the float nearest to the linear value of code c. kSrgbEncode[k], k > "
      "0:\n"
      "/// the smallest float whose code ⌊255 · encode(x) + ½⌋ is at least k; entry 0 only fills the place.\n");
  std::printf("namespace lode::raster {\n\n");
  mpfr_t v;
  mpfr_init2(v, kPrecision_bits);
  std::printf("inline constexpr float kSrgbDecode[256] = {\n");
  for (unsigned long code = 0; code < 256; ++code) {
    mpfr_set_ui(v, code, MPFR_RNDN);
    mpfr_div_ui(v, v, 255, MPFR_RNDN);
    decode(v);
    std::printf("%s%af,%s", code % 5 == 0 ? "    " : " ", double{mpfr_get_flt(v, MPFR_RNDN)},
                code % 5 == 4 || code == 255 ? "\n" : "");
  }
  std::printf("};\n\ninline constexpr float kSrgbEncode[256] = {\n");
  for (unsigned long code = 0; code < 256; ++code) {
    mpfr_set_ui(v, code > 0 ? 2 * code - 1 : 0, MPFR_RNDN);
    mpfr_div_ui(v, v, 510, MPFR_RNDN);
    decode(v);
    std::printf("%s%af,%s", code % 5 == 0 ? "    " : " ", double{mpfr_get_flt(v, MPFR_RNDU)},
                code % 5 == 4 || code == 255 ? "\n" : "");
  }
  std::printf("};\n\n}  // namespace lode::raster\n");
  mpfr_clear(v);
}

void write_level_of_detail() {
  write_header(
      "/// kLog2Threshold[k]: the smallest double that is at least 2^((k + ½)/128), k = 0…127: the bounds between the\n"
      "/// 129 steps that round(128 · log2(m)) makes of m in [1, 2).\n");
  std::printf("namespace lode::raster {\n\ninline constexpr double kLog2Threshold[128] = {\n");
  mpfr_t v;
  mpfr_init2(v, kPrecision_bits);
  for (unsigned long k = 0; k < 128; ++k) {
    mpfr_set_ui(v, 2 * k + 1, MPFR_RNDN);
    mpfr_div_ui(v, v, 256, MPFR_RNDN);
    mpfr_exp2(v, v, MPFR_RNDN);
    std::printf("%s%a,%s", k % 4 == 0 ? "    " : " ", mpfr_get_d(v, MPFR_RNDU), k % 4 == 3 ? "\n" : "");
  }
  std::printf("};\n\n}  // namespace lode::raster\n");
  mpfr_clear(v);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "srgb") == 0) {
    write_srgb();
  } else if (argc == 2 && std::strcmp(argv[1], "level_of_detail") == 0) {
    write_level_of_detail();
  } else {
    std::fprintf(stderr, "usage: make_raster_tables srgb|level_of_detail\n");
    return 2;
  }
  return 0;
}
