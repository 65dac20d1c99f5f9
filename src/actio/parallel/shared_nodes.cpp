#include "actio/parallel/shared_nodes.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace actio {
namespace {

void share_out(std::vector<std::array<double, 3>> const& places, std::span<int> nodes, int first, int ranks,
               std::vector<int>& owners) {
  if (ranks == 1 || nodes.empty()) {
    for (int const node : nodes) owners[static_cast<std::size_t>(node)] = first;
    return;
  }
  auto const place = [&](int node, std::size_t a) { return places[static_cast<std::size_t>(node)][a]; };
  std::size_t longest = 0;
  double most = -1;
  for (std::size_t a = 0; a < 3; ++a) {
    auto const [low, high] = std::ranges::minmax_element(nodes, {}, [&](int node) { return place(node, a); });
    if (double const length = place(*high, a) - place(*low, a); length > most) most = length, longest = a;
  }
  int const lower = ranks / 2;
  std::size_t const count = nodes.size() * static_cast<std::size_t>(lower) / static_cast<std::size_t>(ranks);
  std::ranges::nth_element(nodes, nodes.begin() + static_cast<long>(count), {},
                           [&](int node) { return std::pair(place(node, longest), node); });
  share_out(places, nodes.first(count), first, lower, owners);
  share_out(places, nodes.subspan(count), first + lower, ranks - lower, owners);
}

/// A whole number below 2^53 that other bytes hardly have (FNV-1a).
double fingerprint_of(std::initializer_list<std::span<std::byte const>> lists) {
  std::uint64_t hash = 14695981039346656037u;
  for (auto const& list : lists)
    for (std::byte const one : list) hash = (hash ^ static_cast<std::uint64_t>(one)) * 1099511628211u;
  return static_cast<double>(hash >> 11);
}

}  // namespace

std::vector<int> owners_of_nodes(std::vector<std::array<double, 3>> const& places, int ranks) {
  std::vector<int> owners(places.size(), 0), nodes(places.size());
  std::iota(nodes.begin(), nodes.end(), 0);
  share_out(places, nodes, 0, ranks, owners);
  return owners;
}

SharedNodes::SharedNodes(Ranks& ranks, std::vector<std::array<double, 3>> const& places, Cells const& cells,
                         int corners)
    : ranks_(ranks),
      fingerprint_(fingerprint_of({bytes_of(places), bytes_of(cells)})),
      sent_(static_cast<std::size_t>(ranks.size())),
      received_(static_cast<std::size_t>(ranks.size())) {
  std::vector<int> const owners = owners_of_nodes(places, ranks.size());
  auto const owner = [&](int node) { return owners[static_cast<std::size_t>(node)]; };
  int const me = ranks.rank();
  auto const of = [&](int cell) {
    return std::span(cells[static_cast<std::size_t>(cell)]).first(static_cast<std::size_t>(corners));
  };
  std::vector<int> here(places.size(), -1);
  for (int cell = 0; cell < static_cast<int>(cells.size()); ++cell)
    if (std::ranges::any_of(of(cell), [&](int node) { return owner(node) == me; })) {
      cells_.push_back(cell);
      for (int const node : of(cell)) here[static_cast<std::size_t>(node)] = 0;
    }
  for (std::size_t node = 0; node < places.size(); ++node) {
    if (here[node] < 0) continue;
    int const k = here[node] = static_cast<int>(nodes_.size());
    nodes_.push_back(static_cast<int>(node)), own_.push_back(owners[node] == me);
    (own_.back() ? own_nodes_ : received_[static_cast<std::size_t>(owners[node])]).push_back(k);
  }
  // Others have the cells that touch their nodes, and copy the corners of these.
  for (int const cell : cells_)
    for (int const node : of(cell))
      for (int const other : of(cell))
        if (owner(node) == me && owner(other) != me)
          sent_[static_cast<std::size_t>(owner(other))].push_back(here[static_cast<std::size_t>(node)]);
  for (auto& list : sent_) {
    std::ranges::sort(list);
    list.erase(std::ranges::unique(list).begin(), list.end());
  }
  if (me > 0) return;
  order_.resize(places.size());
  std::iota(order_.begin(), order_.end(), 0);
  std::ranges::stable_sort(order_, {}, owner);
}

void SharedNodes::require_same() const {
  double const most = ranks_.most(fingerprint_), least = -ranks_.most(-fingerprint_);
  if (most != least) throw Error("nodes on several ranks: the mesh is not the same on all of them");
}

void SharedNodes::complete(std::vector<double>& values) const {
  std::size_t const wide = width(values, nodes_);
  int const size = ranks_.size(), me = ranks_.rank();
  for (int k = 1; k < size; ++k) {
    int const to = (me + k) % size, from = (me - k + size) % size;
    auto const &sent = sent_[static_cast<std::size_t>(to)],
               &received = received_[static_cast<std::size_t>(from)];
    std::vector<double> const mine = taken(values, sent, wide);
    std::vector<double> theirs(wide * received.size());
    ranks_.exchange(sent.empty() ? -1 : to, bytes_of(mine), received.empty() ? -1 : from, bytes_of(theirs));
    put(theirs, received, wide, values);
  }
}

void SharedNodes::gather(std::vector<double> const& here, std::vector<double>& all) const {
  std::size_t const wide = width(here, nodes_);
  all.resize(wide * order_.size());
  std::vector<double> by_ranks(all.size());
  ranks_.gather(bytes_of(taken(here, own_nodes_, wide)), bytes_of(by_ranks));
  put(by_ranks, order_, wide, all);
}

void SharedNodes::scatter(std::vector<double> const& all, std::vector<double>& here) const {
  std::vector<double> const by_ranks = taken(all, order_, width(all, order_));
  std::vector<double> mine(width(here, nodes_) * own_nodes_.size());
  ranks_.scatter(bytes_of(by_ranks), bytes_of(mine));
  put(mine, own_nodes_, width(here, nodes_), here);
  complete(here);
}

std::vector<double> SharedNodes::taken(std::vector<double> const& from, std::vector<int> const& nodes,
                                       std::size_t width) {
  std::vector<double> out;
  out.reserve(width * nodes.size());
  for (int const node : nodes) {
    auto const first = from.begin() + static_cast<long>(width) * node;
    out.insert(out.end(), first, first + static_cast<long>(width));
  }
  return out;
}

void SharedNodes::put(std::vector<double> const& values, std::vector<int> const& nodes, std::size_t width,
                      std::vector<double>& to) {
  auto from = values.begin();
  for (int const node : nodes) {
    std::copy_n(from, width, to.begin() + static_cast<long>(width) * node);
    from += static_cast<long>(width);
  }
}

}  // namespace actio
