# cmake --install: lodestone::raster for find_package, its headers under include/lodestone/raster/.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(public_headers clusters.h error.h explain.h frame.h golden.h image.h render.h shader.h srgb.h stats.h texture.h)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/lodestone)
install(TARGETS lodestone_raster EXPORT lodestone-targets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/lodestone)
install(EXPORT lodestone-targets NAMESPACE lodestone:: DESTINATION ${package_dir})
list(TRANSFORM public_headers PREPEND raster/)
install(FILES ${public_headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/lodestone/raster)
configure_package_config_file(cmake/lodestone-config.cmake.in lodestone-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(lodestone-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/lodestone-config.cmake ${PROJECT_BINARY_DIR}/lodestone-config-version.cmake
        DESTINATION ${package_dir})
