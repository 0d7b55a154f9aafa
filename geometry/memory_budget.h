#pragma once
/// How much memory reading may take: one GiB, and eight times the bytes of the files that are read. What a header only
/// claims is charged before it is allocated, so that a small file never takes a large machine down.

#include <cstdint>
#include <string>

#include "geometry/error.h"

namespace lode::geometry {

class MemoryBudget {
 public:
  /// A file's bytes are in memory now; they allow for seven times as much again.
  void add_file(std::uint64_t n_bytes) { left_ += 7 * n_bytes; }

  /// Throws Error (bad_input), naming `where`, if less than this is left; after that it is taken.
  void take(std::uint64_t n_bytes, const std::string& where) {
    if (n_bytes > left_) {
      throw Error(ErrorKind::bad_input, where + ": claims " + std::to_string(n_bytes >> 20) +
                                            " MiB of memory: expected at most 8 times the bytes of the files and 1 "
                                            "GiB, of which " +
                                            std::to_string(left_ >> 20) + " MiB are left");
    }
    left_ -= n_bytes;
  }
  void give_back(std::uint64_t n_bytes) { left_ += n_bytes; }

 private:
  /// An eighth of the GiB is for the program itself, and for what libraries take.
  std::uint64_t left_ = (std::uint64_t(1) << 30) - (std::uint64_t(1) << 27);
};

}  // namespace lode::geometry
