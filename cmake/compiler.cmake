# Flags for our own code: warnings are errors, arithmetic is the same on every build.
find_program(CCACHE ccache)
if(CCACHE)
  # Objects of precompiled headers are kept too.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
                                  CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
endif()

# No fused multiply-add: the same frame gives the same bits on any machine. Nobody asks errno or
# traps of arithmetic, so loops need not keep them; no bit changes by that.
add_compile_options(-ffp-contract=off -fno-math-errno -fno-trapping-math)
# Eigen would take roots of vectors from estimates (rsqrtps), which differ between makers of
# processors.
add_compile_definitions(EIGEN_FAST_MATH=0)

if(FOVEA_SANITIZE)
  add_compile_options(-fsanitize=${FOVEA_SANITIZE} -fno-omit-frame-pointer
                      -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${FOVEA_SANITIZE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # It warns falsely about std::regex (GCC bug 105562) and sums of strings when they are
    # instrumented.
    add_compile_options(-Wno-maybe-uninitialized -Wno-array-bounds)
    if(FOVEA_SANITIZE MATCHES thread)
      add_compile_options(-Wno-tsan) # fences in Boost.Asio, beside locks that it does see
    endif()
  endif()
endif()

if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # Its garbage is collected from half a gigabyte on: a tenth of its time went into collecting less.
  add_compile_options(--param=ggc-min-heapsize=524288)
endif()

# Called once per target of ours; generated and third-party code stays without it. To Clang a local
# name shadows one in an unnamed namespace of another source, where several are compiled at a time.
function(fovea_target target)
  target_compile_options(
    ${target} PRIVATE -Wall -Wextra -Wpedantic $<$<CXX_COMPILER_ID:GNU>:-Wshadow>
                      -Wnon-virtual-dtor -Woverloaded-virtual -Werror)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
endfunction()
