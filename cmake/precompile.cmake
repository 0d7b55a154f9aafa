# lodestone_precompile(TARGET HEADER...) parses headers once for the target instead of once a file. Only those of third
# parties and of the standard library: a header of ours would have everything built again when it changes. Every file
# still includes what it uses; the preset debug, without precompiled headers, tells where one does not.
function(lodestone_precompile target)
  if(LODESTONE_PCH)
    list(TRANSFORM ARGN REPLACE "(.+)" "<\\1>")
    target_precompile_headers(${target} PRIVATE ${ARGN})
    lodestone_forgive_precompiled(${target})
  endif()
endfunction()
# The same headers for a target that is built with the same flags and definitions.
function(lodestone_precompile_as target other)
  if(LODESTONE_PCH)
    target_precompile_headers(${target} REUSE_FROM ${other})
    lodestone_forgive_precompiled(${target})
  endif()
endfunction()
# GCC 12 forgets which precompiled headers are the system's, and gives false alarms in std::string (GCC bug 105329).
function(lodestone_forgive_precompiled target)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE -Wno-stringop-overflow -Wno-array-bounds)
  endif()
endfunction()
