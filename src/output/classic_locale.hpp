// Decimal points where a library writes numbers through streams.
#pragma once

#include <locale>

namespace moat {

/// During its lifetime, new streams of the program write numbers as C++ does by default: VTK makes streams of its own,
/// which would take over the decimal comma of a program that has called std::locale::global.
class ClassicLocale {
 public:
  ClassicLocale() {
    if (before_ != std::locale::classic()) std::locale::global(std::locale::classic());
  }
  ~ClassicLocale() {
    if (before_ != std::locale::classic()) std::locale::global(before_);
  }
  ClassicLocale(const ClassicLocale&) = delete;
  ClassicLocale& operator=(const ClassicLocale&) = delete;

 private:
  std::locale before_;
};

}  // namespace moat
