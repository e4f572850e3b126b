#include "report/html.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "report/words.h"

namespace shatterpave::reporting {

namespace {

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

}  // namespace

std::string escaped(std::string_view text) {
  return replaced(replaced(replaced(std::string(text), "&", "&amp;"), "<", "&lt;"), ">", "&gt;");
}

std::string as_script(std::string_view text) { return replaced(std::string(text), "</script", "<\\/script"); }

double rounded(double value) { return std::round(value * 1e4) / 1e4; }

Json histogram_data(const measure::Histogram& histogram) {
  std::size_t total = 0;
  for (const std::size_t count : histogram.counts) total += count;
  Json cells = Json::array();
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    const double low = histogram.low + histogram.width * static_cast<double>(i);
    const double share = total == 0 ? 0.0 : 100.0 * static_cast<double>(histogram.counts[i]) / static_cast<double>(total);
    if (histogram.counts[i] > 0) cells.push_back({rounded(low), rounded(low + histogram.width), rounded(share)});
  }
  return cells;
}

std::string findings_rows(std::span<const measure::Finding> findings, std::string_view prefix,
                          std::span<const measure::Finding> beside) {
  Buffer out;
  for (const measure::Finding& finding : findings) {
    const std::string_view word = word_of(finding.verdict);
    put_html(
        out,
        "<tr id=\"{}{}\"><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td><td class=\"number\">{} {}</td>"
        "<td><span class=\"verdict {}\">{}</span></td>",
        prefix, finding.id, finding.quantity, target_of(finding), figure_of(finding), grouped(finding.count), finding.counted,
        word, word);
    const auto other = std::ranges::find(beside, finding.id, &measure::Finding::id);
    if (other != beside.end()) {
      const std::string_view other_word = word_of(other->verdict);
      put_html(out, "<td class=\"number\">{} <span class=\"verdict {}\">{}</span></td>", figure_of(*other), other_word,
               other_word);
    }
    put_html(out, "</tr>\n");
  }
  return fmt::to_string(out);
}

std::string verdict_words(std::span<const measure::Finding> findings) {
  const auto count = [&](measure::Verdict verdict) {
    return std::ranges::count(findings, verdict, &measure::Finding::verdict);
  };
  std::string words = fmt::format("{} of {} hold", count(measure::Verdict::holds), findings.size());
  if (const auto fails = count(measure::Verdict::fails); fails > 0) words += fmt::format(", {} fail", fails);
  if (const auto open = count(measure::Verdict::open); open > 0) words += fmt::format(", {} left open by these seeds", open);
  return words;
}

std::string mean_and_deviation(const measure::Distribution& distribution, int decimals) {
  if (distribution.count() == 0) return "–";
  return fmt::format("{:.{}f} ± {:.{}f}", distribution.mean(), decimals, distribution.deviation(), decimals);
}

void fill(std::string& page, std::string_view mark, std::string_view text) {
  const std::string whole = fmt::format("<!--@{}-->", mark);
  const std::size_t at = page.find(whole);
  ENSURE(at != std::string::npos);
  page.replace(at, whole.size(), text);
}

}  // namespace shatterpave::reporting
