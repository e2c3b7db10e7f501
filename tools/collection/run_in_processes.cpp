// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "collection/run_in_processes.h"

#if __has_include(<sys/wait.h>)
#define PROTRUSION_SEGMENTATION_HAS_FORK
#include <sys/wait.h>
#include <unistd.h>
#if __has_include(<sys/prctl.h>)
#include <sys/prctl.h>
#endif

#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>
#include <iostream>
#include <map>
#include <system_error>
#endif

namespace tool
{

#ifdef PROTRUSION_SEGMENTATION_HAS_FORK
namespace
{

// A child sends a letter for `is_failure`, the warning, a null, and the text, in one piece that a pipe is sure to hold.
constexpr char done_letter = 'd', failed_letter = 'f';

void send(int pipe, const Outcome& outcome)
{
  const std::string message =
    ((outcome.is_failure ? failed_letter : done_letter) + outcome.warning + '\0' + outcome.text).substr(0, PIPE_BUF);
  [[maybe_unused]] const ssize_t sent = write(pipe, message.data(), message.size());
}

std::string received(int pipe)
{
  std::array<char, PIPE_BUF> buffer;
  const ssize_t size = read(pipe, buffer.data(), buffer.size());
  return std::string(buffer.data(), size > 0 ? std::size_t(size) : 0);
}

std::string reason_of_end(int status)
{
  if (WIFSIGNALED(status))
    return "its process was ended by signal " + std::to_string(WTERMSIG(status)) + ", " + strsignal(WTERMSIG(status));
  return "its process ended with exit code " + std::to_string(WEXITSTATUS(status));
}

// A child that is left alone, as when somebody ends its parent alone, shall not go on for hours, and write files
// beside a second run.
void end_with([[maybe_unused]] pid_t parent)
{
#ifdef PR_SET_PDEATHSIG
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) // it ended before
    _exit(1);
#endif
}

class Processes
{
public:
  Processes(const Task& task, const Tell& tell) : m_task(task), m_tell(tell)
  {
    std::signal(SIGCHLD, SIG_DFL); // who started this may have chosen to know nothing of children
  }

  std::size_t number_of_running() const { return m_running.size(); }

  void start(std::size_t task)
  {
    int ends[2];
    if (pipe(ends) != 0)
      return tell_error(task);
    std::cout.flush(); // else the child would have a copy of what waits there
    const pid_t parent = getpid();
    const pid_t child = fork();
    if (child == 0)
    {
      end_with(parent);
      send(ends[1], m_task(task));
      _exit(0);
    }
    if (child < 0)
    {
      tell_error(task);
      close(ends[0]);
    }
    else
      m_running[child] = {task, ends[0]};
    close(ends[1]);
  }

  void wait_for_one()
  {
    int status = 0;
    const pid_t child = waitpid(-1, &status, 0);
    const auto ended = m_running.find(child);
    if (ended == m_running.end())
      return; // a signal came first
    const Running running = ended->second;
    m_running.erase(ended);
    const std::string message = received(running.pipe);
    close(running.pipe);
    const std::size_t null = message.find('\0');
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0 && null != message.npos)
      m_tell(running.task, {message[0] == failed_letter, message.substr(null + 1), message.substr(1, null - 1)});
    else
      m_tell(running.task, {true, reason_of_end(status)});
  }

private:
  struct Running
  {
    std::size_t task;
    int pipe;
  };

  void tell_error(std::size_t task)
  {
    m_tell(task, {true, "gets no process: " + std::generic_category().message(errno)});
  }

  const Task& m_task;
  const Tell& m_tell;
  std::map<pid_t, Running> m_running;
};

} // namespace
#endif

void run_in_processes(std::size_t number_of_tasks, [[maybe_unused]] std::size_t at_once, const Task& task, const Tell& tell)
{
#ifdef PROTRUSION_SEGMENTATION_HAS_FORK
  Processes processes(task, tell);
  for (std::size_t i = 0; i < number_of_tasks; ++i)
  {
    while (processes.number_of_running() >= at_once)
      processes.wait_for_one();
    processes.start(i);
  }
  while (processes.number_of_running() > 0)
    processes.wait_for_one();
#else
  for (std::size_t i = 0; i < number_of_tasks; ++i)
    tell(i, task(i));
#endif
}

} // namespace tool
