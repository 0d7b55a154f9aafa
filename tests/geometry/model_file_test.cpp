/// What holds for model files of every format.

#include "geometry/model_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/geometry/model_reading.h"

namespace lode::geometry {
namespace {

using tests::model_error;
using tests::TemporaryFolder;

constexpr const char* kEndings[] = {".gltf", ".glb", ".obj", ".ply", ".stl"};

TEST(ModelFile, FormatsGoByTheEnding) {
  for (const char* path : {"a.gltf", "b/c.GLB", "x.y.obj", "a.Ply", "a.stl"}) EXPECT_TRUE(is_model_file(path)) << path;
  for (const char* path : {"", "obj", ".obj", "dir/.obj", "a.obj/", "a.fbx", "grass:cells=4"}) {
    EXPECT_FALSE(is_model_file(path)) << path;
  }
}

TEST(ModelFileErrors, AnUnknownEndingIsNamed) {
  const TemporaryFolder folder;
  EXPECT_EQ(model_error(folder.write("a.fbx", "x")), "unknown ending: expected .gltf, .glb, .obj, .ply or .stl");
}

TEST(ModelFileErrors, WhatCannotBeReadIsNamed) {
  for (const std::string ending : kEndings) {
    const TemporaryFolder folder;
    EXPECT_EQ(model_error(folder.path("none" + ending)), "cannot be read: No such file or directory");
    EXPECT_EQ(model_error(folder.write("empty" + ending, "")), "is empty");
    ASSERT_EQ(::mkdir(folder.path("folder" + ending).c_str(), 0700), 0);
    EXPECT_EQ(model_error(folder.path("folder" + ending)), "is a directory: expected a file");
    ASSERT_EQ(::mkfifo(folder.path("pipe" + ending).c_str(), 0600), 0);
    EXPECT_EQ(model_error(folder.path("pipe" + ending)), "is a device or pipe: expected a file");
    if (::geteuid() == 0) continue;  // root may read everything
    const std::string secret = folder.write("secret" + ending, "x");
    ::chmod(secret.c_str(), 0);
    EXPECT_EQ(model_error(secret), "cannot be read: Permission denied");
  }
}

TEST(ModelFileErrors, WhatIsAnotherFormatIsOneLine) {
  for (const std::string ending : kEndings) {
    EXPECT_NE(model_error("a" + ending, "\x89PNG\r\n\x1a\n and then some"), "") << ending;
    EXPECT_NE(model_error("a" + ending, std::string(1000, '\xFF')), "") << ending;
  }
}

TEST(ModelFile, ASceneIsNamedAfterItsPath) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.obj", "v 0 0 0\np 1\n");
  EXPECT_EQ(read_model_file(path).name, path);
}

}  // namespace
}  // namespace lode::geometry
