import { useEffect, useState } from "react";
import { lettersApart } from "../../nc/typing-slips.ts";
import type { ToolFit } from "../../program/tools/which-tool.ts";
import { FIXED_BY_TOOL } from "../../report/offered-tool.ts";
import { outcomeOfOther } from "../calculation/other-outcome.ts";
import { takeAnswer, untilGone } from "../base/until-gone.ts";
import { CALCULATING } from "../base/waits.ts";
import { fitsOfCall } from "../calculation/tool-questions.ts";
import { useOutcome } from "../calculation/outcome.ts";
import { useTexts } from "../base/settings/use-texts.ts";
import { bundleOf, useEditor } from "../document/store.ts";
import { createCalledTool } from "../document/tool-row.ts";
import { isError, type FindingEntry } from "./entry.ts";
import { findingsOf } from "./findings.ts";
import type { FindingsHost, Fix, Trial } from "./host.ts";

/** Most tools that are offered. */
const MOST_TOOLS = 3;
/** Letters by which a called tool may differ from one of the table. */
const MOST_APART = 2;

const UNKNOWN_TOOL: ReadonlySet<string> = new Set(["toolUnknown", "toolIndexUnknown"]);
const NONE: readonly Fix[] = [];

/** Tools that make the contour: those spelt like the called one first. */
function suitable(fits: readonly ToolFit[], { issue }: FindingEntry): readonly ToolFit[] {
  const found = fits.filter((fit) => fit.makesContour);
  if (!UNKNOWN_TOOL.has(issue.code) || !("tool" in issue.data)) return found.slice(0, 1);
  const called = String(issue.data.tool).toUpperCase();
  const apart = ({ tool }: ToolFit) =>
    Math.min(
      tool.NAME.toUpperCase().startsWith(called) ? 0 : MOST_APART + 1,
      ...[String(tool.T), tool.NAME.toUpperCase()].map((name) => lettersApart(called, name, MOST_APART)),
    );
  return found.toSorted((a, b) => apart(a) - apart(b)).slice(0, MOST_TOOLS);
}

/** Tools of the table that can make the contour where the called one cannot, or does not exist. */
export function useToolOffers(entry: FindingEntry, host: FindingsHost): readonly Fix[] {
  const { setup, findings } = useTexts();
  const t = setup.tool;
  const newest = useOutcome((s) => s.newest);
  const [fits, offer] = useState<readonly ToolFit[]>([]);
  const asked =
    (FIXED_BY_TOOL.has(entry.issue.code) && entry.issue.severity !== "info") || UNKNOWN_TOOL.has(entry.issue.code);
  useEffect(() => {
    const operation = asked && entry.operation !== null ? newest?.run.operations[entry.operation] : undefined;
    if (!operation) return undefined;
    return takeAnswer(
      () => fitsOfCall(operation),
      (found) => offer(suitable(found ?? [], entry)),
      CALCULATING.otherTools,
    );
  }, [asked, newest, entry]);
  const handedOn = useEditor((s) => bundleOf(s).tools);
  if (!asked) return NONE;
  const isUnknown = UNKNOWN_TOOL.has(entry.issue.code);
  const taken = (host.isCurrent ? fits : []).map(({ tool }) => ({
    name: isUnknown ? t.takeNamed(tool.T, tool.NAME) : t.take(tool.T),
    apply: () => host.takeTool(entry, tool.T),
  }));
  // A work that carries its own tools does not call those of the table.
  if (entry.issue.code !== "toolUnknown" || handedOn) return taken;
  const { tool } = entry.issue.data;
  return [...taken, { name: findings.createTool(tool), apply: () => createCalledTool(tool) }];
}

/** Whether a run of the changed program lacks a finding, and has no other error. */
async function helps({ work }: Trial, { issue }: FindingEntry, before: readonly FindingEntry[]): Promise<boolean> {
  const made = await work();
  const outcome = made && (await outcomeOfOther(made));
  if (!outcome) return false;
  const after = findingsOf(null, outcome);
  const alike = (entries: readonly FindingEntry[]) => entries.filter((each) => each.issue.code === issue.code).length;
  return alike(after) < alike(before) && after.filter(isError).length < before.filter(isError).length;
}

/** Fixes that a run has shown to help. */
export function useTriedFixes(
  entry: FindingEntry,
  host: FindingsHost,
  before: readonly FindingEntry[],
): readonly Fix[] {
  const [found, offer] = useState<{ readonly of: FindingsHost | null; readonly fixes: readonly Fix[] }>({
    of: null,
    fixes: NONE,
  });
  useEffect(() => {
    const asked = host.trialsOf(entry);
    if (!asked) return undefined;
    return untilGone(async (isGone) => {
      const trials = (await asked) ?? [];
      const worked = new Map<string, Fix>();
      for (const trial of trials) {
        if (worked.has(trial.group)) continue;
        const isRight = await helps(trial, entry, before);
        if (isGone()) return;
        if (isRight) offer({ of: host, fixes: [...worked.set(trial.group, trial).values()] });
      }
    }, CALCULATING.otherTools);
  }, [entry, host, before]);
  return found.of === host ? found.fixes : NONE;
}
