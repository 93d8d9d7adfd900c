// Copyright (c) 2026 The Hermite Diffuse Remeshing authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Hermite Diffuse Remeshing authors

#ifndef CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_FOR_EACH_INDEX_H
#define CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_FOR_EACH_INDEX_H

#include <CGAL/Hermite_diffuse_remeshing/internal/Progress.h>

#include <CGAL/tags.h>
#include <CGAL/use.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#endif

#include <type_traits>

namespace CGAL {
namespace Hermite_diffuse_remeshing {
namespace internal {

// Does a concurrency tag of CGAL ask for threads? A tag that asks for what is not there does not compile.
template <typename ConcurrencyTag>
constexpr bool is_parallel()
{
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value,
                "Parallel_tag needs TBB: link to the target CGAL::TBB_support");
#endif
  return std::is_convertible<ConcurrencyTag, Parallel_tag>::value;
}

// Calls worker(i) for i from 0 to n-1, in any order. Every thread has a worker of its own, made by
// `make_worker()`, which may keep buffers. The result is the same for any number of threads if
// worker(i) writes what belongs to i only, and nobody reads it. The calling thread alone tells of the progress.
template <typename MakeWorker>
void for_each_index(const int n, const bool is_parallel, const MakeWorker& make_worker,
                    const Progress& progress = Progress())
{
  // fewer than this are not worth waking a thread
  constexpr int least_number = 16;
#ifdef CGAL_LINKED_WITH_TBB
  if(is_parallel && n >= least_number)
  {
    // between two of these the threads meet, so that a stop is not waited for; even the cheapest of our workers take
    // a hundred times as long as the meeting
    constexpr int block_size = 2048;
    tbb::enumerable_thread_specific<std::decay_t<decltype(make_worker())> > workers(make_worker);
    for(int first = 0; first < n; )
    {
      const int last = n - first > block_size ? first + block_size : n;
      tbb::parallel_for(tbb::blocked_range<int>(first, last), [&](const tbb::blocked_range<int>& range)
      {
        auto& worker = workers.local();
        for(int i = range.begin(); i < range.end(); ++i)
          worker(i);
      });
      first = last;
      progress(double(first) / n);
    }
    return;
  }
#endif
  CGAL_USE(is_parallel);
  CGAL_USE(least_number);
  // a question costs as much as the cheapest of our workers
  constexpr int steps_per_question = 16;
  auto worker = make_worker();
  for(int i = 0; i < n; ++i)
  {
    worker(i);
    if((i + 1) % steps_per_question == 0 || i + 1 == n)
      progress(double(i + 1) / n);
  }
}

} // namespace internal
} // namespace Hermite_diffuse_remeshing
} // namespace CGAL

#endif // CGAL_HERMITE_DIFFUSE_REMESHING_INTERNAL_FOR_EACH_INDEX_H
