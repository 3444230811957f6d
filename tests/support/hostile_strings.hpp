// Texts that break programs which take them for more than text.
#pragma once

#include <string>
#include <vector>

namespace moat::testing {

/// One of each kind. Each tries to make a file `pwned`, to set the title of a page, to obey a terminal, or to leave its
/// field.
inline std::vector<std::string> hostile_strings() {
  using namespace std::string_literals;
  return {
      "<img src=x onerror=document.title='XSS'>",
      "</script><script>document.title='XSS'</script>",
      "<svg/onload=document.title='XSS'>",
      "\"><b onmouseover=\"document.title='XSS'\">",
      "javascript:document.title='XSS'",
      "${7*7}{{7*7}}<%= 7*7 %>",
      "]]><!ENTITY x SYSTEM \"file:///etc/passwd\">&x;&lt;&#0;",
      "<!-- --!> -->",
      "$(touch pwned)`touch pwned`;touch pwned|touch pwned&touch pwned\n touch pwned",
      "' \" \\ * ? ~ ! # %s %n %p",
      "../../../../pwned",
      "/tmp/pwned/../..",
      "C:\\pwned\\..\\CON",
      "'; DROP TABLE cases; --",
      "\" OR 1=1 --",
      "=cmd|' /C calc'!A0",
      "+cmd|' /C calc'!A0",
      "@SUM(1+1)*cmd|' /C calc'!A0",
      "\t=1+1",
      "a,b;c\"d\"\r\ne,f",
      "\x1b[31mred\x1b]0;title\a\x1b[2J\b\b\x7F",
      "\xC2\x9B"
      "31m",
      "\xE2\x80\xAEright to left\xE2\x81\xA7",
      "\xD7\xA9\xD7\x9C\xD7\x95\xD7\x9D",
      "\xF0\x9F\x8F\xA2\xF0\x9F\x92\xA5",
      "\xEF\xBF\xBE\xEF\xBF\xBF",
      "\xC3\x28\xFF\xFE\xED\xA0\x80",
      "a\0b"s,
      std::string(100000, 'a'),
  };
}

}  // namespace moat::testing
