#include "mesher/front/front_queue.hpp"

#include <algorithm>
#include <random>

#include <doctest/doctest.h>

using namespace anisofront;

namespace {

/// Pops until nothing is left; each edge is retired as the front does it.
std::vector<Index> drain(FrontQueue& queue, std::vector<FrontEdge>& edges) {
  std::vector<Index> order;
  for (Index id = queue.pop(edges); id != kNoIndex; id = queue.pop(edges)) {
    order.push_back(id);
    ++edges[id].version;
  }
  return order;
}

}  // namespace

TEST_SUITE("unit") {
  TEST_CASE("the shortest edge in the metric comes first and the older of two equals") {
    std::vector<FrontEdge> edges(5);
    FrontQueue queue(BaseOrder::metric_length);
    const double metric[] = {2, 1, 3, 1, 0.5}, physical[] = {1, 5, 2, 4, 9};
    for (Index i = 0; i < 5; ++i) queue.push(i, 0, metric[i], physical[i]);
    CHECK(drain(queue, edges) == std::vector<Index>{4, 1, 3, 0, 2});
  }

  TEST_CASE("the paper takes the shortest edge in physical space") {
    std::vector<FrontEdge> edges(5);
    FrontQueue queue(BaseOrder::physical_length);
    const double metric[] = {2, 1, 3, 1, 0.5}, physical[] = {1, 5, 2, 4, 1};
    for (Index i = 0; i < 5; ++i) queue.push(i, 0, metric[i], physical[i]);
    CHECK(drain(queue, edges) == std::vector<Index>{0, 4, 2, 3, 1});
  }

  // Unit: length within one percent of 1.
  TEST_CASE("classes put short edges before unit edges before long ones and the oldest first") {
    std::vector<FrontEdge> edges(7);
    FrontQueue queue(BaseOrder::metric_class);
    const double squared[] = {1.5, 1.001, 0.9, 0.999, 0.2, 1.2, 1};
    for (Index i = 0; i < 7; ++i) queue.push(i, 0, squared[i], 1);
    CHECK(drain(queue, edges) == std::vector<Index>{2, 4, 1, 3, 6, 0, 5});
  }

  TEST_CASE("by age the oldest comes first whatever its length") {
    std::vector<FrontEdge> edges(5);
    FrontQueue queue(BaseOrder::age);
    const double squared[] = {2, 1, 3, 1, 0.5};
    for (Index i = 0; i < 5; ++i) queue.push(i, 0, squared[i], squared[i]);
    ++edges[1].version;  // removed, and its slot used again
    queue.push(1, edges[1].version, 0.1, 0.1);
    CHECK(drain(queue, edges) == std::vector<Index>{0, 2, 3, 4, 1});
  }

  TEST_CASE("entries of removed edges are skipped and reused slots count with their new key") {
    for (const auto order :
         {BaseOrder::metric_length, BaseOrder::metric_class, BaseOrder::physical_length}) {
      std::vector<FrontEdge> edges(3);
      FrontQueue queue(order);
      queue.push(0, 0, 0.5, 0.5);
      queue.push(1, 0, 1, 1);
      queue.push(2, 0, 2, 2);
      ++edges[0].version;  // removed
      ++edges[2].version;  // removed, and its slot used again by a short edge
      queue.push(2, edges[2].version, 0.1, 0.1);
      CHECK(drain(queue, edges) == std::vector<Index>{2, 1});
      CHECK(queue.pop(edges) == kNoIndex);
    }
  }

  TEST_CASE("an edge is popped once only") {
    std::vector<FrontEdge> edges(1);
    FrontQueue queue(BaseOrder::metric_length);
    queue.push(0, 0, 1, 1);
    CHECK(queue.pop(edges) == 0);
    CHECK(queue.pop(edges) == kNoIndex);
  }

  TEST_CASE("queues longer than their compaction keep the order of age within a class") {
    std::vector<FrontEdge> edges(20000);
    FrontQueue queue(BaseOrder::metric_class);
    std::vector<Index> expected, found;
    for (Index i = 0; i < 20000; ++i) {
      queue.push(i, 0, 4, 4);
      if (i % 3 == 0) {
        ++edges[i].version;
      } else {
        expected.push_back(i);
      }
      if (i % 2 == 0) continue;  // pop half as fast as pushed
      found.push_back(queue.pop(edges));
    }
    for (Index id = queue.pop(edges); id != kNoIndex; id = queue.pop(edges)) found.push_back(id);
    CHECK(found == expected);
  }
}
