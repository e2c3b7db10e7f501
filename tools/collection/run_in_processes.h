// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_COLLECTION_RUN_IN_PROCESSES_H
#define PROTRUSION_SEGMENTATION_TOOLS_COLLECTION_RUN_IN_PROCESSES_H

#include <cstddef>
#include <functional>
#include <string>

namespace tool
{

// What is to be told of a task.
struct Outcome
{
  bool is_failure;
  std::string text;
  std::string warning = {};
};

using Task = std::function<Outcome(std::size_t)>; // no exception leaves it
using Tell = std::function<void(std::size_t, const Outcome&)>;

// Does the tasks 0, ..., number_of_tasks - 1, `at_once` of them at a time, each in a process of its own: a task that
// crashes, or that the system ends for want of memory, has failed, and no other has. They are told as they end. Call it
// before there are threads. Where there is no fork() the tasks are done here, one after the other.
void run_in_processes(std::size_t number_of_tasks, std::size_t at_once, const Task& task, const Tell& tell);

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_COLLECTION_RUN_IN_PROCESSES_H
