import { programIssue } from "./issue.ts";
import type { Finding } from "./run-types.ts";

/** Findings of one kind that are listed one by one. More would fill memory and lists, and say nothing new. */
export const MOST_ALIKE = 1000;

/**
 * Findings in the order of the text, of each kind the first MOST_ALIKE. In the place of the first that is left out stands how
 * many there are, as grave as the gravest of them: nothing is left out in silence.
 */
export function fewAlike(findings: readonly Finding[]): Finding[] {
  if (findings.length <= MOST_ALIKE) return [...findings];
  const counts = new Map<string, number>();
  const gravest = new Map<string, "error" | "warning" | "info">();
  for (const { issue: { code, severity } } of findings) {
    const count = (counts.get(code) ?? 0) + 1;
    counts.set(code, count);
    if (count > MOST_ALIKE && (severity === "error" || gravest.get(code) !== "error") && severity !== "info") gravest.set(code, severity);
  }
  const seen = new Map<string, number>();
  return findings.flatMap((finding) => {
    const { code } = finding.issue;
    const count = (seen.get(code) ?? 0) + 1;
    seen.set(code, count);
    if (count <= MOST_ALIKE) return [finding];
    if (count > MOST_ALIKE + 1) return [];
    const more = programIssue("moreAlike", gravest.get(code) ?? "info", { code, count: (counts.get(code) ?? 0) - MOST_ALIKE });
    return [{ ...finding, issue: more, operation: null }];
  });
}
