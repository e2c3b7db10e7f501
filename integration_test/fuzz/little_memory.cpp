// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Libraries ask for as much memory as a file announces, before they look for it in the file. Here they get none above a
// limit, as on a small machine, so that the same happens on all, and what follows is tried.

#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t limit = std::size_t(1) << 30;

void* allocate(std::size_t size) noexcept { return size <= limit ? std::malloc(size > 0 ? size : 1) : nullptr; }

void* allocate_or_throw(std::size_t size)
{
  void* result = allocate(size);
  if (result == nullptr)
    throw std::bad_alloc();
  return result;
}

} // namespace

void* operator new(std::size_t size) { return allocate_or_throw(size); }
void* operator new[](std::size_t size) { return allocate_or_throw(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

// The address sanitizer asks for this, and does the same to std::malloc().
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() { return "allocator_may_return_null=1:max_allocation_size_mb=1024"; }
