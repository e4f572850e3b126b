#include "report/words.h"

#include <fmt/format.h>

#include <cmath>

namespace shatterpave::reporting {

namespace {

using measure::Finding;

bool is_two_sided(const Finding& finding) { return std::isfinite(finding.low) && std::isfinite(finding.high); }

// The degree sign follows its number, other units stand apart.
std::string with_unit(std::string number, std::string_view unit) {
  if (!unit.empty() && unit != "°") number += ' ';
  return number.append(unit);
}

// Decimals of a figure, so that a hundredth of the range's width (of the bound, where there is one only) can be told.
int decimals_of(const Finding& finding) {
  double scale = std::abs(std::isfinite(finding.low) ? finding.low : finding.high);
  if (is_two_sided(finding)) scale = finding.high - finding.low;
  if (scale == 0.0) return 0;
  int decimals = 2;
  for (; scale < 1.0 && decimals < 6; scale *= 10.0) ++decimals;
  for (; scale >= 10.0 && decimals > 0; scale *= 0.1) --decimals;
  return decimals;
}

// −0.00 reads as a slip.
std::string rounded(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

// With a true minus sign.
std::string typeset(std::string text) {
  if (text.starts_with('-')) text.replace(0, 1, "−");
  return text;
}

}  // namespace

std::string grouped(std::size_t count) {
  std::string text = fmt::format("{}", count);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, 1, ',');
  return text;
}

std::string_view word_of(measure::Verdict verdict) {
  switch (verdict) {
    case measure::Verdict::holds:
      return "holds";
    case measure::Verdict::fails:
      return "fails";
    case measure::Verdict::open:
      break;
  }
  return "open";
}

std::string target_of(const Finding& finding) {
  if (!is_two_sided(finding)) {
    const bool at_least = std::isfinite(finding.low);
    return with_unit(fmt::format("{} {:.4g}", at_least ? "≥" : "≤", at_least ? finding.low : finding.high), finding.unit);
  }
  if (finding.low == finding.high) return with_unit(fmt::format("{:.4g}", finding.low), finding.unit);
  const double middle = 0.5 * (finding.low + finding.high);
  return with_unit(fmt::format("{:.4g} ± {:.4g}", middle, finding.high - middle), finding.unit);
}

std::string figure_of(const Finding& finding) {
  if (finding.count == 0 || !std::isfinite(finding.figure)) return "–";
  const int decimals = decimals_of(finding);
  std::string text = typeset(rounded(finding.figure, decimals));
  if (finding.error > 0.0 && std::isfinite(finding.error)) text += " ± " + rounded(finding.error, decimals);
  return with_unit(std::move(text), finding.unit);
}

}  // namespace shatterpave::reporting
