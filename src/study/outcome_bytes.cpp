#include "study/outcome_bytes.hpp"

#include <nlohmann/json.hpp>

namespace moat {

using Json = nlohmann::json;

std::string to_bytes(const CaseOutcome& outcome) {
  Json files = Json::array(), results = Json::array();
  for (const FileRead& each : outcome.files) files.push_back(Json::array({each.path, each.sha256}));
  for (const NamedNumber& each : outcome.results)
    results.push_back(Json::array({each.quantity, each.where, each.unit, each.value}));
  Json list = Json::array();  // of one
  list.push_back(Json::array(
      {outcome.state, outcome.reason, files, outcome.steps, outcome.energy_error, outcome.seconds, results}));
  std::string bytes;
  Json::to_cbor(list, bytes);
  return bytes;
}

CaseOutcome from_bytes(std::string_view bytes) {
  const Json list = Json::from_cbor(bytes), &each = list[0];
  CaseOutcome outcome{.state = each[0], .reason = each[1]};
  for (const Json& file : each[2]) outcome.files.push_back({file[0], file[1]});
  outcome.steps = each[3];
  outcome.energy_error = each[4];
  outcome.seconds = each[5];
  for (const Json& result : each[6]) outcome.results.push_back({result[0], result[1], result[2], result[3]});
  return outcome;
}

}  // namespace moat
