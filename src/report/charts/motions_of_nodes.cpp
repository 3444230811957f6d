#include "report/charts/motions_of_nodes.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace moat {

std::vector<NodeMotion> motions_of_nodes(const CaseResult& result) {
  std::map<std::pair<std::string_view, std::string_view>, const Column*> columns;
  for (const Column& column : result.histories.columns) columns[{column.quantity, column.where}] = &column;
  const auto column_of = [&](std::string_view quantity, std::string_view where) {
    const auto found = columns.find({quantity, where});
    return found == columns.end() ? nullptr : found->second;
  };
  std::map<std::string, NodeMotion> in_plan;  // by the name of the node
  for (const DiaphragmFacts& diaphragm : result.model.diaphragms) {
    in_plan[diaphragm.name + ":x"] = {column_of("displacement_x", diaphragm.name)};
    in_plan[diaphragm.name + ":y"] = {column_of("displacement_y", diaphragm.name)};
    in_plan[diaphragm.name + ":r"] = {column_of("rotation", diaphragm.name), diaphragm.gyration};
  }
  std::vector<NodeMotion> motions;
  for (const NodeFacts& node : result.model.nodes) {
    const auto found = in_plan.find(node.name);
    motions.push_back(found != in_plan.end() ? found->second : NodeMotion{column_of("displacement", node.name)});
  }
  return motions;
}

}  // namespace moat
