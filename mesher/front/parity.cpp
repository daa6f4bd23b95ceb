#include "mesher/front/parity.hpp"

#include <algorithm>
#include <limits>
#include <queue>

namespace anisofront {
namespace {

class ParityGraph {
 public:
  ParityGraph(const std::vector<ParityLink>& links, Index parts)
      : links_(links), outside_(parts), links_of_(parts + 1), changed_(links.size(), 0) {
    for (std::size_t i = 0; i < links.size(); ++i) {
      const Index l = node_of(links[i].left), r = node_of(links[i].right);
      if (l == r) continue;
      links_of_[l].push_back(static_cast<Index>(i));
      links_of_[r].push_back(static_cast<Index>(i));
    }
  }

  /// Changes the links of a cheapest chain from the node to the nearest of the goals, which is
  /// returned, or kNoIndex when there is no way.
  Index lead(Index from, const std::vector<char>& is_goal) {
    reached_by_.assign(links_of_.size(), kNoIndex);
    distance_.assign(links_of_.size(), std::numeric_limits<double>::infinity());
    distance_[from] = 0;
    queue_ = {};
    queue_.push({0, from});
    while (!queue_.empty()) {
      const auto [distance, node] = queue_.top();
      queue_.pop();
      if (distance > distance_[node]) continue;
      if (node != from && is_goal[node]) {
        change_back_to(from, node);
        return node;
      }
      relax(node);
    }
    return kNoIndex;
  }

  Index outside() const { return outside_; }

  std::vector<Index> changed() const {
    std::vector<Index> list;
    for (std::size_t i = 0; i < changed_.size(); ++i)
      if (changed_[i]) list.push_back(static_cast<Index>(i));
    return list;
  }

 private:
  struct Entry {
    double distance;
    Index node;
    /// For std::priority_queue: the nearest comes out first, ties by number.
    friend bool operator<(const Entry& x, const Entry& y) {
      return x.distance > y.distance || (x.distance == y.distance && x.node > y.node);
    }
  };

  Index node_of(Index part) const { return part == kNoIndex ? outside_ : part; }
  Index other_end(Index link, Index node) const {
    const Index l = node_of(links_[link].left);
    return l == node ? node_of(links_[link].right) : l;
  }

  void relax(Index node) {
    for (const Index link : links_of_[node]) {
      const Index next = other_end(link, node);
      const double distance = distance_[node] + (changed_[link] ? 0 : links_[link].cost);
      if (distance >= distance_[next]) continue;
      distance_[next] = distance;
      reached_by_[next] = link;
      queue_.push({distance, next});
    }
  }

  void change_back_to(Index from, Index node) {
    while (node != from) {
      const Index link = reached_by_[node];
      changed_[link] ^= 1;
      node = other_end(link, node);
    }
  }

  const std::vector<ParityLink>& links_;
  Index outside_;  ///< its node, after those of the parts
  std::vector<std::vector<Index>> links_of_;
  std::vector<char> changed_;
  std::vector<double> distance_;
  std::vector<Index> reached_by_;
  std::priority_queue<Entry> queue_;
};

}  // namespace

std::vector<Index> cheapest_parity_changes(const std::vector<ParityLink>& links, Index parts,
                                           const std::vector<Index>& odd) {
  ParityGraph graph(links, parts);
  std::vector<char> is_goal(parts + 1, 0);
  is_goal[graph.outside()] = 1;
  for (const Index part : odd) is_goal[part] = 1;
  for (const Index part : odd) {
    if (!is_goal[part]) continue;
    const Index goal = graph.lead(part, is_goal);
    is_goal[part] = 0;
    if (goal != kNoIndex && goal != graph.outside()) is_goal[goal] = 0;
  }
  return graph.changed();
}

}  // namespace anisofront
