# The opt-in headers of interop/ with the libraries that they are for. CGAL and Boost need -frounding-math; their headers are not
# ours to warn about.
find_path(VERITOPE_EIGEN_INCLUDE Eigen/Core PATH_SUFFIXES eigen3 REQUIRED)
target_include_directories(interop_full SYSTEM PRIVATE ${VERITOPE_EIGEN_INCLUDE})
target_compile_options(interop_full PRIVATE $<$<CXX_COMPILER_ID:GNU>:-frounding-math> -w)
target_link_libraries(interop_full PRIVATE veritope::interop gmp mpfr)
