import { Suspense, useEffect, useMemo, useState, type ReactNode } from "react";
import { partialWork } from "../program/job/partial-work.ts";
import { sameRings } from "../sim/same-step.ts";
import { clock } from "../app/base/clock.ts";
import { chooseElement, useContourPlace } from "../app/place/contour-place.ts";
import { BackToPrompts } from "../app/fields/dialog/BackToPrompts.tsx";
import { CycleDialog } from "../app/fields/dialog/CycleDialog.tsx";
import { setContour, setPrompt } from "../app/document/edits.ts";
import { CycleStrip } from "../app/findings/effect/CycleStrip.tsx";
import { cycleGivens } from "../app/calculation/cycle-givens.ts";
import { useOutcome } from "../app/calculation/outcome.ts";
import { ContourViews } from "./ContourViews.tsx";
import { useJobHost } from "./use-job-host.ts";
import { Icon } from "../app/base/Icon.tsx";
import { CycleInWork } from "../app/calculation/issue-text.ts";
import { LatheView } from "../app/pictures/lathe/LatheView.tsx";
import { MeasuredTargetContext } from "../app/document/measured-target-context.ts";
import { useMeasuredTarget } from "../app/document/measured-target.ts";
import { DeferredUntilPaint, useDeferredUntilPaint } from "../app/base/typing.ts";
import { lazyPart, lazyWithin } from "../app/base/parts.ts";
import { showSection, usePlace, type JobSection } from "../app/place/place.ts";
import { playback } from "../app/calculation/playback.ts";
import { openAsked } from "../app/fields/program/choose-line.ts";
import { useTextBar } from "../app/fields/find/text-bar.ts";
import { ProgramPanel } from "../app/fields/program/ProgramPanel.tsx";
import { useReading, type JobReading } from "../app/document/reading.ts";
import { prefetchIdle } from "../app/base/idle.ts";
import { WorkColumns } from "../app/fields/workplace/WorkColumns.tsx";
import { changeSettings, useSettings } from "../app/base/settings/settings.ts";
import { useTexts } from "../app/base/settings/use-texts.ts";
import { useThirdColumn } from "../app/base/use-media.ts";
import { useToolList } from "../app/document/work-tools.ts";
import { fetchContourStage, fetchContourTable } from "../features/contour/index.ts";

/** Loaded when its section is first shown, or earlier when the browser is idle. */
const fetchSetup = () => import("../app/fields/setup/SetupPanel.tsx");
const SetupPanel = lazyPart(async () => ({ default: (await fetchSetup()).SetupPanel }));
const fetchFindings = () => import("../app/findings/FindingsPanel.tsx");
const FindingsPanel = lazyPart(async () => ({ default: (await fetchFindings()).FindingsPanel }));
const ContourTable = lazyWithin(async () => ({ default: (await fetchContourTable()).ContourTable }));
const ContourStage = lazyPart(async () => ({ default: (await fetchContourStage()).ContourStage }));

const VIEWS = <ContourViews />;

/** Prompts, lathe and program of the open job. */
export function Workplace() {
  const read = useReading();
  return read && <JobWorkplace read={read} />;
}

function JobWorkplace({ read }: { readonly read: JobReading }) {
  const {
    page: t,
    findings: { title: findingsTitle },
  } = useTexts();
  const language = useSettings((s) => s.language);
  const wide = useThirdColumn();
  const folded = useSettings((s) => s.programFolded);
  const asked = usePlace((p) => p.section);
  const shown = useOutcome((s) => s.pictured);
  const dimmed = useOutcome((s) => s.dimmed);
  const view = useContourPlace((p) => p.view);
  const host = useJobHost(read);
  const tools = useToolList();
  // Drawings without a path update a moment after the key, so that they do not delay the path.
  const late = useDeferredUntilPaint(read);
  const known = useMemo(() => partialWork(late.cycle, late.job, late.reading, cycleGivens(late), tools), [late, tools]);
  // An equal blank stays the same object: drawings of it are cached.
  const [blank, keepBlank] = useState(known.blank);
  if (!sameRings(blank, known.blank)) keepBlank(known.blank);
  const measured = useMeasuredTarget(read, setPrompt);
  useEffect(() => () => chooseElement(null), []);
  useEffect(() => prefetchIdle(() => Promise.all([fetchSetup(), fetchFindings()])), []);
  const bar = useTextBar({
    modes: ["find"],
    show: () => (wide ? changeSettings({ programFolded: false }) : showSection("program")),
  });
  const free = read.cycle.contour === "free";
  const possible: readonly JobSection[] = [
    "prompts",
    "setup",
    ...(free ? ["contour" as const] : []),
    "findings",
    ...(wide ? [] : ["program" as const]),
  ];
  const open = possible.find((section) => section === asked) ?? "prompts";
  const drawing = open === "contour" && view === "draw";

  const content: Readonly<Record<JobSection, ReactNode>> = {
    prompts: <CycleDialog read={read} />,
    setup: <SetupPanel read={read} />,
    contour: (
      <Suspense>
        <BackToPrompts read={read} />
        <ContourTable rows={read.job.contour} onChange={setContour} language={language} isDrawingElsewhere />
      </Suspense>
    ),
    findings: <FindingsPanel host={host} />,
    program: <ProgramPanel read={read} foldable={false} bar={bar} />,
  };

  const text = folded ? (
    <button
      type="button"
      className="button plain unfold"
      aria-label={t.text.unfold}
      title={t.text.unfold}
      onClick={() => changeSettings({ programFolded: false })}
    >
      <Icon name="unfold" /> <span>{t.program}</span>
    </button>
  ) : (
    <ProgramPanel read={read} foldable bar={bar} />
  );

  return (
    <WorkColumns
      of="cycle"
      host={host}
      name={t.sections}
      open={open}
      sections={possible.map((section) => ({
        section,
        name: section === "findings" ? findingsTitle : t[section],
        content: content[section],
        stays: section === "prompts",
      }))}
      strip={
        <DeferredUntilPaint>
          <CycleStrip read={read} />
        </DeferredUntilPaint>
      }
      picture={
        drawing ? (
          <ContourStage rows={read.job.contour} blank={blank} language={language} onChange={setContour} lead={VIEWS} />
        ) : (
          <div className="lathe-column">
            {open === "contour" && (
              <div className="contour-bar">
                <ContourViews />
              </div>
            )}
            <CycleInWork value={read.cycle.number}>
              <MeasuredTargetContext value={measured}>
                <LatheView
                  result={shown}
                  known={known}
                  dimmed={dimmed}
                  playback={playback}
                  clock={clock}
                  onMove={(step, byKey) => openAsked(read, step, byKey)}
                />
              </MeasuredTargetContext>
            </CycleInWork>
          </div>
        )
      }
      isDrawing={drawing}
      text={wide ? text : null}
      isFolded={folded}
    />
  );
}
