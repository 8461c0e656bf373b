import { useEffect } from "react";
import { Header } from "./Header.tsx";
import { Notices } from "./Notices.tsx";
import { CopyByHand } from "./program/CopyByHand.tsx";
import { useReading } from "./reading.ts";
import { useKeeping } from "./saving/keep.ts";
import { StartPage } from "./start/StartPage.tsx";
import { Workplace } from "./Workplace.tsx";

/** The page: the top line, and below it either the choice of a cycle or the workplace of the open job. */
export function App() {
  const ready = useKeeping((k) => k.ready);
  const read = useReading();
  const name = read?.job.name;
  useEffect(() => {
    document.title = name ? `${name} · Turnwise` : "Turnwise";
  }, [name]);

  return (
    <div className="page">
      <Header />
      <Notices />
      {ready && (read ? <Workplace read={read} /> : <StartPage />)}
      <CopyByHand />
    </div>
  );
}
