# Precompiled headers, one per kind of target. The compiler takes one only with the same definitions, so what differs per
# target (a version, a test's folder) is given to the one file that needs it.
set(CMAKE_PCH_WARN_INVALID OFF)
function(kerf_pch kind)
  cmake_parse_arguments(ARG "" "" "HEADERS;LINK" ${ARGN})
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/pch/kerf_pch_${kind}.cpp
       CONTENT "// only here so that the precompiled header has a target\n")
  add_library(kerf_pch_${kind} OBJECT ${CMAKE_BINARY_DIR}/pch/kerf_pch_${kind}.cpp)
  target_link_libraries(kerf_pch_${kind} PRIVATE kerf_options ${ARG_LINK})
  target_precompile_headers(kerf_pch_${kind} PRIVATE ${ARG_HEADERS})
  kerf_optimise(kerf_pch_${kind} ${kind})
endfunction()
function(kerf_precompile target kind)
  target_precompile_headers(${target} REUSE_FROM kerf_pch_${kind})
  kerf_optimise(${target} ${kind})
endfunction()

# How far each kind is optimised, given after the build type's own; a precompiled header is taken only with the same.
set(KERF_QUICK_CODE -Og CACHE STRING "Optimisation of what is compiled once and run a few times: tests and commands")
set(KERF_CONSOLE_CODE -O2 CACHE STRING "Optimisation of screens, services and data; the loops have the build type's own")
function(kerf_optimise target kind)
  if(kind MATCHES "headless|test")
    target_compile_options(${target} PRIVATE ${KERF_QUICK_CODE})
  elseif(kind MATCHES "ui|data" AND CMAKE_BUILD_TYPE STREQUAL "Release")
    target_compile_options(${target} PRIVATE ${KERF_CONSOLE_CODE})
  endif()
  # Qt Test's headers look at it, and a target that has it would not be taken the header of one that has not.
  if(kind MATCHES "test")
    target_compile_options(${target} PRIVATE -UQT_NETWORK_LIB)
  endif()
endfunction()

# Qt Test without its target's definitions: they name each test's folder, which no precompiled header survives.
add_library(kerf_qt_test INTERFACE)
get_target_property(kerf_qt_test_includes Qt6::Test INTERFACE_INCLUDE_DIRECTORIES)
target_include_directories(kerf_qt_test SYSTEM INTERFACE ${kerf_qt_test_includes})
target_compile_definitions(kerf_qt_test INTERFACE QT_TESTLIB_LIB)
target_link_libraries(kerf_qt_test INTERFACE $<TARGET_FILE:Qt6::Test> Qt6::Core)

set(kerf_common_headers <algorithm> <array> <cmath> <functional> <map> <memory> <optional> <string> <variant> <vector>)
kerf_pch(ui HEADERS ${kerf_common_headers} <QtWidgets> <QtCharts> LINK Qt6::Widgets Qt6::Charts)
kerf_pch(headless HEADERS ${kerf_common_headers} <CLI/CLI.hpp> <nlohmann/json.hpp> <fmt/format.h> <Eigen/Dense>
         LINK CLI11::CLI11 nlohmann_json::nlohmann_json fmt::fmt Eigen3::Eigen)
kerf_pch(data HEADERS ${kerf_common_headers} <QtCore> <QtSql> <nlohmann/json.hpp> <fmt/format.h>
         LINK Qt6::Core Qt6::Sql nlohmann_json::nlohmann_json fmt::fmt)
kerf_pch(engine HEADERS ${kerf_common_headers} <Eigen/Dense> LINK Eigen3::Eigen)
kerf_pch(test HEADERS ${kerf_common_headers} <QtTest> <nlohmann/json.hpp> <fstream> LINK kerf_qt_test nlohmann_json::nlohmann_json)
kerf_pch(gui_test HEADERS ${kerf_common_headers} <QtTest> <QtWidgets> <QtCharts> <nlohmann/json.hpp>
         LINK kerf_qt_test Qt6::Widgets Qt6::Charts nlohmann_json::nlohmann_json)
kerf_pch(console_test HEADERS ${kerf_common_headers} <QtTest> <QtWidgets> <QtCharts> <nlohmann/json.hpp>
         ${CMAKE_SOURCE_DIR}/tests/support/console_bench.h LINK kerf_qt_test kerf_ui_console nlohmann_json::nlohmann_json)

