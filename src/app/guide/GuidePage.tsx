import { useEffect, useRef } from "react";
import { catalogue, cycleByNumber } from "../../cycles/index.ts";
import { Icon } from "../Icon.tsx";
import { useTexts } from "../settings/use-texts.ts";
import { AdvicePage } from "./AdvicePage.tsx";
import { CyclePage } from "./CyclePage.tsx";
import { GlossaryPage } from "./GlossaryPage.tsx";
import { hideGuide, showGuide, useGuidePlace, type GuidePath } from "./guide-place.ts";
import { ParameterPage } from "./ParameterPage.tsx";
import { useAdviceTexts } from "./use-advice.ts";
import { useGuideTexts } from "./use-guide-texts.ts";
import "./guide.css";

/** All cycles, each leading to its own page. */
function CycleList() {
  const t = useGuideTexts();
  const { cycles } = useTexts();
  return (
    <>
      <h1>{t.cycles.title}</h1>
      <p className="soft">{t.cycles.lead}</p>
      <ul className="guide-links">
        {catalogue.map(({ number }) => (
          <li key={number}>
            <button type="button" className="guide-link" onClick={() => showGuide("guide", String(number))}>
              <b className="number">{number}</b> {cycles.of[number as keyof typeof cycles.of].name}
            </button>
          </li>
        ))}
      </ul>
    </>
  );
}

function Shown({ path: [page, first, second] }: { readonly path: GuidePath }) {
  const t = useGuideTexts();
  if (page === "glossary") return <GlossaryPage term={first ?? null} />;
  if (first === undefined) return <CycleList />;
  if (first === "advice") return <AdvicePage />;
  const cycle = cycleByNumber(Number(first));
  const param = second === undefined ? undefined : cycle?.params[second];
  if (!cycle || (second !== undefined && !param)) return <h1>{t.missing}</h1>;
  return second !== undefined && param
    ? <ParameterPage key={path(cycle.number, second)} cycle={cycle} q={second} param={param} />
    : <CyclePage key={cycle.number} cycle={cycle} />;
}
const path = (cycle: number, q: string) => `${cycle}/${q}`;

/** The guide in place of what is open: a parameter, a cycle with its steps, or the glossary. */
export function GuidePage() {
  const t = useGuideTexts();
  const advice = useAdviceTexts();
  const shown = useGuidePlace((p) => p.path) ?? [];
  const [page, first, second] = shown;
  const back = useRef<HTMLButtonElement>(null);
  useEffect(() => back.current?.focus(), []);
  const main = useRef<HTMLElement>(null);
  const name = shown.join("/");
  useEffect(() => {
    main.current?.scrollTo(0, 0);
  }, [name]);
  return (
    <main className="guide-page" ref={main} onKeyDown={(event) => {
      if (event.key !== "Escape" || event.defaultPrevented) return;
      event.preventDefault();
      hideGuide();
    }}>
      <nav className="guide-bar" aria-label={t.cycles.title}>
        <button ref={back} type="button" className="button" aria-label={t.backLong} onClick={hideGuide}>
          <Icon name="back" /> {t.back}
        </button>
        {page === "guide" && second !== undefined && (
          <button type="button" className="button" onClick={() => showGuide("guide", first ?? "")}>{t.toCycle(Number(first))}</button>
        )}
        {page === "guide" && first !== undefined && (
          <button type="button" className="button plain" onClick={() => showGuide("guide")}>{t.cycles.title}</button>
        )}
        {page === "guide" && (
          <button type="button" className="button plain" onClick={() => showGuide("glossary")}>{t.glossary.title}</button>
        )}
        {first !== "advice" && (
          <button type="button" className="button plain" onClick={() => showGuide("guide", "advice")}>{advice.title}</button>
        )}
        {page === "glossary" && <button type="button" className="button plain" onClick={() => showGuide("guide")}>{t.cycles.title}</button>}
      </nav>
      <article className="guide-body">
        <Shown path={shown} />
      </article>
    </main>
  );
}
