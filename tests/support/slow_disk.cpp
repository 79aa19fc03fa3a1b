// Preloaded into the tool by tests/cli_interrupt_test.sh: the disk does not say that a file is on
// it while a file "hold" is in the working directory, so that the tool can be interrupted while its
// temporary file is there.

#include <unistd.h>

extern "C" int fsync(int /*file*/) {
  constexpr unsigned kMicroseconds = 10'000;
  while (::access("hold", F_OK) == 0) ::usleep(kMicroseconds);
  return 0;
}
