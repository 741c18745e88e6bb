// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <hexagait/urdf/detail/leg_candidates.hpp>

namespace hexagait {
namespace {

constexpr int kFewestOfALimb = 2;  // turning joints

/// Walks the tree of a file.
class Search {
 public:
  explicit Search(const UrdfFile& file) : file_(file), depth_(file.joints.size(), -1) {}

  void leave(int link, LegCandidates& found) {
    for (const int next : departures(link)) {
      if (is_waist(next)) {
        found.waists.push_back(next);
        leave(joint(next).child, found);
        continue;
      }
      found.chains.push_back({});
      follow(next, found.chains.back());
    }
  }

 private:
  const FileJoint& joint(int i) const { return file_.joint(i); }

  /// The joints that leave a link and what is fixed to it.
  JointChain departures(int link) const {
    JointChain found;
    for (const int next : file_.link(link).child_joints) {
      if (joint(next).type != FileJoint::Type::fixed) {
        found.push_back(next);
        continue;
      }
      const JointChain more = departures(joint(next).child);
      found.insert(found.end(), more.begin(), more.end());
    }
    return found;
  }

  /// Turning joints of the longest chain that begins with this joint.
  int depth(int i) {
    int& known = depth_[static_cast<std::size_t>(i)];
    if (known >= 0) return known;
    int beyond = 0;
    for (const int next : departures(joint(i).child)) beyond = std::max(beyond, depth(next));
    return depth_[static_cast<std::size_t>(i)] = beyond + (joint(i).turns() ? 1 : 0);
  }

  bool is_waist(int i) {
    const auto is_limb = [this](int next) { return depth(next) >= kFewestOfALimb; };
    const JointChain next = departures(joint(i).child);
    return std::ranges::count_if(next, is_limb) >= 2;
  }

  void follow(int i, LegCandidate& candidate) {
    (joint(i).turns() ? candidate.joints : candidate.held).push_back(i);
    const JointChain next = departures(joint(i).child);
    const auto longest = std::ranges::max_element(next, {}, [this](int j) { return depth(j); });
    for (auto j = next.begin(); j != next.end(); ++j)
      if (j != longest) candidate.held.push_back(*j);
    if (longest != next.end()) follow(*longest, candidate);
  }

  const UrdfFile& file_;
  std::vector<int> depth_;  ///< of each joint; −1: not known yet
};

}  // namespace

LegCandidates leg_candidates(const UrdfFile& file) {
  LegCandidates candidates;
  Search(file).leave(file.root, candidates);
  return candidates;
}

}  // namespace hexagait
