#pragma once
/// The data of a PLY file, element by element, whatever its format.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/model_file/ply/ply_header.h"

namespace lode::geometry {

/// One element as it stands in the file. A double holds every type's values.
struct PlyRow {
  std::vector<double> values;              ///< [properties]; of a list, its length
  std::vector<std::vector<double>> lists;  ///< [properties]; of what is no list, empty
};

/// Reads elements in the file's order.
class PlyRows {
 public:
  virtual ~PlyRows() = default;
  /// The next element's values; all of `element`'s come before those of the one after it in the header. Throws Error
  /// (bad_input), naming line or byte, if the file ends or holds something else there.
  virtual void read(const PlyElement& element, PlyRow& row) = 0;
  /// Throws Error (bad_input): where the last element stands, and what is wrong with it.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  [[nodiscard]] virtual std::string place() const = 0;
};

[[nodiscard]] std::unique_ptr<PlyRows> ply_rows(const PlyHeader& header, std::string_view text,
                                                const std::string& name);

}  // namespace lode::geometry
