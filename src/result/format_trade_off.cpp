// SPDX-License-Identifier: GPL-3.0-or-later
// TradeOff -> text of docs/format.md, a point per line.
#include <nlohmann/json.hpp>

#include "c1mesh/trade_off.h"

namespace c1mesh {
namespace {

// Keeps the keys in the document's order.
using Json = nlohmann::ordered_json;

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

const char* name_of(TradeOffEnd end) {
  switch (end) {
    case TradeOffEnd::flat:
      return "flat";
    case TradeOffEnd::most:
      return "most";
    case TradeOffEnd::time_limit:
      return "time limit";
  }
  return "unknown";
}

Json json_of(const TradeOffPoint& p) {
  return {{"asked", p.asked},
          {"exceptional", p.exceptional},
          {"surplus", p.surplus},
          {"g", p.g},
          {"g_median", p.g_median},
          {"triangles", p.triangles},
          {"d_ei_max", p.d_ei_max},
          {"regular", p.regular},
          {"c1", p.c1},
          {"dominated", p.dominated}};
}

}  // namespace

std::string format_trade_off(const TradeOff& curve) {
  Json parameters = Json::object();
  for (const auto& [key, value] : curve.parameters)
    std::visit([&, &name = key](const auto& v) { parameters[name] = v; }, value);
  std::string out = "{\"format\":\"c1mesh trade-off\",\"version\":1,\n\"name\":";
  out += text_of(curve.name);
  out += ",\n\"parameters\":" + text_of(parameters);
  out += ",\n\"bound\":" + text_of(curve.bound);
  out += ",\n\"exceptional_minimum\":" + text_of(curve.minimum);
  out += ",\n\"points\":[";
  for (std::size_t i = 0; i < curve.points.size(); ++i)
    out += (i ? ",\n" : "\n") + text_of(json_of(curve.points[i]));
  out += "],\n\"end\":";
  return out + text_of(name_of(curve.end)) + "}\n";
}

}  // namespace c1mesh
