# WebAssembly by Debian's Emscripten, run by Node. The program is one file: Emscripten 3.1.6 would fetch a second one,
# which Node from version 18 on takes for an address on the net.
set(CMAKE_CXX_FLAGS_INIT "-fexceptions -include ${CMAKE_CURRENT_LIST_DIR}/library.h")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-sSINGLE_FILE=1 -sALLOW_MEMORY_GROWTH=1 -sNODERAWFS=1")
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
