# One target per folder, linked only to the folders that design.md allows it to include.

add_library(phs_options INTERFACE)
target_compile_features(phs_options INTERFACE cxx_std_20)
target_include_directories(phs_options INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
# Contraction to fused multiply-add would make results depend on the compiler: identical bits are a
# promise of this product.
target_compile_options(phs_options INTERFACE
  $<BUILD_INTERFACE:-Wall> $<BUILD_INTERFACE:-Wextra> $<BUILD_INTERFACE:-Wpedantic>
  $<BUILD_INTERFACE:-ffp-contract=off>
  # A false alarm of GCC 12 (its bug 105651).
  $<BUILD_INTERFACE:$<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>>)
if(PHS_SANITIZE)
  target_compile_options(phs_options INTERFACE -fsanitize=${PHS_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(phs_options INTERFACE -fsanitize=${PHS_SANITIZE})
endif()

# phs_folder(NAME DEPENDS targets… [SEPARATE] [ROWS files…]): the library phs_NAME from every .cc file of the
# folder. The release preset compiles some files of a folder together, in half the time: a name outside of a
# function stands for one thing in the whole folder, also in anonymous namespaces. ROWS: these files by
# themselves, as they give their parts the same names. SEPARATE: every file by itself, where a program that takes
# one of them shall not take its neighbours' libraries.
function(phs_folder name)
  cmake_parse_arguments(ARG "SEPARATE" "" "DEPENDS;EXCLUDE;ROWS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cc)
  foreach(file ${ARG_EXCLUDE})
    list(REMOVE_ITEM sources ${CMAKE_CURRENT_SOURCE_DIR}/${file})
  endforeach()
  if(sources)
    add_library(phs_${name} STATIC ${sources})
    target_link_libraries(phs_${name} PUBLIC phs_options ${ARG_DEPENDS})
    if(ARG_SEPARATE)
      set_target_properties(phs_${name} PROPERTIES UNITY_BUILD OFF)
    endif()
    if(ARG_ROWS)
      set_source_files_properties(${ARG_ROWS} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  else()
    add_library(phs_${name} INTERFACE)
    target_link_libraries(phs_${name} INTERFACE phs_options ${ARG_DEPENDS})
  endif()
endfunction()

# phs_quick_maths(TARGET): lets the compiler use vector square roots and calculate both sides of a choice; no result
# changes.
function(phs_quick_maths target)
  target_compile_options(${target} PRIVATE -fno-math-errno -fno-trapping-math -fno-semantic-interposition)
endfunction()

# phs_quick_build(TARGET): for words, pages and options, not numbers: a release build compiles them with -O1, a third
# faster than with -O3.
function(phs_quick_build target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# phs_npm_ci(COMMENT): the packages of the folder's package-lock.json, in npm_dir of its binary
# folder; npm_stamp is the file that stands for them.
macro(phs_npm_ci comment)
  find_program(PHS_NPM npm REQUIRED)
  set(npm_dir ${CMAKE_CURRENT_BINARY_DIR}/npm)
  set(npm_stamp ${npm_dir}/installed.stamp)
  add_custom_command(
    OUTPUT ${npm_stamp}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${npm_dir}
    COMMAND ${CMAKE_COMMAND} -E copy package.json package-lock.json .npmrc ${npm_dir}
    COMMAND ${CMAKE_COMMAND} -E chdir ${npm_dir} ${PHS_NPM} ci --loglevel=error
    COMMAND ${CMAKE_COMMAND} -E touch ${npm_stamp}
    DEPENDS package.json package-lock.json .npmrc
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
    COMMENT ${comment}
    VERBATIM)
endmacro()

# phs_test_folder(NAME DEPENDS targets… [OPTIMISED] [SUITES names…]): one GoogleTest program from every
# *_test.cc of the folder. Its own sources are compiled with -O1 in a release build, a fifth faster than with -O3; the
# libraries under test stay as they ship. OPTIMISED keeps -O3, for tests that use Eigen's factorisations
# themselves: the linker takes one copy of a template for test and library, and that shall be the fast one.
# SUITES names suites whose cases share a long run (SetUpTestSuite): each is one test of ctest, which starts a
# process for every test, and would make the run again for every case.
function(phs_test_folder name)
  cmake_parse_arguments(ARG "OPTIMISED" "" "DEPENDS;LABELS;SUITES" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*_test.cc)
  if(NOT sources)
    return()
  endif()
  add_executable(test_${name} ${sources})
  target_link_libraries(test_${name} PRIVATE phs_options ${ARG_DEPENDS} GTest::gmock GTest::gtest_main
                        rapidcheck::rapidcheck)
  target_include_directories(test_${name} PRIVATE ${PROJECT_BINARY_DIR}/tests/places)
  if(NOT ARG_OPTIMISED)
    target_compile_options(test_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
  set(labels)
  if(ARG_LABELS)
    set(labels LABELS "${ARG_LABELS}")
  endif()
  if(PHS_SANITIZE)
    target_compile_definitions(test_${name} PRIVATE PHS_SANITIZED)
  endif()
  # Property tests draw the same cases on every machine.
  set(seed ENVIRONMENT "RC_PARAMS=seed=20260")
  set(others)
  foreach(suite ${ARG_SUITES})
    add_test(NAME ${name}.${suite} COMMAND test_${name} --gtest_filter=${suite}.*)
    set_tests_properties(${name}.${suite} PROPERTIES ${labels} ${seed})
    string(APPEND others ":${suite}.*")
  endforeach()
  if(others)
    string(REGEX REPLACE "^:" "-" others "${others}")
    set(others TEST_FILTER "${others}")
  endif()
  gtest_discover_tests(test_${name} TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 60 ${others}
                       PROPERTIES ${labels} ${seed})
endfunction()
