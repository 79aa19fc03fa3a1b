#pragma once

// The public interface in the order of the pipeline; cgal.hpp, chains.hpp and the stages of the
// float engines (engines/*_stages.hpp) are apart.

#include "plumbline/arrange.hpp"
#include "plumbline/check.hpp"
#include "plumbline/compare.hpp"
#include "plumbline/complex.hpp"
#include "plumbline/diagnose.hpp"
#include "plumbline/engine.hpp"
#include "plumbline/engines/files.hpp"
#include "plumbline/engines/inters.hpp"
#include "plumbline/engines/inters_show.hpp"
#include "plumbline/engines/lar.hpp"
#include "plumbline/engines/lar_show.hpp"
#include "plumbline/error.hpp"
#include "plumbline/features.hpp"
#include "plumbline/geometry.hpp"
#include "plumbline/ladder.hpp"
#include "plumbline/number.hpp"
#include "plumbline/output.hpp"
#include "plumbline/pipeline.hpp"
#include "plumbline/polygons.hpp"
#include "plumbline/read.hpp"
#include "plumbline/rings.hpp"
#include "plumbline/rooms.hpp"
#include "plumbline/round.hpp"
#include "plumbline/structure.hpp"
