#include "cli/program_folders.hpp"
#include "cli/tool.hpp"
#include "plumbline/pipeline.hpp"

int main(int argc, char** argv) {
  return plumbline::cli::run(argc, argv, {plumbline::engines(), plumbline::cli::program_folders()});
}
