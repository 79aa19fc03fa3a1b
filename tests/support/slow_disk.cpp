// Preloaded into the tool by tests/cli_interrupt_test.sh: the disk takes a second to say that a
// file is on it, so that the tool can be interrupted while its temporary file is there.

#include <unistd.h>

extern "C" int fsync(int /*file*/) {
  ::sleep(1);
  return 0;
}
