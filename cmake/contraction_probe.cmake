# Stops the configuration if the build's flags let the compiler change floating-point results. The library itself is
# compiled with -ffp-contract=off after all other flags; everything else about the flags is tested as it is.
function(lodestone_probe_contraction)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" config)
  get_directory_property(options COMPILE_OPTIONS)
  string(JOIN " " flags ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${config}} ${options})

  # What is asked for by name is refused by name: shaders are compiled into other targets with these flags.
  if(flags MATCHES "(^| )(-ffast-math|-Ofast|-funsafe-math-optimizations|-fassociative-math|-freciprocal-math|-ffinite-math-only|-fno-signed-zeros|-ffp-model=(fast|aggressive)|-ffp-contract=(fast|on|fast-honor-pragmas))( |$)")
    message(FATAL_ERROR "lodestone's pixels are defined in plain IEEE arithmetic: take ${CMAKE_MATCH_2} out of the compiler flags (${flags})")
  endif()

  if("${CMAKE_CXX_COMPILER} ${flags}" STREQUAL "${LODESTONE_PROBED_FLAGS}")
    return()
  endif()
  set(probe ${PROJECT_SOURCE_DIR}/cmake/contraction_probe.cpp)
  set(CMAKE_TRY_COMPILE_CONFIGURATION "${CMAKE_BUILD_TYPE}")
  set(probe_flags COMPILE_DEFINITIONS ${options} -ffp-contract=off)
  if(CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
    try_compile(compiles SOURCES ${probe} ${probe_flags} NO_CACHE OUTPUT_VARIABLE output)
    set(ends_with 0)
    message(STATUS "Floating-point contraction: compiled only, a cross build without an emulator cannot run the probe")
  else()
    try_run(ends_with compiles SOURCES ${probe} ${probe_flags} NO_CACHE
            COMPILE_OUTPUT_VARIABLE output RUN_OUTPUT_VARIABLE finding)
  endif()
  if(NOT compiles)
    message(FATAL_ERROR "The floating-point probe does not compile with these flags (${flags}):\n${output}")
  elseif(NOT ends_with STREQUAL "0")
    message(FATAL_ERROR "lodestone's pixels are defined in plain IEEE arithmetic, and with these flags (${flags}) ${finding} (status ${ends_with})")
  endif()
  message(STATUS "Floating-point contraction and fast-math: off")
  set(LODESTONE_PROBED_FLAGS "${CMAKE_CXX_COMPILER} ${flags}" CACHE INTERNAL "Flags that the floating-point probe has passed with")
endfunction()
