# What the library links. Read by the build and by the installed package's configuration.
include(CMakeFindDependencyMacro)
find_dependency(PkgConfig)
pkg_check_modules(GMP REQUIRED QUIET IMPORTED_TARGET gmpxx gmp mpfr)
pkg_check_modules(XXHASH REQUIRED QUIET IMPORTED_TARGET libxxhash)
find_dependency(pugixml)
find_dependency(fmt)
find_dependency(Eigen3 NO_MODULE)
find_dependency(CGAL)
