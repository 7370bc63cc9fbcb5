# Every library that Volute uses, all from Debian 12 packages. Nothing is downloaded here.
# Each becomes one target with a fixed name, so that modules never spell a path.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(Eigen3 CONFIG REQUIRED)                  # Eigen3::Eigen
find_package(TBB CONFIG REQUIRED)                     # TBB::tbb
find_package(tomlplusplus CONFIG REQUIRED)            # tomlplusplus::tomlplusplus
find_package(nlohmann_json CONFIG REQUIRED)           # nlohmann_json::nlohmann_json
pkg_check_modules(BULLET REQUIRED IMPORTED_TARGET bullet-float64)   # PkgConfig::BULLET; find_package(Bullet) is single precision
find_path(TL_EXPECTED_INCLUDE tl/expected.hpp REQUIRED)

if(NOT VOLUTE_SIM_ALONE)
  find_package(fcl CONFIG REQUIRED)                   # fcl
  find_package(CLI11 CONFIG REQUIRED)                 # CLI11::CLI11
  find_package(PNG REQUIRED)                          # PNG::PNG
  pkg_check_modules(OSMESA REQUIRED IMPORTED_TARGET osmesa)         # PkgConfig::OSMESA
  find_path(CHOLMOD_INCLUDE cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
  find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
  add_library(volute_cholmod INTERFACE)
  target_include_directories(volute_cholmod SYSTEM INTERFACE ${CHOLMOD_INCLUDE})
  target_link_libraries(volute_cholmod INTERFACE ${CHOLMOD_LIBRARY})
endif()

# Flags that every module shares. No fast-math, no -march=native, no contraction: the same inputs give the same bytes.
add_library(volute_flags INTERFACE)
target_compile_features(volute_flags INTERFACE cxx_std_20)
target_compile_options(volute_flags INTERFACE -ffp-contract=off -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion)
# GCC 12 sees out-of-bounds copies in std::string's operator+ that are not there (GCC bugs 105329, 105651), and
# frees inside a block where a vector of char is destroyed.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(volute_flags INTERFACE -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread -Wno-free-nonheap-object)
endif()
target_include_directories(volute_flags INTERFACE ${PROJECT_SOURCE_DIR})
target_include_directories(volute_flags SYSTEM INTERFACE ${TL_EXPECTED_INCLUDE})
target_link_libraries(volute_flags INTERFACE Eigen3::Eigen Threads::Threads)
# FCL's library was built for baseline alignment: keep Eigen's the same everywhere.
target_compile_definitions(volute_flags INTERFACE EIGEN_MAX_ALIGN_BYTES=16)
if(VOLUTE_SANITIZE)
  target_compile_options(volute_flags INTERFACE -fsanitize=${VOLUTE_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(volute_flags INTERFACE -fsanitize=${VOLUTE_SANITIZE})
endif()
set(CMAKE_CXX_EXTENSIONS OFF)

# Precompiled headers (most of a source's compile time is Eigen and the standard library): one for modules, one for tests.
option(VOLUTE_PRECOMPILED "Parse Eigen and the standard library once for all sources" ON)
if(VOLUTE_PRECOMPILED)
  add_library(volute_precompiled OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
  target_link_libraries(volute_precompiled PRIVATE volute_flags)
  target_precompile_headers(volute_precompiled PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.hpp)
endif()

# Gives a target the precompiled header of `volute_precompiled` or, for tests, of `volute_precompiled_test`.
function(volute_precompile target source)
  if(VOLUTE_PRECOMPILED)
    target_precompile_headers(${target} REUSE_FROM ${source})
  endif()
endfunction()

# Sources of one target compiled together, a few at a time: what they share (templates of Eigen, JSON, GoogleTest) is instantiated
# once a batch. Only for targets where that is most of the time; their unnamed namespaces share one set of names.
option(VOLUTE_UNITY "Compile the sources of heavy targets in batches" ON)
function(volute_unity target batch)
  if(VOLUTE_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${batch})
  endif()
endfunction()
