#pragma once

// The public interface in the order of the pipeline; cgal.hpp, boundary.hpp and the stages of the
// float pipelines (lar_stages.hpp, published_stages.hpp) are apart.

#include "plumbline/arrange.hpp"
#include "plumbline/certificate.hpp"
#include "plumbline/check.hpp"
#include "plumbline/complex.hpp"
#include "plumbline/crosscheck.hpp"
#include "plumbline/diagnose.hpp"
#include "plumbline/error.hpp"
#include "plumbline/geometry.hpp"
#include "plumbline/ladder.hpp"
#include "plumbline/lar.hpp"
#include "plumbline/number.hpp"
#include "plumbline/polygons.hpp"
#include "plumbline/published.hpp"
#include "plumbline/read.hpp"
#include "plumbline/report.hpp"
#include "plumbline/result.hpp"
#include "plumbline/round.hpp"
#include "plumbline/structure.hpp"
#include "plumbline/triangulate.hpp"
#include "plumbline/write.hpp"
