import { cuttingCycles, cycleByNumber } from "../../cycles/index.ts";
import type { Texts } from "../../i18n/index.ts";
import { formatNumber } from "../../i18n/number.ts";
import { never } from "../../kernel/never.ts";
import { useOutcome } from "../engine/outcome.ts";
import { Icon } from "../Icon.tsx";
import { CycleInWork } from "../issue-text.ts";
import { useSettings } from "../settings/settings.ts";
import { useTexts } from "../settings/use-texts.ts";
import { useEditor } from "../store.ts";
import { useToolList } from "../tools/work-tools.ts";
import { showGuide } from "./guide-place.ts";
import { SETUP_PAGES, type SetupPageId } from "./setup-variants.ts";
import { StartingValues } from "./StartingValues.tsx";
import { useGuidePlaces } from "./use-guide-places.ts";
import { useGuideTexts } from "./use-guide-texts.ts";
import { useTriedSetup } from "./use-tried-setup.ts";
import { ValueCard } from "./ValueCard.tsx";

/** How a place is written in front of a value, what it is called, and what it is measured in. */
export function setupPageWords(
  { setup: t }: Texts,
  id: SetupPageId,
): { readonly letter: string; readonly name: string; readonly unit: string } {
  const { units } = t;
  switch (id) {
    case "blank.outside":
      return { letter: "D", name: t.blank.outside, unit: units.diameter };
    case "blank.bore":
      return { letter: "DI", name: t.blank.bore, unit: units.diameter };
    case "blank.length":
      return { letter: "L", name: t.blank.length, unit: units.mm };
    case "blank.allowance":
      return { letter: "DIST", name: t.blank.allowance, unit: units.mm };
    case "tool":
      return { letter: "T", name: t.tool.title, unit: "" };
    case "start.x":
      return { letter: "X", name: t.start.x, unit: units.diameter };
    case "start.z":
      return { letter: "Z", name: t.start.z, unit: units.mm };
    case "spindle.cuttingSpeed":
      return { letter: "VC", name: t.spindle.cuttingSpeed, unit: units.cuttingSpeed };
    case "spindle.limit":
      return { letter: "SMAX", name: t.spindle.limit, unit: units.rpm };
    case "spindle.speed":
      return { letter: "S", name: t.spindle.speed, unit: units.rpm };
    case "perRevolution":
      return { letter: "M136", name: t.feed.perRevolution, unit: "" };
    case "rapid":
      return { letter: "FMAX", name: t.feed.rapid, unit: units.perMinute };
  }
}

/** The cycle that the set-up is shown with: that of the open work, the first of a program, or the first that cuts. */
function useShownCycle() {
  const job = useEditor((s) => s.job?.cycle);
  const first = useOutcome((s) => s.newest?.run.operations[0]?.cycle);
  const cycle = cycleByNumber(job ?? first ?? 0);
  return cycle && !cycle.acts ? cycle : cuttingCycles[0] ?? never("no cycle");
}

/** What the set-up does at other values, run by the kernel. */
function SetupPictures({ id }: { readonly id: SetupPageId }) {
  const t = useGuideTexts();
  const places = useGuidePlaces();
  const texts = useTexts();
  const language = useSettings((s) => s.language);
  const tools = useToolList();
  const cycle = useShownCycle();
  const { made, working } = useTriedSetup(cycle, id);
  const { letter, unit } = setupPageWords(texts, id);
  const textOf = (value: number) => (id === "perRevolution" ? [places.off, places.on][value] ?? "" : formatNumber(language, value));
  return (
    <section className="guide-values" aria-label={t.values.title} aria-busy={working}>
      <h2>{t.values.title}</h2>
      <p className="soft">{places.runWith}</p>
      {made === undefined && <p className="guide-working soft" role="status">{t.values.working}</p>}
      {made === null && <p className="soft">{t.values.none}</p>}
      {made && (
        <CycleInWork value={cycle.number}>
          <ol className="value-cards">
            {made.tried.map((tried) => (
              <ValueCard key={tried.value} tried={tried} box={made.box} letter={letter} text={textOf(tried.value)} unit={unit} size={null}
                whose={tried.isUsual ? (made.isOwn ? t.values.yours : t.values.printed) : null} meaning={id === "tool"
                ? tools.find(({ T }) => T === tried.value)?.NAME
                : undefined} take={null} />
            ))}
          </ol>
        </CycleInWork>
      )}
    </section>
  );
}

/** The page of a prompt or field of the set-up. */
export function SetupPlacePage({ id }: { readonly id: SetupPageId }) {
  const t = useGuideTexts();
  const places = useGuidePlaces();
  const texts = useTexts();
  const cycle = useShownCycle();
  const { letter, name, unit } = setupPageWords(texts, id);
  const at = SETUP_PAGES.indexOf(id), [before, after] = [SETUP_PAGES[at - 1], SETUP_PAGES[at + 1]];
  const { about, mistakes } = places.places[id];
  const turn = (to: SetupPageId | undefined, icon: "up" | "down", said: string, long: (name: string) => string) => (
    <button type="button" className="button" disabled={!to} aria-label={to && long(setupPageWords(texts, to).name)} onClick={() =>
      to && showGuide("guide", "setup", to)}
    >
      <Icon name={icon} /> {said}
    </button>
  );
  return (
    <>
      <header className="guide-head">
        <p className="soft">{places.setup}</p>
        <h1>
          <span className="number prompt-q">{letter}</span> {name}
        </h1>
        <p>{about}</p>
        {unit !== "" && (
          <p className="soft">
            {t.unit}: <span className="number">{unit}</span>
          </p>
        )}
        <div className="guide-turns">{turn(before, "up", t.previous, t.previousLong)} {turn(after, "down", t.next, t.nextLong)}</div>
      </header>
      {id === "spindle.cuttingSpeed" && <StartingValues cycle={cycle} only={null} />}
      <SetupPictures id={id} />
      <section className="guide-mistakes" aria-label={t.mistakes}>
        <h2>{t.mistakes}</h2>
        <ul>{mistakes.map((sentence) => <li key={sentence}>{sentence}</li>)}</ul>
      </section>
    </>
  );
}
