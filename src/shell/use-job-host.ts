import { useMemo } from "react";
import type { ParamTextId } from "../cycles/index.ts";
import { writer } from "../i18n/write.ts";
import { positionAsTyped } from "../program/values/typed-value.ts";
import { isSetupPlace } from "../app/fields/dialog/setup-prompts.ts";
import { writeTyped } from "../app/fields/dialog/write-value.ts";
import { setPerRevolution, setPrompt } from "../app/document/edits.ts";
import { setPlace, takePlace } from "../app/document/setup-edits.ts";
import { goToField, openPrompt, enterSection } from "../app/place/place.ts";
import type { JobReading } from "../app/document/reading.ts";
import { useSettings } from "../app/base/settings/settings.ts";
import { useTexts } from "../app/base/settings/use-texts.ts";
import { closeStep } from "../app/document/steps.ts";
import { isAboutTool, type FindingEntry } from "../app/findings/entry.ts";
import { nearestOf, type FindingsHost, type Fix, type Target } from "../app/findings/host.ts";

/** Decimals of a start point. */
const START_DECIMALS = 3;

/** A change by a button is its own step of undo. */
const oneStep = (change: () => void) => () => {
  closeStep();
  change();
  closeStep();
};

/** The workplace of one cycle: prompts, set-up and contour table. */
export function useJobHost(read: JobReading): FindingsHost {
  const t = useTexts();
  const language = useSettings((s) => s.language);
  return useMemo(() => {
    const { places } = t.findings;
    const { job, cycle, draft } = read;
    const goTo = (q: string | null) => openPrompt(q, q === null ? "" : (draft[q] ?? ""));
    const targetOf = ({ issue, at, block }: FindingEntry): Target | null => {
      const param = at === null ? undefined : cycle.params[at];
      if (at !== null && param)
        return { name: t.dialog.value(at, t.params[param.text as ParamTextId].label), go: () => goTo(at) };
      if (issue.code === "blankAgainstContour" && at !== null)
        return { name: places.blank, go: () => openPrompt(at, "") };
      if (at === "start.x") return { name: places.startX, go: () => goToField("setup", "start.x") };
      if (at === "start.z") return { name: places.startZ, go: () => goToField("setup", "start.z") };
      if (at === "contour") return { name: places.contour, go: () => enterSection("contour") };
      if (issue.code === "blankMissing" || issue.code === "blankImpossible")
        return {
          name: places.blank,
          go: () => goToField("setup", "blank.outside"),
        };
      if (issue.code === "spindleMissing" || (issue.code === "spindleStopped" && issue.data.how === "noSpeed"))
        return {
          name: places.spindle,
          go: () => goToField("setup", job.spindle.mode === "constant" ? "spindle.speed" : "spindle.cuttingSpeed"),
        };
      if (isAboutTool(at) || issue.code === "toolUnknown")
        return { name: places.tool, go: () => goToField("setup", "tool") };
      return block === null ? null : { name: t.findings.inBlock(String(block)), go: () => enterSection("program") };
    };
    const fixesOf = (entry: FindingEntry): readonly Fix[] => {
      const { issue, at } = entry;
      if (issue.code === "betterTool")
        return [
          {
            name: t.setup.tool.take(issue.data.tool),
            apply: () => takePlace("tool", String(issue.data.tool)),
          },
        ];
      if (issue.code === "feedUnlikely" && issue.data.unit === "mm/min")
        return [{ name: t.dialog.takeNearest("M136"), apply: oneStep(() => setPerRevolution(true)) }];
      if (issue.code === "startOnWrongSide") {
        const start = () => {
          setPlace("start.x", positionAsTyped(issue.data.x));
          setPlace("start.z", positionAsTyped(issue.data.z));
        };
        return [
          { name: t.dialog.takeNearest(writer(language).place(issue.data.x, issue.data.z)), apply: oneStep(start) },
        ];
      }
      if (issue.code === "endsExchanged" && at !== null) {
        const { start, end, other } = issue.data;
        const exchange = () => {
          setPrompt(at, String(end));
          setPrompt(other, String(start));
        };
        const both = [
          [at, end],
          [other, start],
        ] as const;
        const name = both.map(([q, value]) => `${q} ${writeTyped(language, value, START_DECIMALS)}`).join(", ");
        return [{ name: t.dialog.takeNearest(name), apply: oneStep(exchange) }];
      }
      const nearest = nearestOf(entry);
      const param = at === null ? undefined : cycle.params[at];
      if (nearest !== null && at !== null && issue.code === "blankAgainstContour" && isSetupPlace(at))
        return [
          {
            name: t.dialog.takeNearest(writeTyped(language, nearest, START_DECIMALS)),
            apply: () => takePlace(at, String(nearest)),
          },
        ];
      if (nearest === null || at === null) return [];
      const take = (decimals: number, apply: () => void): readonly Fix[] => [
        {
          name: t.dialog.takeNearest(writeTyped(language, nearest, decimals)),
          apply: oneStep(apply),
        },
      ];
      if (param) return take(param.decimals, () => setPrompt(at, String(nearest)));
      if (at === "start.x" || at === "start.z") return take(START_DECIMALS, () => setPlace(at, String(nearest)));
      return [];
    };
    const toFirstOpen = () => goTo(read.reading.issues[0]?.at ?? null);
    const takeTool: FindingsHost["takeTool"] = (_, tool) => takePlace("tool", String(tool));
    return {
      targetOf,
      fixesOf,
      // The stock of a job is no part that a trial could spare.
      trialsOf: () => null,
      improve: null,
      cycleOf: () => job.cycle,
      point: () => undefined,
      toFirstOpen,
      isCurrent: true,
      takeTool,
    };
  }, [t, language, read]);
}
