#!/usr/bin/env bash
# What the library needs, on the images in which cibuildwheel makes wheels for other Linux.
set -euo pipefail
dnf install -y epel-release
dnf install -y boost-devel CGAL-devel eigen3-devel fmt-devel gmp-devel mpfr-devel pugixml-devel rapidjson-devel tbb-devel \
  xxhash-devel zlib-devel nanoflann-devel cli11-devel
