import { useEffect, useRef } from "react";
import { catalogue, cycleByNumber, type CycleNumber } from "../../cycles/index.ts";
import { isRecalled } from "../../cycles/params.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { useOwnCycles } from "../../app/document/own-reading.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { AdvicePage } from "./AdvicePage.tsx";
import { BlockLinks, BlockPage } from "./BlockPage.tsx";
import { ContourPage } from "./ContourPage.tsx";
import { CyclePage } from "./CyclePage.tsx";
import { FormLinks, formOfPage, FormPage } from "./FormPage.tsx";
import { GlossaryPage } from "./GlossaryPage.tsx";
import { GuideButton } from "./GuideButton.tsx";
import { guidePath, type GuidePath, showGuide, uncover, usePlace } from "../../app/place/place.ts";
import { OwnCyclePage } from "./OwnCyclePage.tsx";
import { ParameterPage } from "./ParameterPage.tsx";
import { isSetupPage, SETUP_PAGES, type SetupPageId } from "./setup-variants.ts";
import { setupPageWords } from "./setup-page-words.ts";
import { SetupPlacePage } from "./SetupPlacePage.tsx";
import { AppliedValueNote } from "./AppliedValueNote.tsx";
import "./guide.css";

/** All cycles, then the other prompts, each linked to its page. */
function CycleList() {
  const t = useTexts("guide");
  const places = useTexts("guide-places");
  const blocks = useTexts("guide-blocks");
  const texts = useTexts();
  const own = [...useOwnCycles().values()];
  return (
    <>
      <h1>{t.cycles.title}</h1>
      <p className="soft">{t.cycles.lead}</p>
      <ul className="guide-links">
        {catalogue.map((cycle) => (
          <GuideButton key={cycle.number} to={["guide", String(cycle.number)]}>
            <b className="number">{cycle.number}</b> {texts.cycles.of[cycle.number as CycleNumber].name}
            {isRecalled(cycle) && <span className="guide-recalled small soft">{texts.dialog.evidence.mark}</span>}
          </GuideButton>
        ))}
      </ul>
      {own.length > 0 && (
        <>
          <h2>{places.ownCycles}</h2>
          <ul className="guide-links">
            {own.map(({ number, name }) => (
              <GuideButton key={number} to={["guide", String(number)]}>
                <b className="number">{number}</b> {name}
              </GuideButton>
            ))}
          </ul>
        </>
      )}
      <h2>{places.setup}</h2>
      <ul className="guide-links">
        {SETUP_PAGES.map((id) => (
          <GuideButton key={id} to={["guide", "setup", id]}>
            <b className="number">{setupPageWords(texts, id).letter}</b> {setupPageWords(texts, id).name}
          </GuideButton>
        ))}
      </ul>
      <h2>
        {places.contour} · {places.approach}
      </h2>
      <ul className="guide-links">
        <GuideButton to={["guide", "contour"]}>
          <b className="number">LBL</b> {texts.dialog.contour.question}
        </GuideButton>
        <FormLinks />
      </ul>
      <h2>{blocks.title}</h2>
      <p className="soft">{blocks.lead}</p>
      <ul className="guide-links">
        <BlockLinks />
      </ul>
    </>
  );
}

/** All blocks of a program, each linked to its page. */
function BlockList() {
  const blocks = useTexts("guide-blocks");
  return (
    <>
      <h1>{blocks.title}</h1>
      <p className="soft">{blocks.lead}</p>
      <ul className="guide-links">
        <BlockLinks />
      </ul>
    </>
  );
}

/** The page of a cycle, or of one of its parameters. */
function OfCycle({ number, q }: { readonly number: number; readonly q: string | undefined }) {
  const t = useTexts("guide");
  const cycle = cycleByNumber(number);
  const own = useOwnCycles().get(number);
  const param = q === undefined ? undefined : cycle?.params[q];
  if (!cycle && own) return <OwnCyclePage own={own} q={q ?? null} />;
  if (!cycle || (q !== undefined && !param)) return <h1>{t.missing}</h1>;
  return q !== undefined && param ? (
    <ParameterPage key={`${number}/${q}`} cycle={cycle} q={q} param={param} />
  ) : (
    <CyclePage key={number} cycle={cycle} />
  );
}

function Shown({ path: [page, first, second] }: { readonly path: GuidePath }) {
  const t = useTexts("guide");
  if (page === "glossary") return <GlossaryPage term={first ?? null} />;
  if (first === undefined) return <CycleList />;
  if (first === "advice") return <AdvicePage />;
  if (first === "contour") return <ContourPage />;
  if (first === "setup")
    return isSetupPage(second ?? "") ? (
      <SetupPlacePage key={second} id={second as SetupPageId} />
    ) : (
      <h1>{t.missing}</h1>
    );
  if (first === "block") return second === undefined ? <BlockList /> : <BlockPage key={second} name={second} />;
  const form = formOfPage(first);
  if (form) return <FormPage key={first} {...form} word={second ?? null} />;
  return <OfCycle number={Number(first)} q={second} />;
}

/** The guide, which replaces the open view: a parameter, a cycle with its steps, or the glossary. */
export function GuidePage() {
  const t = useTexts("guide");
  const advice = useTexts("advice");
  const shown = usePlace(guidePath) ?? [];
  const [page, first, second] = shown;
  const back = useRef<HTMLButtonElement>(null);
  useEffect(() => back.current?.focus(), []);
  const main = useRef<HTMLElement>(null);
  const name = shown.join("/");
  useEffect(() => {
    main.current?.scrollTo(0, 0);
  }, [name]);
  return (
    <main
      className="guide-page"
      ref={main}
      onKeyDown={(event) => {
        if (event.key !== "Escape" || event.defaultPrevented) return;
        event.preventDefault();
        uncover();
      }}
    >
      <nav className="guide-bar" aria-label={t.cycles.title}>
        <button ref={back} type="button" className="button" aria-label={t.backLong} onClick={uncover}>
          <Icon name="back" /> {t.back}
        </button>
        {page === "guide" && second !== undefined && Number(first) > 0 && (
          <button type="button" className="button" onClick={() => showGuide("guide", first ?? "")}>
            {t.toCycle(Number(first))}
          </button>
        )}
        {page === "guide" && first !== undefined && (
          <button type="button" className="button plain" onClick={() => showGuide("guide")}>
            {t.cycles.title}
          </button>
        )}
        {page === "guide" && (
          <button type="button" className="button plain" onClick={() => showGuide("glossary")}>
            {t.glossary.title}
          </button>
        )}
        {first !== "advice" && (
          <button type="button" className="button plain" onClick={() => showGuide("guide", "advice")}>
            {advice.title}
          </button>
        )}
        {page === "glossary" && (
          <button type="button" className="button plain" onClick={() => showGuide("guide")}>
            {t.cycles.title}
          </button>
        )}
      </nav>
      <article className="guide-body">
        <Shown path={shown} />
      </article>
      <AppliedValueNote page={name} />
    </main>
  );
}
