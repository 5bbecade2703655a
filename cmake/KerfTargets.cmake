# One precompiled header for the screens' libraries. Tests have none: Qt6::Test defines each one's folder on its command
# line, and the compiler takes a precompiled header only with the same definitions.
set(CMAKE_PCH_WARN_INVALID OFF)
file(WRITE ${CMAKE_BINARY_DIR}/pch/kerf_pch_ui.cpp "// only here so that the precompiled header has a target\n")
add_library(kerf_pch_ui OBJECT ${CMAKE_BINARY_DIR}/pch/kerf_pch_ui.cpp)
target_link_libraries(kerf_pch_ui PRIVATE kerf_options Qt6::Widgets Qt6::Charts)
target_precompile_headers(kerf_pch_ui PRIVATE <QtWidgets> <QtCharts> <functional> <memory> <vector>)

# kerf_library(name SOURCES … LINK … [QT]): one static library per folder, sources listed.
function(kerf_library name)
  cmake_parse_arguments(ARG "QT" "" "SOURCES;LINK" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_link_libraries(${name} PUBLIC kerf_options ${ARG_LINK})
  if(ARG_QT)
    set_target_properties(${name} PROPERTIES AUTOMOC ON)
  endif()
  if(name MATCHES "^kerf_ui")
    target_link_libraries(${name} PUBLIC Qt6::Widgets Qt6::Charts)
    target_precompile_headers(${name} REUSE_FROM kerf_pch_ui)
  endif()
endfunction()

# kerf_add_test(tst_name LABEL unit|gui|db|rt|arch SOURCES … LINK … [TIMEOUT s]): one Qt Test program.
# Every test runs offscreen, from its own scratch folder, with the fixtures' folder in KERF_FIXTURES.
function(kerf_add_test name)
  cmake_parse_arguments(ARG "" "LABEL;TIMEOUT" "SOURCES;LINK;ENV" ${ARGN})
  if(NOT ARG_SOURCES)
    set(ARG_SOURCES ${name}.cpp)
  endif()
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  set_target_properties(${name} PROPERTIES AUTOMOC ON)
  target_link_libraries(${name} PRIVATE kerf_options kerf_test_support ${ARG_LINK} Qt6::Test)
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/scratch/${name})
  add_test(NAME ${name} COMMAND ${name} WORKING_DIRECTORY ${CMAKE_BINARY_DIR}/scratch/${name})
  set_tests_properties(${name} PROPERTIES LABELS "${ARG_LABEL}" TIMEOUT ${ARG_TIMEOUT}
    ENVIRONMENT "QT_QPA_PLATFORM=offscreen;KERF_FIXTURES=${CMAKE_SOURCE_DIR}/tests/fixtures;KERF_BIN=${CMAKE_BINARY_DIR}/bin;LC_ALL=C.UTF-8;TSAN_OPTIONS=suppressions=${CMAKE_SOURCE_DIR}/tests/support/tsan.supp;LSAN_OPTIONS=suppressions=${CMAKE_SOURCE_DIR}/tests/support/lsan.supp;${ARG_ENV}")
endfunction()
