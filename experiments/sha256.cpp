#include "experiments/sha256.h"

#include <openssl/evp.h>

#include "experiments/error.h"

namespace lode::experiments {

std::string sha256_hex(std::span<const std::byte> bytes) {
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned n_digest = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest, &n_digest, EVP_sha256(), nullptr) != 1) {
    throw Error(Status::machine_failed, "OpenSSL cannot compute SHA-256");
  }
  constexpr char kDigits[] = "0123456789abcdef";
  std::string hex;
  for (unsigned i = 0; i < n_digest; ++i) {
    hex += kDigits[digest[i] >> 4];
    hex += kDigits[digest[i] & 15];
  }
  return hex;
}

}  // namespace lode::experiments
