// SPDX-License-Identifier: GPL-3.0-or-later

#include "guarded_run.h"

#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <stdexcept>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

constexpr char valid = 'v', invalid = 'i', refused = 'r';

// In the child: one letter for the result, then the text.
[[noreturn]] void run_and_tell(const std::function<std::string()>& call, int pipe_end)
{
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO); // remarks of libraries
  dup2(nowhere, STDERR_FILENO);
  std::string message;
  try
  {
    const std::string problem = call();
    message = (problem.empty() ? valid : invalid) + problem;
  }
  catch(const std::exception& exception)
  {
    message = refused + std::string(exception.what());
  }
  const bool is_told = write(pipe_end, message.data(), message.size()) == ssize_t(message.size());
  _exit(is_told ? 0 : 1);
}

// Everything that comes through the pipe until it is closed or the time is over; false for the latter.
bool read_until(int pipe_end, std::chrono::steady_clock::time_point end, std::string& text)
{
  for(;;)
  {
    const auto left =
      std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
    pollfd waiting = {pipe_end, POLLIN, 0};
    if(left.count() <= 0 || poll(&waiting, 1, int(left.count())) <= 0)
      return false;
    char buffer[4096];
    const ssize_t count = read(pipe_end, buffer, sizeof(buffer));
    if(count <= 0)
      return true;
    text.append(buffer, std::size_t(count));
  }
}

Outcome outcome_of(const std::string& message, int status)
{
  if(WIFSIGNALED(status))
    return {Result::CRASHED, strsignal(WTERMSIG(status))};
  if(message.empty() || WEXITSTATUS(status) != 0)
    return {Result::CRASHED, "ended without a result"};
  const std::string text = message.substr(1);
  return message[0] == valid   ? Outcome{Result::VALID, ""}
       : message[0] == invalid ? Outcome{Result::INVALID, text}
                               : Outcome{Result::REFUSED, text};
}

} // namespace

Outcome guarded_run(const std::function<std::string()>& call, double limit)
{
  int ends[2];
  if(pipe(ends) != 0)
    throw std::runtime_error("there can be no pipe");
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if(child < 0)
    throw std::runtime_error("there can be no child process");
  if(child == 0)
    run_and_tell(call, ends[1]);
  close(ends[1]);

  std::string message;
  const auto duration =
    std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(limit));
  const bool is_over = read_until(ends[0], start + duration, message);
  close(ends[0]);
  if(!is_over)
    kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  Outcome outcome = is_over ? outcome_of(message, status) : Outcome{Result::TIMED_OUT, ""};
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}
