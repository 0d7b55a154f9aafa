#include "geometry/npy_file.h"

#include <bit>
#include <string>

namespace lode::geometry {

static_assert(std::endian::native == std::endian::little, "arrays are written as they lie in memory");

void write_npy(OutputFile& file, std::string_view descr, std::initializer_list<int> shape,
               std::span<const std::byte> bytes) {
  std::string header = "{'descr': '" + std::string(descr) + "', 'fortran_order': False, 'shape': (";
  for (const int n : shape) header += std::to_string(n) + ", ";
  header += "), }";

  // Magic word (6), version (2) and header length (2) come first; spaces and a newline fill up to 64 bytes.
  constexpr std::size_t kPreamble = 10;
  const std::size_t n_bytes = (kPreamble + header.size() + 1 + 63) / 64 * 64 - kPreamble;
  header.resize(n_bytes - 1, ' ');
  header += '\n';
  const unsigned char preamble[kPreamble] = {0x93,
                                             'N',
                                             'U',
                                             'M',
                                             'P',
                                             'Y',
                                             1,
                                             0,
                                             static_cast<unsigned char>(n_bytes & 255),
                                             static_cast<unsigned char>(n_bytes >> 8)};
  file.write(preamble, sizeof preamble);
  file.write(header.data(), header.size());
  file.write(bytes.data(), bytes.size());
  file.check();
}

}  // namespace lode::geometry
