// SPDX-License-Identifier: GPL-3.0-or-later
// The page of a result: page/ with the result file as data inside.
#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "base/xml.h"
#include "c1mesh/write.h"
#include "write/page_text.h"

namespace c1mesh {
namespace {

using Json = nlohmann::json;

/// `text` as JSON; what is not UTF-8 becomes U+FFFD.
std::string quoted(const std::string& text) {
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The same JSON without the character that could end a script element or begin a comment there:
/// in JSON it occurs in strings only, which know it as an escape.
std::string harmless(const std::string& json) {
  std::string out;
  out.reserve(json.size());
  for (const char c : json) {
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  }
  return out;
}

/// A name may be any bytes; a title is text.
std::string title_of(const Result& result) {
  return xml_escaped(Json::parse(quoted(result.name)).get<std::string>()) + " – c1mesh";
}

}  // namespace

std::string format_html(const Result& result) {
  const std::string data =
      harmless("{\"name\":" + quoted(result.name) + ",\n\"result\":" + format_result(result) + "}");
  const std::string title = title_of(result);
  const std::array<std::pair<std::string_view, std::string_view>, 5> places{
      {{"{{title}}", title},
       {"{{style}}", page::kStyle},
       {"{{dark}}", page::kDark},
       {"{{result}}", data},
       {"{{script}}", page::kScript}}};
  // In the order of the template, so that nothing is looked for in what was put in.
  std::string out;
  std::string_view rest = page::kTemplate;
  for (const auto& [mark, text] : places) {
    const std::size_t at = rest.find(mark);
    if (at == std::string_view::npos)
      throw std::logic_error("the page has no " + std::string(mark));
    out += rest.substr(0, at);
    out += text;
    rest.remove_prefix(at + mark.size());
  }
  return out.append(rest);
}

}  // namespace c1mesh
