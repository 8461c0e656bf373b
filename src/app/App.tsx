import { lazy, Suspense, useEffect } from "react";
import { Header } from "./Header.tsx";
import { Notices } from "./Notices.tsx";
import { CopyByHand } from "./program/CopyByHand.tsx";
import { useReading } from "./reading.ts";
import { useKeeping } from "./saving/keep.ts";
import { StartPage } from "./start/StartPage.tsx";
import { useToolPlace } from "./tools/tool-place.ts";
import { Workplace } from "./Workplace.tsx";

/** Fetched when it is first shown. */
const ToolPage = lazy(async () => ({ default: (await import("./tools/ToolPage.tsx")).ToolPage }));

/** The page: the top line, and below it the tool table, the choice of a cycle, or the workplace of the open job. */
export function App() {
  const ready = useKeeping((k) => k.ready);
  const read = useReading();
  const tools = useToolPlace((p) => p.shown);
  const name = read?.job.name;
  useEffect(() => {
    document.title = name ? `${name} · Turnwise` : "Turnwise";
  }, [name]);

  return (
    <div className="page">
      <Header />
      <Notices />
      {ready && tools && <Suspense><ToolPage /></Suspense>}
      {ready && !tools && (read ? <Workplace read={read} /> : <StartPage />)}
      <CopyByHand />
    </div>
  );
}
