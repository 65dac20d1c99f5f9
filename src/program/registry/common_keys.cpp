#include "program/registry/common_keys.hpp"

#include <algorithm>

namespace actio::scene {

std::string order_as_written(std::string const& order) {
  return order.find_first_not_of("0123456789") == std::string::npos ? order : as_written(order);
}

std::string orders_of(std::vector<Method> const& methods, bool all) {
  std::string out;
  for (auto const& method : methods) {
    std::string orders;
    for (auto const& order : method.orders)
      if (all || orders.empty()) orders += (orders.empty() ? "" : ", ") + order_as_written(order);
    out += (out.empty() ? ""
            : all       ? "; "
                        : ", ") +
           (all ? method.name + " takes " + orders : orders + " for " + method.name);
  }
  return out;
}

std::vector<std::string> all_orders_of(std::vector<Method> const& methods) {
  std::vector<std::string> out;
  for (auto const& method : methods)
    for (auto const& order : method.orders)
      if (std::ranges::find(out, order) == out.end()) out.push_back(order);
  return out;
}

std::vector<std::string> OutputKeys::formats_of(System const& system) {
  std::vector<std::string> out{"csv", "hdf5"};
  if (system.snapshots)
    for (auto const& format : system.snapshots->formats) out.push_back(format.name);
  return out;
}
std::string OutputKeys::meaning_of_formats(System const& system) {
  std::string out;
  if (system.snapshots && !system.snapshots->in_hdf5.empty())
    out = " For snapshots, hdf5: " + system.snapshots->in_hdf5 + ".";
  if (system.snapshots)
    for (auto const& format : system.snapshots->formats)
      out += " For snapshots, " + format.name + ": " + format.meaning + ".";
  return out;
}

Pattern<std::vector<std::string>> SnapshotKeys::columns_of(SnapshotKind const& kind) {
  auto const some = some_of("column", names_of(kind.columns));
  auto const read = [some](SceneTable const& output, std::string const& name) {
    return output.texts(name).empty() ? Words{} : some.read(output, name);
  };
  return {some.expects, read, some.allowed};
}
std::string SnapshotKeys::meaning_of_columns(SnapshotKind const& kind) {
  std::string out;
  for (auto const& column : kind.columns)
    out += (out.empty() ? "" : "; ") + column.name + ": " + column.meaning;
  return out;
}

std::vector<Parameter> common_keys(System const& system) {
  auto const all = records_of({scene_keys, unit_keys, KindKeys{{"system"}, system.name},
                               MethodKeys{{"method"}, system.methods}, step_keys, run_keys,
                               OutputKeys{{"output"}, system, names_of(system.quantities)}});
  if (!system.snapshots) return all;
  return records_of({all, SnapshotKeys{{"output"}, *system.snapshots}, snapshot_times_keys});
}

}  // namespace actio::scene
