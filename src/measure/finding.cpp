#include "measure/finding.h"

#include <algorithm>

#include "core/error.h"

namespace shatterpave::measure {

namespace {

Verdict verdict_of(const Finding& finding) {
  const bool two_sided = finding.low > -unlimited && finding.high < unlimited;
  if (finding.count == 0) return Verdict::open;
  if (two_sided && finding.error > 0.25 * (finding.high - finding.low)) return Verdict::open;
  return finding.low <= finding.figure && finding.figure <= finding.high ? Verdict::holds : Verdict::fails;
}

}  // namespace

Finding judged(Finding finding) {
  finding.verdict = verdict_of(finding);
  return finding;
}

const Finding& finding_of(std::span<const Finding> findings, std::string_view id) {
  const auto found = std::ranges::find(findings, id, &Finding::id);
  ENSURE(found != findings.end());
  return *found;
}

}  // namespace shatterpave::measure
