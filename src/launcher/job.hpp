// A job of several processes that ends in order.
#pragma once

#include "launcher/process.hpp"

namespace moat::launcher {

/// Runs mpirun, or another program that hands SIGUSR1 to its processes, to its end and returns its exit code.
///
/// mpirun kills its processes within two seconds of SIGINT or SIGTERM. Therefore the first of these signals, or SIGHUP,
/// reaches it as SIGUSR1, at which studies end in order; after it the exit code is 128 + the signal, or 0 where the job
/// had reached its end. The second one ends the job at once. The job ends too where this process is killed.
///
/// Throws Stop where the program cannot be started.
int run_job(const Command& command);

}  // namespace moat::launcher
