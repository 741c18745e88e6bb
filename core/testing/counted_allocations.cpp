// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>
#include <new>
#include <testing/counted_allocations.hpp>

namespace hexagait::testing {

std::atomic<long> allocations = 0, deallocations = 0;

void* counted_malloc(std::size_t size) {
  ++allocations;
  return std::malloc(size);
}

}  // namespace hexagait::testing

namespace {

using hexagait::testing::allocations;
using hexagait::testing::counted_malloc;

void counted_free(void* block) {
  ++hexagait::testing::deallocations;
  std::free(block);
}

}  // namespace

// Not inlined: GCC would see free() meet operator new, and warn.
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (void* block = counted_malloc(size)) return block;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return counted_malloc(size);
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t align) {
  ++allocations;
  const auto alignment = static_cast<std::size_t>(align);
  if (void* block = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment))
    return block;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* block) noexcept { counted_free(block); }
[[gnu::noinline]] void operator delete(void* block, std::size_t) noexcept { counted_free(block); }
[[gnu::noinline]] void operator delete(void* block, std::align_val_t) noexcept {
  counted_free(block);
}
[[gnu::noinline]] void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
  counted_free(block);
}
