import { useEffect, useMemo, type ReactNode } from "react";
import { Tab, TabList, TabPanel, Tabs } from "react-aria-components/Tabs";
import { plannedPart, type PlannedPartResult } from "../../planning/part/planned-part.ts";
import type { FinishedPart } from "../../planning/part/finished-part.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { focusPart } from "../../app/base/focus-guard.ts";
import { lazyPart } from "../../app/base/parts.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { CountedIn } from "../../app/calculation/lengths.ts";
import { contourSlot } from "../../app/fields/slots.ts";
import { chooseElement } from "../../app/place/contour-place.ts";
import { editPart, openFirstPart, useParts, type StoredPart } from "../../app/records/part-store.ts";
import { PartTab } from "./PartTab.tsx";
import { PlanHead } from "./PlanHead.tsx";
import { PlanPicture } from "./PlanPicture.tsx";
import { PlanStrip } from "./PlanStrip.tsx";
import { planOfClamping, PlanTab } from "./PlanTab.tsx";
import { StockTab } from "./StockTab.tsx";
import { ToolsTab } from "./ToolsTab.tsx";
import { tableRows, withTableRows } from "./part-rows.ts";
import { PLAN_TABS, sayOpened, showClamping, showTab, usePlanPlace, type PlanSection } from "./plan-place.ts";
import { resumePlan, usePlanOf, usePlans } from "./plan-store.ts";
import type { PlanWords } from "../../app/fields/plan/plan-words.ts";
import "./plan.css";

const ContourStage = lazyPart(async () => {
  const { fetchContourStage } = await contourSlot.fetch();
  return { default: (await fetchContourStage()).ContourStage };
});

const NO_RINGS: readonly Ring[] = [];

/** The page that plans a finished part: the part, its stock, the tools, and the plan beside its picture. */
export function PlanPage() {
  const t = useTexts("plan");
  const stored = useParts((p) => p.list[0]);
  useEffect(() => {
    if (!stored) openFirstPart(t.part.first);
  }, [stored, t]);
  useEffect(() => () => chooseElement(null), [stored?.id]);
  useEffect(() => {
    // A dialog that led here has closed: the focus has nowhere to return to.
    if (navigator.userActivation.hasBeenActive) focusPart(".plan-page", () => undefined);
  }, []);
  return stored ? (
    <CountedIn value="mm">
      <OpenPart key={stored.id} stored={stored} />
    </CountedIn>
  ) : null;
}

function OpenPart({ stored }: { readonly stored: StoredPart }) {
  const t = useTexts("plan"),
    work = useTexts(),
    problems = useTexts("part"),
    language = useSettings((s) => s.language);
  const words: PlanWords = useMemo(() => ({ t, work, problems, language }), [t, work, problems, language]);
  const { part } = stored;
  const planned = useMemo(() => plannedPart(part), [part]);
  const tab = usePlanPlace((p) => p.tab);
  const { made, isOutdated } = usePlanOf(stored);
  const isRunning = usePlans((s) => s.running?.id === stored.id);
  useEffect(() => {
    resumePlan(stored);
    showClamping("first");
    // Once for each part that is opened.
    // oxlint-disable-next-line react/exhaustive-deps
  }, [stored.id]);
  const onPart = (next: FinishedPart, place: string | null) => editPart((now) => ({ ...now, part: next }), place);
  const content: Readonly<Record<PlanSection, ReactNode>> = {
    part: <PartTab words={words} stored={stored} planned={planned} onPart={onPart} />,
    stock: <StockTab words={words} stored={stored} planned={planned} onPart={onPart} />,
    tools: <ToolsTab words={words} stored={stored} onPart={onPart} />,
    plan: <PlanTab words={words} stored={stored} made={made} isOutdated={isOutdated} isRunning={isRunning} />,
  };
  return (
    <main className="plan-page">
      <PlanHead words={words} stored={stored} onPart={onPart} />
      <div className="plan-body">
        <Tabs className="sections plan-tabs" selectedKey={tab} onSelectionChange={(key) => showTab(key as PlanSection)}>
          <TabList className="tabs" aria-label={t.tabs.name}>
            {PLAN_TABS.map((each) => (
              <Tab key={each} id={each} className="tab">
                {t.tabs[each]}
              </Tab>
            ))}
          </TabList>
          {PLAN_TABS.map((each) => (
            <TabPanel key={each} id={each} className="panel plan-panel">
              {content[each]}
            </TabPanel>
          ))}
        </Tabs>
        <PlanStage words={words} stored={stored} planned={planned} onPart={onPart} />
      </div>
      <PlanStrip
        words={words}
        stored={stored}
        made={made}
        isOutdated={isOutdated}
        onPlan={() => {
          sayOpened(null);
          showTab("plan");
        }}
      />
    </main>
  );
}

/** The picture: the contour to edit while the part is typed, otherwise the stock of the plan. */
function PlanStage({
  words: { t, language },
  stored,
  planned,
  onPart,
}: {
  readonly words: PlanWords;
  readonly stored: StoredPart;
  readonly planned: PlannedPartResult;
  readonly onPart: (part: FinishedPart, place: string | null) => void;
}) {
  const { tab, side, open, pointed, preview, rows, clamping } = usePlanPlace();
  const { made, isOutdated } = usePlanOf(stored);
  const progress = usePlans((s) => (s.running?.id === stored.id ? s.running.progress : null));
  const { part } = stored;
  if (tab === "part")
    return (
      <div className="plan-stage">
        <ContourStage
          rows={tableRows(part, side)}
          blank={planned.blank}
          language={language}
          onChange={(next, place) => onPart(withTableRows(part, side, next), place && `${side} ${place}`)}
          lead={null}
        />
      </div>
    );
  // The second clamping has the part turned end for end.
  const plan = progress ? null : planOfClamping(made, clamping),
    setup = tab === "plan" && clamping === "second" && plan ? plan.setup : planned,
    shown = tab === "plan" ? (pointed ?? open) : null,
    step = shown === null ? undefined : plan?.steps[shown];
  const stockOfStep = shown === open && preview ? preview : step?.tried.stock;
  const before = step && shown !== null ? (plan?.steps[shown - 1]?.tried.stock ?? setup.blank) : null;
  const isPlan = tab === "plan" && plan !== null;
  const chains = setup.part ? [setup.part.outside, setup.part.inside] : [];
  const { picture } = t;
  const shownWords = (): string => {
    if (progress) return progress.isWhole ? picture.searching : picture.begun;
    if (step && shown !== null) return picture.step(shown + 1, t.kinds[step.tried.action.kind]);
    return isPlan ? picture.finished : picture.blank;
  };
  return (
    <div className="plan-stage">
      <PlanPicture
        t={t}
        name={picture.name(shownWords())}
        part={chains.flatMap(({ segments }) => segments)}
        blank={setup.blank}
        clamping={setup.clamping}
        stock={progress?.stock ?? stockOfStep ?? (isPlan ? plan.stock : setup.blank)}
        before={progress ? null : before}
        residue={isPlan && !progress && !step ? plan.residue.flatMap(({ region }) => region?.rings ?? []) : NO_RINGS}
        chosen={chains.flatMap(({ segments, marks }) => segments.filter((_, i) => rows.includes(marks[i]?.row ?? "")))}
        isDimmed={progress !== null || (isPlan && isOutdated)}
      />
    </div>
  );
}
