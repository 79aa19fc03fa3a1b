#pragma once

#include <string>

namespace plumbline::bench {

/// Processor, memory, compiler, libraries, allocator and present load of the machine, as a Markdown
/// list.
std::string machine();

}  // namespace plumbline::bench
