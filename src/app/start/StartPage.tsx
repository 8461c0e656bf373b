import { useEffect, useRef } from "react";
import { CycleChooser } from "../chooser/CycleChooser.tsx";
import { fetchAtRest } from "../rest.ts";
import { refreshWorks } from "../saving/keep.ts";
import { useFirstTexts } from "../settings/use-first-texts.ts";
import { WhichButton } from "../which/WhichButton.tsx";
import { KeptWorks } from "./KeptWorks.tsx";
import { ProgramStart } from "./ProgramStart.tsx";

/** Needs the catalogue, which is fetched while the operator looks. */
const fetchBegin = () => import("./begin.ts");

/** The first screen: which cycle, or which earlier work. */
export function StartPage() {
  const t = useFirstTexts();
  const going = useRef(false);
  useEffect(() => {
    void refreshWorks();
  }, []);
  useEffect(() => fetchAtRest(fetchBegin), []);

  /** Pressed twice while the catalogue is on its way, it still begins one work. */
  const start = async (cycle: number, withExample: boolean) => {
    if (going.current) return;
    going.current = true;
    try {
      (await fetchBegin()).beginCycle(cycle, withExample);
    } finally {
      going.current = false;
    }
  };
  const { start: words } = t.page;
  return (
    <main className="start-page">
      <div className="start-lead">
        <h1>{words.title}</h1>
        <p className="soft">{words.lead}</p>
        <WhichButton className="button start-which" name={words.which} />
      </div>
      <CycleChooser ways={[{ name: words.withExample, short: words.withExample, go: (cycle) => void start(cycle, true) }, {
        name: words.empty,
        short: t.chooser.empty,
        go: (cycle) => void start(cycle, false),
      }]} />
      <ProgramStart />
      <KeptWorks />
      <p className="small">
        <a href="gallery.html">{t.page.gallery}</a>
      </p>
      <p className="small soft disclaimer">{t.page.disclaimer}</p>
    </main>
  );
}
