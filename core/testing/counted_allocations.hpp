// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>

/// Counts what anyone takes from operator new or gives back, in a program that links to it.
namespace hexagait::testing {

extern std::atomic<long> allocations, deallocations;

/// malloc(), counted too: for libraries with an allocator of their own.
[[nodiscard]] void* counted_malloc(std::size_t size);

}  // namespace hexagait::testing
