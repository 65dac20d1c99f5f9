#include "program/document/key.hpp"

namespace actio::scene {

std::string as_written(std::string const& value) { return '"' + value + '"'; }
std::string as_written(std::vector<std::string> const& value) {
  std::string out;
  for (auto const& one : value) out += (out.empty() ? "" : ", ") + as_written(one);
  return '[' + out + ']';
}

std::string const& KeyTable::add(Parameter record) {
  record.key = name_ + "." + record.key;
  return records_.emplace_back(std::move(record)).key;
}

std::vector<Parameter> records_of(std::initializer_list<KeyTable> tables) {
  std::vector<Parameter> out;
  for (auto const& table : tables) out.insert(out.end(), table.records().begin(), table.records().end());
  return out;
}

}  // namespace actio::scene
