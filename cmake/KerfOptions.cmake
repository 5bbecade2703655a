# Build switches. One interface target carries warnings and sanitizers to every folder's target.
option(KERF_WERROR "Treat warnings as errors" ON)
option(KERF_BENCH "Build tests/bench (Google Benchmark)" ON)
option(KERF_FUZZ "Build tests/fuzz (clang's libFuzzer)" OFF)
set(KERF_UNITY 12 CACHE STRING "Files of app, db and ui compiled as one; 0 while working on them: only what changed is compiled again")
set(KERF_SANITIZE "" CACHE STRING "Sanitizers: empty, 'address,undefined' or 'thread'")

find_program(KERF_CCACHE ccache)
if(KERF_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Sloppiness: a precompiled header would otherwise make every file a miss.
  set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_BASEDIR=${CMAKE_SOURCE_DIR}
      CCACHE_NOHASHDIR=1 ${KERF_CCACHE})
endif()

add_library(kerf_options INTERFACE)
target_include_directories(kerf_options INTERFACE ${CMAKE_SOURCE_DIR})
target_compile_options(kerf_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-align
  -Wdouble-promotion -Wformat=2 -Wnull-dereference -Wduplicated-cond -Wlogical-op
  -ffp-contract=off)  # same digits with and without fused multiply-add hardware
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # The compiler tidies its memory a tenth of its time; below a gigabyte it need not.
  target_compile_options(kerf_options INTERFACE --param=ggc-min-heapsize=1000000)
endif()
if(KERF_WERROR)
  target_compile_options(kerf_options INTERFACE -Werror)
endif()
if(KERF_SANITIZE)
  target_compile_options(kerf_options INTERFACE -fsanitize=${KERF_SANITIZE} -fno-omit-frame-pointer -Wno-null-dereference -Wno-tsan -Wno-maybe-uninitialized)
  target_link_options(kerf_options INTERFACE -fsanitize=${KERF_SANITIZE})
  target_compile_definitions(kerf_options INTERFACE KERF_SANITIZED=1)
endif()

if(KERF_FUZZ)
  # Which edges were taken, and no more: hooks at every comparison made an input three times slower.
  target_compile_options(kerf_options INTERFACE -fsanitize-coverage=inline-8bit-counters,pc-table)
endif()

# A faster linker where there is one: ninety test programs are linked.
find_program(KERF_MOLD mold)
if(KERF_MOLD AND NOT KERF_SANITIZE)
  target_link_options(kerf_options INTERFACE -fuse-ld=mold)
endif()
