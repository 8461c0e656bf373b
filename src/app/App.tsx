import { lazy, Suspense, useEffect } from "react";
import { Header } from "./Header.tsx";
import { DropProgram } from "./files/DropProgram.tsx";
import { Notices } from "./Notices.tsx";
import { useCopying } from "./program/copy.ts";
import { useReading } from "./reading.ts";
import { useKeeping } from "./saving/keep.ts";
import { useTexts } from "./settings/use-texts.ts";
import { StartPage } from "./start/StartPage.tsx";
import { useEditor } from "./store.ts";
import { useToolPlace } from "./tools/tool-place.ts";

/** Fetched when they are first shown; the workplace as soon as a hand moves, before a cycle is chosen. */
const fetchWorkplace = async () => ({ default: (await import("./Workplace.tsx")).Workplace });
const Workplace = lazy(fetchWorkplace);
const CopyByHand = lazy(async () => ({ default: (await import("./program/CopyByHand.tsx")).CopyByHand }));
const ToolPage = lazy(async () => ({ default: (await import("./tools/ToolPage.tsx")).ToolPage }));
const ProgramWorkplace = lazy(async () => ({ default: (await import("./editor/ProgramWorkplace.tsx")).ProgramWorkplace }));

/** The page: the top line, and below it the tool table, the choice of work, or the workplace of the open job or program. */
export function App() {
  const ready = useKeeping((k) => k.ready);
  const read = useReading();
  const tools = useToolPlace((p) => p.shown);
  const program = useEditor((s) => (s.program ? s.work : null));
  const programName = useEditor((s) => s.program?.name);
  const refused = useCopying((c) => c.state === "refused");
  const t = useTexts().editor;
  const name = read?.job.name ?? programName;
  useEffect(() => {
    document.title = name ? `${name} · Turnwise` : "Turnwise";
  }, [name]);

  useEffect(() => {
    const begins = ["pointermove", "pointerdown", "keydown"];
    const fetchNow = () => {
      for (const sign of begins) removeEventListener(sign, fetchNow);
      void fetchWorkplace().catch(() => undefined);
    };
    for (const sign of begins) addEventListener(sign, fetchNow, { passive: true });
    return () => begins.forEach((sign) => removeEventListener(sign, fetchNow));
  }, []);

  return (
    <div className="page">
      <Header />
      <Notices />
      {ready && tools && (
        <Suspense>
          <ToolPage />
        </Suspense>
      )}
      {ready && !tools && program !== null && (
        <Suspense fallback={<p className="editor-loading soft" role="status">{t.loading}</p>}>
          <ProgramWorkplace key={program} />
        </Suspense>
      )}
      {ready && !tools && program === null && (read
        ? (
          <Suspense>
            <Workplace read={read} />
          </Suspense>
        )
        : <StartPage />)}
      <DropProgram />
      {refused && (
        <Suspense>
          <CopyByHand />
        </Suspense>
      )}
    </div>
  );
}
