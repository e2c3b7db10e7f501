// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "guarded_run.h"

#include <csignal>
#include <cstring>
#include <exception>
#include <stdexcept>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

// A call that waits for something uses no processor time; it ends after so many times the limit.
constexpr unsigned int clock_factor = 20;

constexpr char valid = 'v', invalid = 'i', refused = 'r';

// In the child: one letter for the result, then the text.
[[noreturn]] void run_and_tell(const std::function<std::string()>& call, unsigned int limit, int pipe_end)
{
  const rlimit processor_time = {limit, limit + 1};
  setrlimit(RLIMIT_CPU, &processor_time);
  alarm(clock_factor * limit);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO); // remarks of libraries
  dup2(nowhere, STDERR_FILENO);
  std::string message;
  try
  {
    const std::string problem = call();
    message = (problem.empty() ? valid : invalid) + problem;
  }
  catch (const std::exception& exception)
  {
    message = refused + std::string(exception.what());
  }
  const bool is_told = write(pipe_end, message.data(), message.size()) == ssize_t(message.size());
  _exit(is_told ? 0 : 1);
}

// Everything that comes through the pipe until it is closed.
std::string read_all(int pipe_end)
{
  std::string text;
  char buffer[4096];
  for (ssize_t count; (count = read(pipe_end, buffer, sizeof(buffer))) > 0;)
    text.append(buffer, std::size_t(count));
  return text;
}

Outcome outcome_of(const std::string& message, int status)
{
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGXCPU || signal == SIGALRM)
    return {Result::TIMED_OUT, ""};
  if (signal != 0)
    return {Result::CRASHED, strsignal(signal)};
  if (message.empty() || WEXITSTATUS(status) != 0)
    return {Result::CRASHED, "ended without a result"};
  const std::string text = message.substr(1);
  return message[0] == valid   ? Outcome{Result::VALID, ""}
       : message[0] == invalid ? Outcome{Result::INVALID, text}
                               : Outcome{Result::REFUSED, text};
}

} // namespace

Outcome guarded_run(const std::function<std::string()>& call, unsigned int limit)
{
  int ends[2];
  if (pipe(ends) != 0)
    throw std::runtime_error("there can be no pipe");
  const pid_t child = fork();
  if (child < 0)
    throw std::runtime_error("there can be no child process");
  if (child == 0)
    run_and_tell(call, limit, ends[1]);
  close(ends[1]);
  const std::string message = read_all(ends[0]);
  close(ends[0]);
  int status = 0;
  rusage usage = {};
  wait4(child, &status, 0, &usage);
  Outcome outcome = outcome_of(message, status);
  outcome.seconds = double(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
                    double(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec) * 1e-6;
  return outcome;
}
