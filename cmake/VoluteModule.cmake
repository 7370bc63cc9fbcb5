# volute_module(NAME [UNITY] HEADERS ... SOURCES ... DEPENDS ... LIBRARIES ...)
# One static library a module. HEADERS are the public ones (each is compiled alone by the target
# all_verify_interface_header_sets). DEPENDS are other modules, LIBRARIES third-party targets that only the sources need.
function(volute_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "UNITY" "" "HEADERS;SOURCES;DEPENDS;LIBRARIES;PUBLIC_LIBRARIES")
  set(target volute_${name})
  add_library(${target} STATIC ${arg_SOURCES})
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${arg_HEADERS})
  set_target_properties(${target} PROPERTIES VERIFY_INTERFACE_HEADER_SETS ON LINKER_LANGUAGE CXX)
  target_link_libraries(${target} PUBLIC volute_flags)
  foreach(module IN LISTS arg_DEPENDS)
    target_link_libraries(${target} PUBLIC volute_${module})
  endforeach()
  target_link_libraries(${target} PUBLIC ${arg_PUBLIC_LIBRARIES})
  target_link_libraries(${target} PRIVATE ${arg_LIBRARIES})
  volute_precompile(${target} volute_precompiled)
  if(arg_UNITY AND name MATCHES "^planner")
    volute_unity(${target} 4)  # what is changed most often: a small batch is compiled again in seconds
  elseif(arg_UNITY)
    volute_unity(${target} 8)
  endif()
endfunction()

# Tests call optimised code; their own is compiled with less effort, which saves a quarter of their time.
set(VOLUTE_TEST_OPTIONS $<$<CONFIG:Release>:-O1>)

# volute_test(NAME SOURCES ... DEPENDS ... LIBRARIES ...): one GoogleTest program, each test case known to CTest.
# Tests find the repository through the definition VOLUTE_SOURCE_DIR.
function(volute_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;DEPENDS;LIBRARIES")
  set(target ${name}_tests)
  add_executable(${target} ${arg_SOURCES})
  target_link_libraries(${target} PRIVATE volute_flags GTest::gtest_main GTest::gmock ${arg_LIBRARIES})
  foreach(module IN LISTS arg_DEPENDS)
    target_link_libraries(${target} PRIVATE volute_${module})
  endforeach()
  target_compile_options(${target} PRIVATE ${VOLUTE_TEST_OPTIONS})
  target_compile_definitions(${target} PRIVATE VOLUTE_SOURCE_DIR="${PROJECT_SOURCE_DIR}" VOLUTE_BINARY_DIR="${PROJECT_BINARY_DIR}")
  volute_precompile(${target} volute_precompiled_test)
  volute_unity(${target} 8)
  gtest_discover_tests(${target} DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT 600)
endfunction()
