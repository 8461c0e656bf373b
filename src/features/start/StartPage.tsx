import { useEffect, useRef, useState, type ReactNode } from "react";
import type { ExampleId } from "../../examples/index.ts";
import type { OtherRows } from "../../app/fields/chooser/use-cycle-chooser.tsx";
import { useCycleChooser } from "../../app/fields/chooser/use-cycle-chooser.tsx";
import { focusPart } from "../../app/base/focus-guard.ts";
import { lazyPart } from "../../app/base/parts.ts";
import { prefetchIdle } from "../../app/base/idle.ts";
import { refreshWorks, useSavedWorks } from "../../app/records/keep.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { openText } from "../../app/fields/open/open-program.ts";
import { useMedia } from "../../app/base/use-media.ts";
import { findOtherResults } from "./other-results.ts";
import { SavedPrograms, openSaved } from "../../app/fields/kept/SavedPrograms.tsx";
import { Beyond } from "./Beyond.tsx";
import { Doors } from "./Doors.tsx";
import { Examples } from "./Examples.tsx";
import { openExample } from "./open-example.ts";
import { usePictures } from "./use-pictures.ts";

/** Loaded after the rest, into reserved space. */
const Hero = lazyPart(async () => ({ default: (await import("./Hero.tsx")).Hero }));

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

/** A text of several lines pasted anywhere on the first screen is a program: a search has one line. */
function pasteProgram(event: ClipboardEvent): void {
  const text = event.clipboardData?.getData("text/plain") ?? "";
  if (!text.trim().includes("\n") || document.querySelector("dialog[open]")) return;
  event.preventDefault();
  openText(text);
  focusPart(".panel-structure", () => undefined);
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

/** The search of the start page, with its ways to start a cycle. */
function useStartChooser() {
  const t = useTexts("first");
  const { start: words } = t.page;
  const going = useRef(false);
  const more = useOtherResults();
  const byFinger = useMedia("coarse");
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
  return useCycleChooser({
    search: words.search,
    more,
    ...(!byFinger && { hint: t.start.hint }),
    ways: [
      { name: words.withExample, short: words.withExample, go: (cycle) => void start(cycle, true) },
      { name: words.empty, short: t.chooser.empty, go: (cycle) => void start(cycle, false) },
    ],
  });
}

/** The first screen: a search, the ways to start, a program on the lathe or the stored works, and all cycles. */
export function StartPage({ course }: { readonly course: ReactNode }) {
  const t = useTexts("first");
  const pictures = usePictures();
  const chooser = useStartChooser();
  // Returning visitors come for their works, so the lathe comes after them. It keeps its place during the visit.
  const hasWorks = useSavedWorks((k) => k.works.length > 0);
  const [returns, setReturns] = useState(hasWorks);
  if (hasWorks && !returns) setReturns(true);
  useEffect(() => {
    void refreshWorks();
  }, []);
  useEffect(() => prefetchIdle(fetchBegin), []);
  const page = useRef<HTMLElement>(null);
  const cycles = useRef<HTMLElement>(null);
  useEffect(() => {
    const onKey = (event: KeyboardEvent) => page.current && typeIntoSearch(page.current, event);
    document.addEventListener("keydown", onKey);
    document.addEventListener("paste", pasteProgram);
    return () => {
      document.removeEventListener("keydown", onKey);
      document.removeEventListener("paste", pasteProgram);
    };
  }, []);

  const { start: words } = t.page;
  const hero = (
    <div className="hero-place">
      <Hero of={pictures?.hero} />
    </div>
  );
  const toCycles = () => {
    cycles.current?.scrollIntoView();
    cycles.current?.querySelector<HTMLElement>("button")?.focus({ preventScroll: true });
  };
  return (
    <main className="start-page" ref={page} {...chooser.keys}>
      <h1>{words.title}</h1>
      <div className="cycle-chooser" role="group" aria-label={t.chooser.cycles}>
        {chooser.search}
        {chooser.found}
        {chooser.others}
        {!chooser.found && chooser.recent}
      </div>
      {!chooser.finds && (
        <>
          <div className="start-first">
            {returns ? <SavedPrograms /> : hero}
            <Doors course={course} toCycles={toCycles} />
          </div>
          <Beyond />
          {returns && hero}
          <Examples pictures={pictures} />
          <section className="start-section cycle-chooser" aria-label={words.choose} ref={cycles}>
            <h2>{words.choose}</h2>
            <p className="soft">{words.chooseLead}</p>
            {chooser.groups}
          </section>
          <p className="small">
            <a href="gallery.html">{t.page.gallery}</a>
          </p>
          <p className="small soft disclaimer">{t.page.disclaimer}</p>
        </>
      )}
    </main>
  );
}
