// SPDX-License-Identifier: GPL-3.0-or-later
// What comes before what in a parallel loop, told to the thread sanitizer. TBB is not compiled with
// it (nor is parallel.cpp), so that it does not see how TBB hands work to threads and waits for
// them. It is told that the items come after what the caller did before the loop, and before what
// the caller does next; nothing orders two items, so that it finds races between them.
#pragma once

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace c1mesh {

#ifdef __SANITIZE_THREAD__
class LoopOrder {
 public:
  LoopOrder() { __tsan_release(&begun_); }
  ~LoopOrder() { __tsan_acquire(&ended_); }  // after an exception, too
  LoopOrder(const LoopOrder&) = delete;
  LoopOrder& operator=(const LoopOrder&) = delete;

  /// Around some items, in the thread that does them.
  class Items {
   public:
    explicit Items(const LoopOrder& order) : order_(order) { __tsan_acquire(&order.begun_); }
    ~Items() { __tsan_release(&order_.ended_); }
    Items(const Items&) = delete;
    Items& operator=(const Items&) = delete;

   private:
    const LoopOrder& order_;
  };

 private:
  // Two: with one, an item would come after those that ended before.
  mutable char begun_ = 0, ended_ = 0;
};
#else
class LoopOrder {
 public:
  struct Items {
    explicit Items(const LoopOrder&) {}
    ~Items() {}
  };
};
#endif

}  // namespace c1mesh
