#include "program/registry/quantity.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace actio::scene {

char const* kind_name(Quantity::Kind kind) {
  constexpr char const* names[] = {"scalar", "vector", "quaternion", "matrix", "skew matrix", "list"};
  return names[static_cast<std::size_t>(kind)];
}

std::vector<std::size_t> ColumnGroup::shape() const {
  std::size_t const size = columns.size();
  if (quantity.kind == Quantity::Kind::scalar) return {};
  if (quantity.kind != Quantity::Kind::matrix) return {size};
  std::size_t n = 1;
  while (n * n < size) ++n;
  return {n, n};
}

std::vector<std::string> column_ends(Quantity::Kind kind, int n) {
  using Kind = Quantity::Kind;
  auto const index = [](int i, int j) {
    return "_" + std::to_string(i) + (std::max(i, j) > 9 ? "_" : "") + std::to_string(j);
  };
  std::vector<std::string> ends;
  switch (kind) {
    case Kind::scalar:
      return {""};
    case Kind::vector:
      return {"_x", "_y", "_z"};
    case Kind::quaternion:
      return {"_w", "_x", "_y", "_z"};
    case Kind::matrix:
      for (int i = 1; i <= n; ++i)
        for (int j = 1; j <= n; ++j) ends.push_back(index(i, j));
      return ends;
    case Kind::skew:
      for (int i = 1; i <= n; ++i)
        for (int j = i + 1; j <= n; ++j) ends.push_back(index(i, j));
      return ends;
    case Kind::list:
      break;
  }
  throw std::logic_error("column_ends: a list has numbers of its own");
}

std::vector<std::string> numbered(int first, int last, int apart) {
  std::vector<std::string> ends;
  for (int k = first; k <= last; k += apart) ends.push_back("_" + std::to_string(k));
  return ends;
}

QuantityGraph::QuantityGraph(std::vector<Quantity> known) {
  for (auto& quantity : known) nodes_.push_back({std::move(quantity), {}, {}, {}, {}, {}, false, 0});
}

QuantityGraph::Node& QuantityGraph::node(std::string const& name) {
  return const_cast<Node&>(std::as_const(*this).node(name));
}
QuantityGraph::Node const& QuantityGraph::node(std::string const& name) const {
  auto const found =
      std::find_if(nodes_.begin(), nodes_.end(), [&](Node const& n) { return n.quantity.name == name; });
  if (found == nodes_.end()) throw std::logic_error("quantities: there is no " + name);
  return *found;
}

void QuantityGraph::define(std::string const& name, std::vector<std::string> ends, Evaluate evaluate,
                           NaturalUnit unit) {
  Node& n = node(name);
  n.value.assign(ends.size(), 0);
  n.ends = std::move(ends), n.evaluate = std::move(evaluate), n.unit = std::move(unit);
}

void QuantityGraph::conserve(std::function<bool(std::string const& name)> const& conserved) {
  for (auto& n : nodes_) n.quantity.conserved = conserved(n.quantity.name);
}

void QuantityGraph::require(Node& n) {
  if (n.needed) return;
  if (!n.evaluate) throw std::logic_error("quantities: " + n.quantity.name + " is not defined");
  n.needed = true;
  for (auto const& name : n.quantity.needs) {
    require(node(name));
    n.needs.push_back(node(name).value.data());
  }
  plan_.push_back(&n);  // after what it needs
}

void QuantityGraph::ask(std::vector<std::string> const& names) {
  for (auto const& name : names) {
    asked_.push_back(&node(name));
    require(*asked_.back());
    row_size_ += asked_.back()->value.size();
  }
}

std::vector<Quantity> QuantityGraph::known() const {
  std::vector<Quantity> out;
  for (auto const& node : nodes_) out.push_back(node.quantity);
  return out;
}

bool QuantityGraph::needed(std::string const& name) const { return node(name).needed; }

std::vector<ColumnGroup> QuantityGraph::column_groups() const {
  std::vector<ColumnGroup> out;
  for (Node const* n : asked_) {
    out.push_back({n->quantity, {}});
    for (auto const& end : n->ends) out.back().columns.push_back(n->quantity.name + end);
  }
  return out;
}

std::vector<std::string> QuantityGraph::columns() const {
  std::vector<std::string> out;
  for (auto const& group : column_groups()) out.insert(out.end(), group.columns.begin(), group.columns.end());
  return out;
}

void QuantityGraph::evaluate(std::span<double> row) {
  for (Node* n : plan_) {
    n->evaluate(n->needs, n->value.data());
    ++n->evaluations;
  }
  double* at = row.data();
  for (Node const* n : asked_) at = std::copy(n->value.begin(), n->value.end(), at);
}

std::vector<QuantityGraph::Count> QuantityGraph::counts() const {
  std::vector<Count> out;
  for (auto const& n : nodes_)
    out.push_back(
        {n.quantity.name, std::find(asked_.begin(), asked_.end(), &n) != asked_.end(), n.evaluations});
  return out;
}

void QuantityGraph::remember(CheckpointStream& stream) {
  for (auto& n : nodes_) stream(n.evaluations);
}

std::vector<QuantityGraph::Conserved> QuantityGraph::conserved() const {
  std::vector<Conserved> out;
  std::size_t at = 0;
  for (Node const* n : asked_) {
    std::size_t const size = n->value.size();
    if (n->quantity.conserved && n->quantity.kind == Quantity::Kind::list)
      for (std::size_t i = 0; i < size; ++i) out.push_back({n->quantity.name + n->ends[i], at + i, 1});
    else if (n->quantity.conserved)
      out.push_back({n->quantity.name, at, size});
    at += size;
  }
  return out;
}

std::vector<QuantityGraph::Unit> QuantityGraph::natural_units() const {
  std::vector<Unit> out;
  bool const any =
      std::ranges::any_of(asked_, [](Node const* n) { return n->quantity.conserved && n->unit; });
  if (!any) return out;
  for (Node const* n : asked_) {
    if (!n->quantity.conserved) continue;
    std::size_t const count = n->quantity.kind == Quantity::Kind::list ? n->value.size() : 1;
    for (std::size_t i = 0; i < count; ++i)
      out.push_back(n->unit ? n->unit(n->needs, n->value.data(), i) : Unit());
  }
  return out;
}

}  // namespace actio::scene
