import type { Cycle } from "../../cycles/define.ts";
import { cycleByNumber, type ChoiceTextId, type CycleNumber } from "../../cycles/index.ts";
import { writer } from "../../i18n/write.ts";
import type { Language } from "../../i18n/languages.ts";
import type { Texts } from "../../i18n/index.ts";
import type { WhichTexts } from "../../i18n/which-text.ts";
import { bestFirst, bestOf } from "../../report/which/best.ts";
import { pointAngle } from "../../kernel/cutter/insert.ts";
import { hasAngleOf } from "../../program/tools/thread-tool.ts";
import type { TriedOption } from "../../report/which/try-way.ts";
import type { Proposal } from "../../report/which/ways.ts";
import { NO_AREA } from "../../app/findings/effect/effect.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { issueText } from "../../app/calculation/issue-text.ts";
import { durationText } from "../../app/base/clock-text.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts, useTextsOrNull } from "../../app/base/settings/use-texts.ts";
import type { ComparedProposals } from "./use-comparison.ts";

/** Most problems listed for a proposal. */
const MOST = 2;

interface Props {
  readonly words: WhichTexts;
  readonly compared: ComparedProposals;
  /** Whether a proposal is added to the open program, or starts a new work. */
  readonly adds: boolean;
  readonly onTake: (way: Proposal) => void;
}

/** The value that distinguishes a proposal from another one with the same cycle. */
function choiceText(t: Texts, cycle: Cycle, { choice }: Proposal): string | null {
  const param = choice && cycle.params[choice.q];
  if (!param) return null;
  const { choices } = t.params[param.text as ChoiceTextId];
  return `${choice.q} = ${choice.value}: ${choices[choice.value] ?? ""}`;
}

/** The problems of a proposal, worst first. */
function problemsOf(
  t: Texts,
  words: WhichTexts,
  language: Language,
  { issues, judged, leavesMost, suitsDepth }: TriedOption,
  cycle: number,
) {
  const found = judged.reasons.flatMap(({ kind }) => {
    if (kind === "error" || kind === "holderUnknown" || kind === "flanksUnknown" || kind === "curvatureUnknown")
      return [];
    return [kind in words.problems ? words.problems[kind as keyof typeof words.problems] : words.problems.unproved];
  });
  const said = issues.map((issue) => issueText(t, language, issue, cycle));
  return [
    ...new Set([
      ...said,
      ...found,
      ...(leavesMost ? [words.problems.leavesMost] : []),
      ...(suitsDepth ? [] : [words.problems.finishingInsert]),
    ]),
  ].slice(0, MOST);
}

/** The proposals: time, residual material, and the button that uses one. */
export function ProposalCards({ words, compared: { wanted, ways, tried, isStale }, adds, onTake }: Props) {
  const t = useTexts(),
    { duration } = t.page.effect;
  const language = useSettings((s) => s.language);
  const write = writer(language);
  const threads = useTextsOrNull("threads");
  /** An insert with another angle than the thread that was asked for. */
  const insertProblem = ({ tool }: Proposal) =>
    threads && wanted.thread && !hasAngleOf(wanted.thread, tool)
      ? [threads.noInsert(String(tool.T), write.number(pointAngle(tool)), write.number(wanted.thread.angle))]
      : [];
  const best = bestOf(tried);
  const whole = tried.length === ways.length;
  const nameOf = (way: Proposal) => `${way.job.cycle} ${t.cycles.of[way.job.cycle as CycleNumber].name}`;
  const bestWay = best && ways.find((way) => way.id === best.id);
  const order = [...bestFirst(tried).map((each) => each.id), ...ways.map((way) => way.id)];
  const sorted = ways.toSorted((a, b) => order.indexOf(a.id) - order.indexOf(b.id));
  return (
    <>
      <p role="status" className="which-status">
        {!whole && <span className="soft">{words.trying(tried.length, ways.length)}</span>}
        {whole && ways.length === 0 && words.none}
        {whole && ways.length > 0 && !bestWay && words.noneWorks}
        {whole && best && bestWay && (
          <>
            <Icon name="check" />{" "}
            {words.bestIs(
              `${nameOf(bestWay)}, ${words.tool(bestWay.tool.T, bestWay.tool.NAME)}`,
              words.because[best.because],
            )}
          </>
        )}
      </p>
      {ways.length > 0 && (
        <ul className="which-ways" aria-label={words.ways} aria-busy={!whole || isStale}>
          {sorted.map((way) => {
            const cycle = cycleByNumber(way.job.cycle);
            if (!cycle) return null;
            const one = tried.find((each) => each.id === way.id);
            const choice = choiceText(t, cycle, way);
            const isBest = whole && way.id === best?.id;
            const name = [
              nameOf(way),
              words.tool(way.tool.T, way.tool.NAME),
              ...(choice === null ? [] : [choice]),
            ].join(", ");
            const problems = one ? [...insertProblem(way), ...problemsOf(t, words, language, one, way.job.cycle)] : [];
            const [reason] = one?.reasons ?? [];
            return (
              <li key={way.id} className={`which-way${isBest ? " which-best" : ""}`}>
                <h3>
                  <span className="number card-number">{way.job.cycle}</span>{" "}
                  {t.cycles.of[way.job.cycle as CycleNumber].name}
                  {isBest && <span className="which-mark">{words.best}</span>}
                </h3>
                <p className="small">{words.tool(way.tool.T, way.tool.NAME)}</p>
                {choice !== null && <p className="small soft">{choice}</p>}
                <dl aria-hidden={one ? undefined : true}>
                  <div>
                    <dt>{words.passes}</dt>
                    <dd className="number">{one ? one.passes : "…"}</dd>
                  </div>
                  <div>
                    <dt>{words.time}</dt>
                    <dd className="number">{one ? durationText(duration, language, one.seconds) : "…"}</dd>
                  </div>
                  <div className="which-stays">
                    <dt>{words.residual}</dt>
                    <dd>
                      {!one && "…"}
                      {one && one.residualArea === null && <span className="soft">{words.noArea}</span>}
                      {one &&
                        one.residualArea !== null &&
                        (one.residualArea < NO_AREA ? (
                          words.nothing
                        ) : (
                          <>
                            <span className="number">{write.area(one.residualArea)}</span>
                            {reason && <span className="soft small">{words.reasons[reason.reason]}</span>}
                          </>
                        ))}
                    </dd>
                  </div>
                </dl>
                {one && (
                  <ul className="which-verdict small">
                    {one.works && (
                      <li className="which-good">
                        <Icon name="check" /> {words.proved}
                      </li>
                    )}
                    {problems.map((problem) => (
                      <li key={problem} className={one.works ? "which-doubt" : "which-bad"}>
                        <Icon name={one.works ? "warning" : "error"} /> {problem}
                      </li>
                    ))}
                  </ul>
                )}
                <button
                  type="button"
                  className={`button${isBest ? " primary" : ""}`}
                  aria-label={adds ? words.insertLong(name) : words.takeLong(name)}
                  disabled={!one || isStale}
                  onClick={() => onTake(way)}
                >
                  {adds ? words.insert : words.take}
                </button>
              </li>
            );
          })}
        </ul>
      )}
    </>
  );
}
