import { Suspense, useEffect, useRef, useState, type ReactNode } from "react";
import type { ExampleId } from "../../examples/index.ts";
import { CycleChooser, type OtherRows } from "../../app/fields/chooser/CycleChooser.tsx";
import { useRecent } from "../../app/fields/chooser/recent.ts";
import { lazyPart } from "../../app/base/parts.ts";
import { prefetchIdle } from "../../app/base/idle.ts";
import { refreshWorks, useSavedWorks } from "../../app/records/keep.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { findOtherResults } from "./other-results.ts";
import { SavedPrograms, openSaved } from "../../app/fields/kept/SavedPrograms.tsx";
import { openExample, ProgramStart } from "./ProgramStart.tsx";
import { usePictures } from "./use-pictures.ts";

/** Loaded after the rest, into reserved space. */
const Welcome = lazyPart(async () => ({ default: (await import("./Welcome.tsx")).Welcome }));

/** Needs the catalogue, which is loaded in the background. */
const fetchBegin = () => import("./begin.ts");

/** Typing anywhere on the first screen goes to its search. */
function typeIntoSearch(page: HTMLElement, event: KeyboardEvent): void {
  const { key, target } = event;
  const isTyped = key.length === 1 && key !== " " && key !== "?" && !event.ctrlKey && !event.metaKey && !event.altKey;
  if (!isTyped || document.querySelector("dialog[open]") || (target as HTMLElement).closest("input, select, textarea"))
    return;
  page.querySelector<HTMLInputElement>("input[type=search]")?.focus();
}

/** Stored works and examples that a search finds besides the cycles. */
function useOtherResults(): OtherRows {
  const { start: t, examples } = useTexts("first").page;
  const works = useSavedWorks((k) => k.works);
  return (sought) => {
    if (sought === null) return { count: 0, best: null, shown: null };
    const found = findOtherResults(sought, works, examples);
    const all = [
      ...found.works.map(({ work, name }) => ({ id: work, name: t.foundWork(name), go: () => void openSaved(work) })),
      ...found.examples.map((id: ExampleId) => ({
        id,
        name: t.foundExample(examples[id]),
        go: () => void openExample(id),
      })),
    ];
    const shown: ReactNode = all.length > 0 && (
      <ul className="found-more">
        {all.map(({ id, name, go }) => (
          <li key={id}>
            <button type="button" className="button found-one" onClick={go}>
              {name}
            </button>
          </li>
        ))}
      </ul>
    );
    return { count: all.length, best: all[0] ?? null, shown };
  };
}

/** The first screen: stored works, an introduction, and the ways to start a work. */
export function StartPage({ course }: { readonly course: ReactNode }) {
  const t = useTexts("first");
  const going = useRef(false);
  const pictures = usePictures();
  const more = useOtherResults();
  // Returning visitors come for their works, so the introduction comes after them. It keeps its place during the visit.
  const [returns] = useState(() => useSavedWorks.getState().works.length > 0 || useRecent.getState().cycles.length > 0);
  useEffect(() => {
    void refreshWorks();
  }, []);
  useEffect(() => prefetchIdle(fetchBegin), []);
  const page = useRef<HTMLElement>(null);
  useEffect(() => {
    const onKey = (event: KeyboardEvent) => page.current && typeIntoSearch(page.current, event);
    document.addEventListener("keydown", onKey);
    return () => document.removeEventListener("keydown", onKey);
  }, []);

  /** Clicked twice while the catalogue is loading, the button still starts one work. */
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
  const welcome = (
    <div className="welcome-place">
      <Suspense>
        <Welcome pictures={pictures} />
      </Suspense>
    </div>
  );
  return (
    <main className="start-page" ref={page}>
      <div className="start-lead">
        <h1>{words.title}</h1>
        <p className="soft">{words.lead}</p>
        <div className="course-place">
          <Suspense>{course}</Suspense>
        </div>
      </div>
      <SavedPrograms />
      {!returns && welcome}
      <ProgramStart pictures={pictures} />
      <section className="start-cycles" aria-label={words.choose}>
        <h2>{words.choose}</h2>
        <p className="soft">{words.chooseLead}</p>
        <CycleChooser
          search={words.search}
          found={words.found}
          more={more}
          ways={[
            {
              name: words.withExample,
              short: words.withExample,
              go: (cycle) => void start(cycle, true),
            },
            {
              name: words.empty,
              short: t.chooser.empty,
              go: (cycle) => void start(cycle, false),
            },
          ]}
        />
      </section>
      {returns && welcome}
      <p className="small">
        <a href="gallery.html">{t.page.gallery}</a>
      </p>
      <p className="small soft disclaimer">{t.page.disclaimer}</p>
    </main>
  );
}
