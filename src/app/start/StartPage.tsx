import { lazy, Suspense, useEffect } from "react";
import { catalogue, type CycleNumber } from "../../cycles/index.ts";
import { exampleJob } from "../../program/job.ts";
import type { Cycle } from "../../cycles/define.ts";
import { draftOf } from "../edits.ts";
import { openPrompt } from "../place.ts";
import { refreshWorks, startWork } from "../saving/keep.ts";
import { useTexts } from "../settings/use-texts.ts";
import { useSettings } from "../settings/settings.ts";
import { KeptWorks } from "./KeptWorks.tsx";
import { ProgramStart } from "./ProgramStart.tsx";

/** The cards can be used before their drawings are there; the room is kept for them. */
const CycleSketch = lazy(async () => ({ default: (await import("./CycleSketch.tsx")).CycleSketch }));

/** Begins a program of a cycle, with the printed example's values or with empty prompts. */
function begin(cycle: Cycle, withExample: boolean, language: "en" | "de" | "fr" | "zh"): void {
  const example = { ...exampleJob(cycle), ncLanguage: language };
  const job = withExample ? example : { ...example, drafts: {}, contour: [] };
  startWork(job);
  const first = Object.keys(cycle.params)[0] ?? null;
  openPrompt(first, first === null ? "" : (draftOf(job)[first] ?? ""));
}

/** The first screen: which cycle, or which earlier work. */
export function StartPage() {
  const t = useTexts();
  const language = useSettings((s) => s.language);
  useEffect(() => {
    void refreshWorks();
  }, []);

  return (
    <main className="start-page">
      <div className="start-lead">
        <h1>{t.page.start.title}</h1>
        <p className="soft">{t.page.start.lead}</p>
      </div>
      <ul className="cycle-cards">
        {catalogue.map((cycle) => {
          const words = t.cycles.of[cycle.number as CycleNumber];
          return (
            <li key={cycle.number} className="cycle-card" aria-label={t.page.start.cycle(cycle.number, words.name)}>
              <Suspense fallback={<div className="cycle-sketch" />}>
                <CycleSketch cycle={cycle} />
              </Suspense>
              <h2>
                <span className="number card-number">{cycle.number}</span> {words.name}
              </h2>
              <p className="soft small card-group">{t.cycles.groups[cycle.group]}</p>
              <p className="card-summary">{words.summary}</p>
              {cycle.evidence !== "A" && <p className="small evidence-text">{t.page.start.unconfirmed}</p>}
              <div className="card-buttons">
                <button type="button" className="button primary" onClick={() => begin(cycle, true, language)}
                  aria-label={`${t.page.start.cycle(cycle.number, words.name)}: ${t.page.start.withExample}`}
                >
                  {t.page.start.withExample}
                </button>
                <button type="button" className="button" onClick={() => begin(cycle, false, language)}
                  aria-label={`${t.page.start.cycle(cycle.number, words.name)}: ${t.page.start.empty}`}
                >
                  {t.page.start.empty}
                </button>
              </div>
            </li>
          );
        })}
      </ul>
      <ProgramStart />
      <KeptWorks />
      <p className="small soft disclaimer">{t.page.disclaimer}</p>
    </main>
  );
}
