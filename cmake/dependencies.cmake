# What the library links. Read by the build and by the installed package's configuration.
find_package(PkgConfig REQUIRED)
pkg_check_modules(GMP REQUIRED QUIET IMPORTED_TARGET gmpxx gmp mpfr)
pkg_check_modules(XXHASH REQUIRED QUIET IMPORTED_TARGET libxxhash)
find_package(pugixml REQUIRED)
find_package(fmt REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(TBB REQUIRED)
find_package(CGAL REQUIRED)
