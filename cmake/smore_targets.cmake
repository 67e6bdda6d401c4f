# Functions that give every target of the package the same flags.

set(SMORE_WARNINGS -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual)
# The prefix is the project's name, in the capitals of an option.
#catkin_lint: ignore_once global_var_collision
option(SMORE_WARNINGS_AS_ERRORS "Refuse sources that the compiler warns of: for continuous integration" OFF)
if(SMORE_WARNINGS_AS_ERRORS)
  list(APPEND SMORE_WARNINGS -Werror)
endif()
set(SMORE_RUN_WITH_LIMIT ${CMAKE_CURRENT_LIST_DIR}/../scripts/run_with_limit.py)

# smore_library(NAME SOURCES a.cpp ... LINK libraries ...)
#
# A shared library that may not leave a symbol undefined, so that the linker refuses a layer that uses
# one above it.
function(smore_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_library(${name} SHARED ${ARG_SOURCES})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR}/include)
  target_link_libraries(${name} PUBLIC ${ARG_LINK})
  target_compile_options(${name} PRIVATE ${SMORE_WARNINGS})
  target_link_options(${name} PRIVATE -Wl,--no-undefined)
  install(TARGETS ${name}
    ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
    LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
    RUNTIME DESTINATION ${CATKIN_GLOBAL_BIN_DESTINATION})
endfunction()

# Everything but the tests, for those who only want to run it.
add_custom_target(smore_programs)

# smore_executable(NAME SOURCES a.cpp ... LINK libraries ...): a program in devel/lib/smore.
function(smore_executable name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LINK})
  target_compile_options(${name} PRIVATE ${SMORE_WARNINGS})
  set_target_properties(${name} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${CATKIN_DEVEL_PREFIX}/${CATKIN_PACKAGE_BIN_DESTINATION})
  add_dependencies(smore_programs ${name})
  install(TARGETS ${name} RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
endfunction()

# smore_test(NAME SOURCES a.cpp ... LINK libraries ...): a gtest that ctest runs with no ROS master, for
# five minutes at most.
function(smore_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  add_dependencies(tests ${name})
  target_link_libraries(${name} PRIVATE ${ARG_LINK} PkgConfig::GTEST_MAIN)
  target_compile_options(${name} PRIVATE ${SMORE_WARNINGS})
  target_compile_definitions(${name} PRIVATE SMORE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES TIMEOUT 300)
endfunction()

# smore_test_program(NAME SOURCES a.cpp ... LINK libraries ...): a program that a test starts.
function(smore_test_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  add_dependencies(tests ${name})
  target_link_libraries(${name} PRIVATE ${ARG_LINK})
  target_compile_options(${name} PRIVATE ${SMORE_WARNINGS})
endfunction()

# smore_rostest(NAME FILE.test [SOURCES a.cpp ... LINK libraries ...] [TIMEOUT seconds (120)] [REAL_TIME])
#
# Lets ctest run a rostest, with a ROS master of its own on a free port. Sources become the gtest
# program NAME in devel/lib/smore, for <test pkg="smore" type="NAME" .../> in FILE.test. rostest exits
# with an error where a test fails, crashes or writes no result. What hangs is ended after TIMEOUT, with
# all its nodes. These tests run one after another: each starts several processes that should not starve.
# One that asserts on times (REAL_TIME) runs alone.
function(smore_rostest name file)
  cmake_parse_arguments(ARG "REAL_TIME" "TIMEOUT" "SOURCES;LINK" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  if(ARG_SOURCES)
    add_executable(${name} ${ARG_SOURCES})
    add_dependencies(tests ${name})
    target_link_libraries(${name} PRIVATE ${ARG_LINK} PkgConfig::GTEST)
    target_compile_options(${name} PRIVATE ${SMORE_WARNINGS})
    target_compile_definitions(${name} PRIVATE SMORE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    set_target_properties(${name} PROPERTIES
      RUNTIME_OUTPUT_DIRECTORY ${CATKIN_DEVEL_PREFIX}/${CATKIN_PACKAGE_BIN_DESTINATION})
  endif()
  add_test(NAME ${name} COMMAND
    ${SMORE_RUN_WITH_LIMIT} ${ARG_TIMEOUT} ${CATKIN_DEVEL_PREFIX}/env.sh rostest
    --pkgdir=${PROJECT_SOURCE_DIR} --package=${PROJECT_NAME}
    --results-filename ${name}.xml --results-base-dir ${PROJECT_BINARY_DIR}/test_results
    ${CMAKE_CURRENT_SOURCE_DIR}/${file})
  math(EXPR hard_limit "${ARG_TIMEOUT} + 30")
  set_tests_properties(${name} PROPERTIES RESOURCE_LOCK ros TIMEOUT ${hard_limit}
    ENVIRONMENT "PATH=/usr/bin:/bin;ROS_HOME=${PROJECT_BINARY_DIR}/ros_home;ROS_HOSTNAME=localhost")
  if(ARG_REAL_TIME)
    set_tests_properties(${name} PROPERTIES RUN_SERIAL TRUE)
  endif()
endfunction()
