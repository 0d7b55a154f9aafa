#pragma once
/// Reading models that a test writes, and the one line that a bad one gives.

#include <gtest/gtest.h>

#include <string>

#include "geometry/error.h"
#include "geometry/model_file.h"
#include "tests/geometry/temporary_folder.h"

namespace lode::tests {

/// The scene of a file with these bytes; the name's ending is its format.
inline geometry::Scene read_model(const std::string& name, const std::string& bytes) {
  const TemporaryFolder folder;
  return geometry::read_model_file(folder.write(name, bytes));
}

/// What is wrong with a file: the error's line, after the path. A failure if there is none, if it is not one line, or
/// if it does not begin with the path.
inline std::string model_error(const std::string& path) {
  try {
    (void)geometry::read_model_file(path);
  } catch (const geometry::Error& error) {
    const std::string text = error.what();
    EXPECT_EQ(error.kind(), geometry::ErrorKind::bad_input) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    EXPECT_TRUE(text.starts_with(path + ": ")) << text;
    return text.substr(std::min(text.size(), path.size() + 2));
  }
  ADD_FAILURE() << path << ": no error";
  return "";
}

/// The same for a file with these bytes.
inline std::string model_error(const std::string& name, const std::string& bytes) {
  const TemporaryFolder folder;
  return model_error(folder.write(name, bytes));
}

}  // namespace lode::tests
