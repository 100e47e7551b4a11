// SPDX-License-Identifier: GPL-3.0-or-later
// The page of a result without the result, as the build embeds it from page/ (cmake/page.cmake).
#pragma once

#include <string_view>

namespace c1mesh::page {

/// HTML with the places {{title}}, {{style}}, {{dark}}, {{result}} and {{script}}.
extern const std::string_view kTemplate;
extern const std::string_view kScript, kStyle, kDark;

}  // namespace c1mesh::page
