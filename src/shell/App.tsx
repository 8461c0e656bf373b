import { Suspense, useEffect, type ComponentType } from "react";
import { LongWait } from "../app/calculation/LongWait.tsx";
import { menuCycle } from "../app/fields/chooser/menu.ts";
import { Header } from "./Header.tsx";
import { useDrawingRequest } from "../app/document/drawing-request.ts";
import { useProgramChoice } from "../app/document/program-choice.ts";
import { MissingPart } from "../app/base/MissingPart.tsx";
import { ChangedElsewhere } from "./ChangedElsewhere.tsx";
import { useTitle } from "./use-title.ts";
import { Notices } from "./Notices.tsx";
import { useVersion } from "../app/base/version.ts";
import { lazyPart, lazyWithin } from "../app/base/parts.ts";
import { useCopying } from "../app/findings/copy.ts";
import { prefetchIdle } from "../app/base/idle.ts";
import { useSavedWorks } from "../app/records/keep.ts";
import type { PartName } from "../i18n/parts.ts";
import { fetchShownTexts, useTexts } from "../app/base/settings/use-texts.ts";
import { useEditor } from "../app/document/store.ts";
import { closeOver, workElsewhere, isCover, shownPage, usePlace, type Page } from "../app/place/place.ts";
import { usePendingRestore } from "../app/records/pending-restore.ts";
import { fetchCompareDialog } from "../features/compare/index.ts";
import { IncomingTaught, TaskLine } from "../features/course/first.ts";
import { fetchCourseEntrance, fetchCoursePage } from "../features/course/index.ts";
import { fetchDrawingDialog } from "../features/drawing/index.ts";
import { fetchProgramWorkplace } from "../features/editor/index.ts";
import { DropProgram } from "../features/files/first.ts";
import { fetchChooseProgram } from "../features/files/index.ts";
import { fetchGuidePage } from "../features/guide/index.ts";
import { HandedLine, IncomingWork } from "../features/share/first.ts";
import { fetchUpdateBar } from "../features/offline/index.ts";
import { fetchOwnPage } from "../features/own/index.ts";
import { fetchPlanPage } from "../features/plan/index.ts";
import { fetchSheetPage } from "../features/sheet/index.ts";
import { StartPage } from "../features/start/first.ts";
import { fetchToolPage } from "../features/tools/index.ts";
import { fetchWhichCycle } from "../features/which/index.ts";
import { fetchDiedPage, fetchRestoreDialog, fetchOtherTabPage, fetchWorksPage } from "../features/works/index.ts";

/** Fetches a part together with the texts that it needs. */
const withTexts =
  <M,>(fetch: () => Promise<M>, ...further: readonly PartName[]) =>
  async (): Promise<M> =>
    (await Promise.all([fetch(), fetchShownTexts(...further)]))[0];
const fetchWorkplace = withTexts(() => import("./Workplace.tsx"));
const Workplace = lazyWithin(async () => ({ default: (await fetchWorkplace()).Workplace }));
const CopyByHand = lazyPart(async () => ({
  default: (await import("../app/fields/program/CopyByHand.tsx")).CopyByHand,
}));
// With all its texts: what came later would push the form and the table away.
const fetchTools = withTexts(fetchToolPage, "tables", "tool-files", "tool-sheets", "tool-codes");
const ToolPage = lazyPart(async () => ({ default: (await fetchTools()).ToolPage }));
const fetchOwn = withTexts(fetchOwnPage);
const OwnPage = lazyPart(async () => ({ default: (await fetchOwn()).OwnPage }));
const WorksPage = lazyPart(async () => ({ default: (await fetchWorksPage()).WorksPage }));
const BringInDialog = lazyPart(async () => ({ default: (await fetchRestoreDialog()).RestoreDialog }));
const CourseEntrance = lazyWithin(async () => ({ default: (await fetchCourseEntrance()).CourseEntrance }));
const fetchCourse = withTexts(fetchCoursePage);
const CoursePage = lazyPart(async () => ({ default: (await fetchCourse()).CoursePage }));
const ElsewherePage = lazyWithin(async () => ({ default: (await fetchOtherTabPage()).OtherTabPage }));
const DiedPage = lazyWithin(async () => ({ default: (await fetchDiedPage()).DiedPage }));
/** Fetched with their texts when somebody asks. */
const ChooseProgram = lazyPart(async () => ({ default: (await fetchChooseProgram()).ChooseProgram }));
const fetchDrawing = withTexts(fetchDrawingDialog);
const DrawingDialog = lazyPart(async () => ({ default: (await fetchDrawing()).DrawingDialog }));
const NumberKeys = lazyPart(async () => ({
  default: (await import("../app/fields/keypad/NumberKeys.tsx")).NumberKeys,
}));
const KeySheet = lazyWithin(async () => ({ default: (await import("../app/fields/keys/KeySheet.tsx")).KeySheet }));
const WorkDialog = lazyWithin(
  withTexts(async () => ({ default: (await import("../app/fields/program/WorkDialog.tsx")).WorkDialog })),
);
const fetchCommands = () => import("./commands/CommandDialog.tsx");
const CommandDialog = lazyWithin(async () => ({ default: (await fetchCommands()).CommandDialog }));
const CompareDialog = lazyWithin(async () => ({ default: (await fetchCompareDialog()).CompareDialog }));
const WhichCycle = lazyWithin(async () => ({ default: (await fetchWhichCycle()).WhichCycle }));
const fetchSheet = withTexts(fetchSheetPage);
const SheetPage = lazyPart(async () => ({ default: (await fetchSheet()).SheetPage }));
const fetchPlan = withTexts(fetchPlanPage);
const PlanPage = lazyPart(async () => ({ default: (await fetchPlan()).PlanPage }));
const fetchGuide = withTexts(fetchGuidePage);
const GuidePage = lazyPart(async () => ({ default: (await fetchGuide()).GuidePage }));
const fetchEditor = withTexts(fetchProgramWorkplace);
const ProgramWorkplace = lazyWithin(async () => ({ default: (await fetchEditor()).ProgramWorkplace }));

