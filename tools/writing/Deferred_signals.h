// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROTRUSION_SEGMENTATION_TOOLS_WRITING_DEFERRED_SIGNALS_H
#define PROTRUSION_SEGMENTATION_TOOLS_WRITING_DEFERRED_SIGNALS_H

#include <csignal>
#include <utility>
#include <vector>

namespace tool
{

// While it lives, signals that ask the program to end wait: it would leave files that are half written. A file beyond the
// limit for its size is an error like a full disk.
class Deferred_signals
{
public:
  Deferred_signals()
  {
    defer(SIGINT, remember);
    defer(SIGTERM, remember);
#ifdef SIGHUP
    defer(SIGHUP, remember);
#endif
#ifdef SIGXFSZ
    defer(SIGXFSZ, SIG_IGN);
#endif
  }
  Deferred_signals(const Deferred_signals&) = delete;
  Deferred_signals& operator=(const Deferred_signals&) = delete;
  ~Deferred_signals()
  {
    for (const auto& [signal, handler] : m_before)
      std::signal(signal, handler);
    const int signal = remembered();
    remembered() = 0;
    if (signal != 0)
      std::raise(signal);
  }

  // Is there one that ends the program when the object is gone?
  static bool is_any_waiting() { return remembered() != 0; }

private:
  using Handler = void (*)(int);

  static volatile std::sig_atomic_t& remembered()
  {
    static volatile std::sig_atomic_t signal = 0;
    return signal;
  }
  static void remember(int signal) { remembered() = signal; }

  // What is ignored already, as under nohup, stays so.
  void defer(int signal, Handler handler)
  {
    const Handler before = std::signal(signal, handler);
    if (before == SIG_IGN)
      std::signal(signal, SIG_IGN);
    else if (before != SIG_ERR)
      m_before.emplace_back(signal, before);
  }

  std::vector<std::pair<int, Handler>> m_before;
};

} // namespace tool

#endif // PROTRUSION_SEGMENTATION_TOOLS_WRITING_DEFERRED_SIGNALS_H
