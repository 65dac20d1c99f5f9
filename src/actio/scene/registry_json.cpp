#include "actio/scene/registry_json.hpp"

#include <nlohmann/json.hpp>

#include "actio/scene/system.hpp"

namespace actio::scene {
namespace {

using Json = nlohmann::ordered_json;

char const* kind_name(Quantity::Kind kind) {
  using Kind = Quantity::Kind;
  switch (kind) {
    case Kind::scalar: return "scalar";
    case Kind::vector: return "vector";
    case Kind::quaternion: return "quaternion";
    case Kind::matrix: return "matrix";
    case Kind::skew: return "skew matrix";
    case Kind::list: return "list";
  }
  return "";
}

Json in_json(System const& system) {
  Json out{{"name", system.name}, {"title", system.title}, {"meaning", system.meaning}, {"statement", system.statement}, {"parameters", Json::array()}, {"methods", Json::array()}, {"quantities", Json::array()}};
  for (auto const& p : system.parameters) out["parameters"].push_back({{"key", p.key}, {"expects", p.expects}, {"fallback", p.fallback}, {"meaning", p.meaning}});
  for (auto const& m : system.methods) out["methods"].push_back({{"name", m.name}, {"orders", m.orders}, {"meaning", m.meaning}, {"statement", m.statement}});
  for (auto const& q : system.quantities)
    out["quantities"].push_back({{"name", q.name}, {"kind", kind_name(q.kind)}, {"meaning", q.meaning}, {"formula", q.formula}, {"unit", q.unit}, {"statement", q.statement}, {"needs", q.needs}, {"conserved", q.conserved}});
  return out;
}

}  // namespace

std::string registry_json() {
  Json out = Json::array();
  for (auto const& system : systems()) out.push_back(in_json(system));
  return out.dump(1) + "\n";
}

}  // namespace actio::scene