/** Fetched when there is something to say. */
const UpdateBar = lazyPart(async () => ({ default: (await fetchUpdateBar()).UpdateBar }));

const Start = () => <StartPage course={<CourseEntrance />} />;

/** The workplace of the open job or program; nothing for a job with a cycle that this edition lacks. */
function OpenWork() {
  const t = useTexts("first").page;
  const hasJob = useEditor((s) => s.job !== null && menuCycle(s.job.cycle) !== undefined);
  const program = useEditor((s) => (s.program ? s.work : null));
  if (program === null) return hasJob ? <Workplace /> : <Start />;
  return (
    <Suspense
      fallback={
        <p className="editor-loading soft" role="status">
          {t.loading}
        </p>
      }
    >
      <ProgramWorkplace key={program} />
    </Suspense>
  );
}

function Elsewhere() {
  const of = usePlace(workElsewhere);
  return of && (of.cause === "died" ? <DiedPage of={of} /> : <ElsewherePage of={of} />);
}

const PAGES: Readonly<Record<Page["page"], ComponentType>> = {
  start: Start,
  works: WorksPage,
  course: CoursePage,
  work: OpenWork,
  elsewhere: Elsewhere,
  sheet: SheetPage,
  plan: PlanPage,
  tools: ToolPage,
  own: OwnPage,
  guide: GuidePage,
};

/** Thousands of programs of an earlier version are read one by one, once. */
const ReadingDevice = () => <LongWait className="editor-loading soft">{useTexts("first").page.readingDevice}</LongWait>;

/** The page: the header, the page on top, and dialogs. */
export function App() {
  const ready = useSavedWorks((k) => k.ready);
  const page = usePlace((p) => shownPage(p).page);
  const over = usePlace((p) => p.over);
  const bringing = usePendingRestore((b) => b.shown);
  const { choice } = useProgramChoice();
  const drawing = useDrawingRequest((d) => d.request);
  const refused = useCopying((c) => c.state === "refused");
  const newer = useVersion((v) => v.newer !== "none" && !v.later);
  const Seen = PAGES[page];
  useTitle();

  useEffect(() => prefetchIdle(fetchWorkplace), []);
  // What is typed right after its shortcut must not go elsewhere.
  useEffect(() => prefetchIdle(fetchCommands), []);

  return (
    <div className="page">
      <Header />
      <Notices />
      <ChangedElsewhere />
      <div className="notices" role="status">
        <MissingPart />
        {newer && <UpdateBar />}
      </div>
      <HandedLine />
      {!ready && <ReadingDevice />}
      {ready && !isCover({ page }) && <TaskLine />}
      {ready && (
        <Suspense>
          <Seen />
        </Suspense>
      )}
      {ready && over && (
        <Suspense>
          {over.dialog === "which" && <WhichCycle done={closeOver} region={over.region} />}
          {over.dialog === "comparison" && (
            <CompareDialog done={closeOver} showBlock={over.showBlock} against={over.against} />
          )}
          {(over.dialog === "drawing" || over.dialog === "share") && <WorkDialog of={over.dialog} done={closeOver} />}
          {over.dialog === "commands" && <CommandDialog done={closeOver} />}
          {over.dialog === "keys" && <KeySheet done={closeOver} place={over.place} />}
        </Suspense>
      )}
      <IncomingWork />
      <IncomingTaught />
      {ready && bringing && <BringInDialog of={bringing} />}
      {choice && <ChooseProgram {...choice} />}
      {drawing && <DrawingDialog request={drawing} />}
      <DropProgram />
      <NumberKeys />
      {refused && <CopyByHand />}
    </div>
  );
}
