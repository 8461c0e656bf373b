import { Suspense, useEffect } from "react";
import { menuCycle } from "../fields/chooser/menu.ts";
import { useGuidePlace } from "../place/guide-place.ts";
import { Header } from "./Header.tsx";
import { useCoursePlace } from "../place/course-place.ts";
import { useChoice } from "../document/choice.ts";
import { DropProgram } from "../../features/files/DropProgram.tsx";
import { NumberKeys } from "../fields/keypad/NumberKeys.tsx";
import { IncomingTaught } from "../../features/course/teach/IncomingTaught.tsx";
import { HandedLine, IncomingWork } from "../../features/handing/HandedParts.tsx";
import { MissingPart } from "../base/MissingPart.tsx";
import { Notices } from "./Notices.tsx";
import { useVersion } from "../base/version.ts";
import { useOwnPlace } from "../document/own-place.ts";
import { lazyPart } from "../base/parts.ts";
import { TaskLine } from "../../features/course/task/TaskLine.tsx";
import { useCopying } from "../findings/copy.ts";
import { fetchAtRest } from "../base/rest.ts";
import { useElsewhere } from "../place/elsewhere.ts";
import { useKeeping } from "../records/keep.ts";
import { fetchShownTexts, useTexts } from "../base/settings/use-texts.ts";
import { useSheetShown } from "../document/sheet-place.ts";
import { StartPage } from "../../features/start/StartPage.tsx";
import { useEditor } from "../document/store.ts";
import { useToolPlace } from "../document/tool-place.ts";
import { hideComparison, useComparing } from "../place/compare-place.ts";
import { hideWhich, useWhichPlace } from "../document/which-place.ts";
import { useBringing } from "../records/bring-in-place.ts";
import { useWorksPlace } from "../place/works-place.ts";

/** Parts that are fetched when they are first shown, together with the texts that they need. */
const later = <M,>(fetch: () => Promise<M>) => async (): Promise<M> => (await Promise.all([fetch(), fetchShownTexts()]))[0];
const fetchWorkplace = later(() => import("./Workplace.tsx"));
const Workplace = lazyPart(async () => ({ default: (await fetchWorkplace()).Workplace }));
const CopyByHand = lazyPart(async () => ({ default: (await import("../fields/program/CopyByHand.tsx")).CopyByHand }));
const fetchTools = later(() => import("../../features/tools/ToolPage.tsx"));
const ToolPage = lazyPart(async () => ({ default: (await fetchTools()).ToolPage }));
const fetchOwn = later(() => import("../../features/own/OwnPage.tsx"));
const OwnPage = lazyPart(async () => ({ default: (await fetchOwn()).OwnPage }));
const WorksPage = lazyPart(async () => ({ default: (await import("../../features/works/WorksPage.tsx")).WorksPage }));
const BringInDialog = lazyPart(async () => ({ default: (await import("../../features/works/BringInDialog.tsx")).BringInDialog }));
const CourseEntrance = lazyPart(async () => ({ default: (await import("../../features/course/CourseEntrance.tsx")).CourseEntrance }));
const fetchCourse = later(() => import("../../features/course/CoursePage.tsx"));
const CoursePage = lazyPart(async () => ({ default: (await fetchCourse()).CoursePage }));
const ElsewherePage = lazyPart(async () => ({ default: (await import("../../features/works/ElsewherePage.tsx")).ElsewherePage }));
/** Fetched with their texts when somebody asks. */
const ChooseProgram = lazyPart(async () => ({ default: (await import("../../features/files/ChooseProgram.tsx")).ChooseProgram }));
const CompareDialog = lazyPart(async () => ({ default: (await import("../../features/compare/CompareDialog.tsx")).CompareDialog }));
const WhichCycle = lazyPart(async () => ({ default: (await import("../../features/which/WhichCycle.tsx")).WhichCycle }));
const fetchSheet = later(() => import("../../features/sheet/SheetPage.tsx"));
const SheetPage = lazyPart(async () => ({ default: (await fetchSheet()).SheetPage }));
const fetchGuide = later(() => import("../../features/guide/GuidePage.tsx"));
const GuidePage = lazyPart(async () => ({ default: (await fetchGuide()).GuidePage }));
const fetchEditor = later(() => import("./ProgramWorkplace.tsx"));
const ProgramWorkplace = lazyPart(async () => ({ default: (await fetchEditor()).ProgramWorkplace }));

