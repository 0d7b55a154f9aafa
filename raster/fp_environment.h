#pragma once
/// Sets the floating-point environment that pixels are defined in (round to nearest even, denormals kept, no
/// traps) for a scope, and puts the caller's back afterwards: ray tracers recommend FTZ/DAZ, and a caller may
/// have changed the rounding mode.

#include <cstdint>
#if defined(__x86_64__) || defined(__i386__)
#include <xmmintrin.h>
#endif

namespace lode::raster {

class FpEnvironment {
 public:
  FpEnvironment() : saved_(read()) { write(kDefault); }
  ~FpEnvironment() { write(saved_); }
  FpEnvironment(const FpEnvironment&) = delete;
  FpEnvironment& operator=(const FpEnvironment&) = delete;

 private:
#if defined(__x86_64__) || defined(__i386__)
  static constexpr std::uint64_t kDefault = 0x1F80;  // MXCSR: all exceptions masked, nearest, no FTZ, no DAZ
  static std::uint64_t read() { return _mm_getcsr(); }
  static void write(std::uint64_t value) { _mm_setcsr(static_cast<unsigned>(value)); }
#elif defined(__aarch64__)
  static constexpr std::uint64_t kDefault = 0;  // FPCR: nearest, no flush to zero
  static std::uint64_t read() {
    std::uint64_t value;
    asm volatile("mrs %0, fpcr" : "=r"(value) : : "memory");
    return value;
  }
  static void write(std::uint64_t value) { asm volatile("msr fpcr, %0" : : "r"(value) : "memory"); }
#else  // WebAssembly: the environment cannot be changed
  static constexpr std::uint64_t kDefault = 0;
  static std::uint64_t read() { return 0; }
  static void write(std::uint64_t) {}
#endif
  std::uint64_t saved_;
};

}  // namespace lode::raster
