# Used by the presets: compile through ccache and link with mold where they are installed.
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros
      CCACHE_BASEDIR=${CMAKE_BINARY_DIR} ${CCACHE_PROGRAM})   # one build folder finds what another compiled
  add_compile_options(-fpch-preprocess)   # ccache's condition for precompiled headers
endif()
find_program(MOLD_PROGRAM mold)
if(MOLD_PROGRAM)
  add_link_options(-fuse-ld=mold)
endif()