/** Fetched when there is something to say. */
const UpdateBar = lazyPart(async () => ({ default: (await import("../../features/offline/UpdateBar.tsx")).UpdateBar }));

/** What stands where no work is open: the start page, all works, the course, or why the work that was asked for is not open here. */
function Entrance() {
  const works = useWorksPlace((p) => p.shown);
  const course = useCoursePlace((p) => p.shown);
  const elsewhere = useElsewhere((e) => e.shown);
  if (elsewhere) {
    return (
      <Suspense>
        <ElsewherePage of={elsewhere} />
      </Suspense>
    );
  }
  if (!works && !course) return <StartPage course={<CourseEntrance />} />;
  return <Suspense>{course ? <CoursePage /> : <WorksPage />}</Suspense>;
}

/** The page: the top line, and below it the tool table, the choice of work, or the workplace of the open job or program. */
export function App() {
  const ready = useKeeping((k) => k.ready);
  const job = useEditor((s) => (s.job && menuCycle(s.job.cycle) ? s.job : null));
  const tools = useToolPlace((p) => p.shown);
  const own = useOwnPlace((p) => p.shown);
  const program = useEditor((s) => (s.program ? s.work : null));
  const programName = useEditor((s) => s.program?.name);
  const bringing = useBringing((b) => b.shown);
  const which = useWhichPlace();
  const { showBlock, against } = useComparing();
  const { choice } = useChoice();
  const refused = useCopying((c) => c.state === "refused");
  const t = useTexts("first").page;
  const sheet = useSheetShown();
  const guide = useGuidePlace((p) => p.path !== null);
  const newer = useVersion((v) => v.newer !== "none" && !v.later);
  const course = useCoursePlace((p) => (p.shown ? p.title : ""));
  const name = job?.name ?? programName ?? course;
  useEffect(() => {
    document.title = name ? `${name} · Turnwise` : "Turnwise";
  }, [name]);

  useEffect(() => fetchAtRest(fetchWorkplace), []);

  return (
    <div className="page">
      <Header />
      <Notices />
      <div className="notices" role="status">
        <MissingPart />
        {newer && (
          <Suspense>
            <UpdateBar />
          </Suspense>
        )}
      </div>
      <HandedLine />
      {ready && !guide && !tools && !own && !sheet && <TaskLine />}
      {ready && guide && (
        <Suspense>
          <GuidePage />
        </Suspense>
      )}
      {ready && !guide && tools && !own && (
        <Suspense>
          <ToolPage />
        </Suspense>
      )}
      {ready && !guide && own && (
        <Suspense>
          <OwnPage />
        </Suspense>
      )}
      {ready && !guide && !tools && !own && sheet && (
        <Suspense>
          <SheetPage />
        </Suspense>
      )}
      {ready && !guide && !tools && !own && !sheet && program !== null && (
        <Suspense fallback={<p className="editor-loading soft" role="status">{t.loading}</p>}>
          <ProgramWorkplace key={program} />
        </Suspense>
      )}
      {ready && !guide && !tools && !own && !sheet && program === null && (job
        ? (
          <Suspense>
            <Workplace />
          </Suspense>
        )
        : <Entrance />)}
      {ready && showBlock && (
        <Suspense>
          <CompareDialog done={hideComparison} showBlock={showBlock} against={against} />
        </Suspense>
      )}
      {ready && which.shown && (
        <Suspense>
          <WhichCycle done={hideWhich} region={which.region} />
        </Suspense>
      )}
      <IncomingWork />
      <IncomingTaught />
      {ready && bringing && (
        <Suspense>
          <BringInDialog of={bringing} />
        </Suspense>
      )}
      {choice && (
        <Suspense>
          <ChooseProgram {...choice} />
        </Suspense>
      )}
      <DropProgram />
      <NumberKeys />
      {refused && (
        <Suspense>
          <CopyByHand />
        </Suspense>
      )}
    </div>
  );
}
