import { cuttingCycles, cycleByNumber } from "../../cycles/index.ts";
import { formatNumber } from "../../i18n/number.ts";
import { never } from "../../kernel/never.ts";
import { useOutcome } from "../../app/calculation/outcome.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { CycleInWork } from "../../app/calculation/issue-text.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { useEditor } from "../../app/document/store.ts";
import { useToolList } from "../../app/document/work-tools.ts";
import { GlossaryText, GlossaryList, GlossaryScope } from "../../app/fields/said/GlossaryText.tsx";
import { showGuide } from "../../app/place/place.ts";
import { setupPageWords } from "./setup-page-words.ts";
import { SETUP_PAGES, type SetupPageId } from "./setup-variants.ts";
import { applySetupValue } from "./apply-value.ts";
import { StartingValues } from "./StartingValues.tsx";
import { useTriedSetup } from "./use-tried-setup.ts";
import { ValueCard } from "./ValueCard.tsx";

/** The sample cycle for the set-up: that of the open work, the first of a program, or the first that cuts. */
function useShownCycle() {
  const job = useEditor((s) => s.job?.cycle);
  const first = useOutcome((s) => s.newest?.run.operations[0]?.cycle);
  const cycle = cycleByNumber(job ?? first ?? 0);
  return cycle && !cycle.acts ? cycle : (cuttingCycles[0] ?? never("no cycle"));
}

/** The set-up at other values, simulated. */
function SetupPictures({ id }: { readonly id: SetupPageId }) {
  const t = useTexts("guide");
  const places = useTexts("guide-places");
  const texts = useTexts();
  const language = useSettings((s) => s.language);
  const tools = useToolList();
  const cycle = useShownCycle();
  const canTake = useEditor((s) => s.job?.cycle === cycle.number);
  const { made, working } = useTriedSetup(cycle, id);
  const { letter, unit } = setupPageWords(texts, id);
  const textOf = (value: number) =>
    id === "perRevolution" ? ([places.off, places.on][value] ?? "") : formatNumber(language, value);
  return (
    <section className="guide-values" aria-label={t.values.title} aria-busy={working}>
      <h2>{t.values.title}</h2>
      <p className="soft">{places.runWith}</p>
      {made === undefined && (
        <p className="guide-working soft" role="status">
          {t.values.working}
        </p>
      )}
      {made === null && <p className="soft">{t.values.none}</p>}
      {made && (
        <CycleInWork value={cycle.number}>
          <ol className="value-cards">
            {made.tried.map((tried) => (
              <ValueCard
                key={tried.value}
                tried={tried}
                box={made.box}
                letter={letter}
                text={textOf(tried.value)}
                unit={unit}
                size={null}
                whose={tried.isUsual ? (made.isOwn ? t.values.yours : t.values.printed) : null}
                meaning={id === "tool" ? tools.find(({ T }) => T === tried.value)?.NAME : undefined}
                take={
                  canTake && made.isOwn && !tried.isUsual
                    ? () =>
                        applySetupValue(
                          id,
                          tried.value,
                          letter,
                          id === "perRevolution" ? textOf(tried.value) : tried.value,
                        )
                    : null
                }
              />
            ))}
          </ol>
        </CycleInWork>
      )}
    </section>
  );
}

/** The page of a prompt or field of the set-up. */
export function SetupPlacePage({ id }: { readonly id: SetupPageId }) {
  const t = useTexts("guide");
  const places = useTexts("guide-places");
  const texts = useTexts();
  const cycle = useShownCycle();
  const { letter, name, unit } = setupPageWords(texts, id);
  const at = SETUP_PAGES.indexOf(id),
    [before, after] = [SETUP_PAGES[at - 1], SETUP_PAGES[at + 1]];
  const { about, mistakes } = places.places[id];
  const turn = (to: SetupPageId | undefined, icon: "up" | "down", said: string, long: (name: string) => string) => (
    <button
      type="button"
      className="button"
      disabled={!to}
      aria-label={to && long(setupPageWords(texts, to).name)}
      onClick={() => to && showGuide("guide", "setup", to)}
    >
      <Icon name={icon} /> {said}
    </button>
  );
  return (
    <GlossaryScope texts={[about, ...mistakes]}>
      <header className="guide-head">
        <p className="soft">{places.setup}</p>
        <h1>
          <span className="number prompt-q">{letter}</span> {name}
        </h1>
        <p>
          <GlossaryText text={about} />
        </p>
        {unit !== "" && (
          <p className="soft">
            {t.unit}: <span className="number">{unit}</span>
          </p>
        )}
        <div className="guide-turns">
          {turn(before, "up", t.previous, t.previousLong)} {turn(after, "down", t.next, t.nextLong)}
        </div>
      </header>
      {id === "spindle.cuttingSpeed" && <StartingValues cycle={cycle} only={null} />}
      <SetupPictures id={id} />
      <section className="guide-mistakes" aria-label={t.mistakes}>
        <h2>{t.mistakes}</h2>
        <GlossaryList texts={mistakes} />
      </section>
    </GlossaryScope>
  );
}
