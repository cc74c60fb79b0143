// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/app/studio/x_server.h"

#include <csignal>
#include <fcntl.h>
#include <stdexcept>
#include <unistd.h>

#include <sys/prctl.h>
#include <sys/wait.h>

namespace loopscope {
namespace {

/// Becomes the server, which writes its display number to `report`.
[[noreturn]] void BecomeServer(int report, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(0);
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
  const std::string number = std::to_string(report);
  execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "1280x800x24", "-dpi", "96",
         "-nolisten", "tcp", "-noreset", nullptr);
  _exit(127);
}

/// Until the end of a line, or of what comes.
std::string ReadLine(int source) {
  std::string line;
  for (char letter = 0; read(source, &letter, 1) == 1 && letter != '\n';) line += letter;
  return line;
}

}  // namespace

XServer::XServer() {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe to an X server");
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ == 0) {
    close(ends[0]);
    BecomeServer(ends[1], parent);
  }
  close(ends[1]);
  const std::string number = ReadLine(ends[0]);
  close(ends[0]);
  if (number.empty()) throw std::runtime_error("Xvfb does not start; it is in the package xvfb");
  display_ = ":" + number;
}

XServer::~XServer() {
  kill(process_, SIGTERM);
  waitpid(process_, nullptr, 0);
}

}  // namespace loopscope