# Several files of a target compiled as one: most of a file's time goes into what it includes. The loops stay apart: short
# files with heavy mathematics.
function(kerf_unity target)
  if(KERF_UNITY AND CMAKE_CURRENT_SOURCE_DIR MATCHES "^${CMAKE_SOURCE_DIR}/(app|db|ui)(/|$)")
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${KERF_UNITY})
  endif()
endfunction()

# kerf_library(name SOURCES … LINK … [QT]): one static library per folder, sources listed.
function(kerf_library name)
  cmake_parse_arguments(ARG "QT" "" "SOURCES;LINK" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_link_libraries(${name} PUBLIC kerf_options ${ARG_LINK})
  if(ARG_QT)
    set_target_properties(${name} PROPERTIES AUTOMOC ON)
  endif()
  kerf_unity(${name})
  if(name MATCHES "^kerf_ui")
    target_link_libraries(${name} PUBLIC Qt6::Widgets Qt6::Charts)
    kerf_precompile(${name} ui)
  elseif("${name};${ARG_LINK}" MATCHES "kerf_db(;|$)")
    kerf_precompile(${name} data)
  elseif("${ARG_LINK}" MATCHES "Eigen3")
    kerf_precompile(${name} engine)
  endif()
endfunction()

# kerf_add_test(tst_name LABEL unit|gui|db|rt|arch SOURCES … LINK … [TIMEOUT s]): one Qt Test program.
# Every test runs offscreen, from its own scratch folder, with the fixtures' folder in KERF_FIXTURES.
# What the sanitizers are not to report, for every test.
set(KERF_SANITIZER_ENVIRONMENT "TSAN_OPTIONS=suppressions=${CMAKE_SOURCE_DIR}/tests/support/tsan.supp:die_after_fork=0;LSAN_OPTIONS=suppressions=${CMAKE_SOURCE_DIR}/tests/support/lsan.supp")
function(kerf_add_test name)
  cmake_parse_arguments(ARG "" "LABEL;TIMEOUT" "SOURCES;LINK;ENV" ${ARGN})
  if(NOT ARG_SOURCES)
    set(ARG_SOURCES ${name}.cpp)
  endif()
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 600)  # against hanging only: beside other work a test takes several times as long
  endif()
  # moc straight, a twentieth of a second for each file: AUTOMOC takes a target, a run of CMake and an empty file to compile.
  set(mocs "")
  foreach(source IN LISTS ARG_SOURCES)
    file(STRINGS ${CMAKE_CURRENT_SOURCE_DIR}/${source} objects REGEX "Q_OBJECT" LIMIT_COUNT 1)
    if(objects AND source MATCHES "\\.h$")
      qt_wrap_cpp(mocs ${source})
    elseif(objects)
      get_filename_component(stem ${source} NAME_WE)
      set(moc ${CMAKE_CURRENT_BINARY_DIR}/mocs/${stem}.moc)
      qt_generate_moc(${source} ${moc})
      list(APPEND mocs ${moc})
    endif()
  endforeach()
  add_executable(${name} ${ARG_SOURCES} ${mocs})
  target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/mocs)
  target_sources(${name} PRIVATE $<TARGET_OBJECTS:kerf_test_scratch>)
  target_link_libraries(${name} PRIVATE kerf_options kerf_test_support ${ARG_LINK})
  # A test that links the screens has the larger precompiled header: its definitions are others.
  if("${ARG_LINK}" MATCHES "kerf_ui_console")
    kerf_precompile(${name} console_test)
  elseif("${ARG_LINK}" MATCHES "kerf_ui|Qt6::Widgets")
    kerf_precompile(${name} gui_test)
  else()
    kerf_precompile(${name} test)
  endif()
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES LABELS "${ARG_LABEL}" TIMEOUT ${ARG_TIMEOUT}
    ENVIRONMENT "QT_QPA_PLATFORM=offscreen;KERF_FIXTURES=${CMAKE_SOURCE_DIR}/tests/fixtures;KERF_BIN=${CMAKE_BINARY_DIR}/bin;LC_ALL=C.UTF-8;QTEST_FUNCTION_TIMEOUT=1800000;${KERF_SANITIZER_ENVIRONMENT};${ARG_ENV}")
endfunction()
