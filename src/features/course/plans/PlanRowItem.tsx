import {
  betterOf,
  type PlanComparison,
  type PlanRow,
  type TriedChange,
} from "../../../course/plans/plan-comparison.ts";
import { formatNumber } from "../../../i18n/number.ts";
import { isSameData } from "../../../app/base/same.ts";
import { Icon } from "../../../app/base/Icon.tsx";
import { areaWords, cycleName, reasonWords, settableWords, timeWords } from "../../../app/fields/plan/plan-words.ts";
import { ValueReason } from "../../../app/fields/said/ValueReason.tsx";
import { openText } from "../../../app/fields/open/open-program.ts";
import { setMaterial } from "../../../app/document/edits.ts";
import { presentProgram } from "../../../app/fields/compare/sides.ts";
import { toolName } from "./tool-name.ts";
import { differenceWords, otherValues, sidesOf, type ComparisonWords } from "./plan-row-words.ts";

interface Props {
  readonly words: ComparisonWords;
  readonly comparison: PlanComparison;
  readonly row: PlanRow;
  readonly goals: (all: TriedChange["missed"]) => string;
}

/** One operation of a side. */
interface Shown {
  readonly number: number;
  readonly cycle: number | null;
  readonly tool: number;
  readonly seconds: number;
  readonly takes: string;
}

function Side({
  words,
  name,
  shown,
}: {
  readonly words: ComparisonWords;
  readonly name: string;
  readonly shown: readonly Shown[];
}) {
  const { c } = words;
  return (
    <div className="plans-side">
      <h4>{name}</h4>
      {shown.length === 0 && <p className="soft">{c.nothing}</p>}
      {shown.map(({ number, cycle, tool, seconds, takes }) => (
        <p key={number}>
          <span className="plans-way">
            {c.number(number)} · {cycleName(words, cycle)}
          </span>
          <span className="small soft">{toolName(words, tool)}</span>
          <span className="small">
            <b className="number">{timeWords(words, seconds)}</b> <span className="soft">{takes}</span>
          </span>
        </p>
      ))}
    </div>
  );
}

/** Opens a trial as a program of its own, with the tools and the material of the learner's. */
function openTried(text: string): void {
  const present = presentProgram();
  openText(text, present ?? {});
  if (present?.material !== undefined) setMaterial(present.material);
}

/** A trial in the own program: what the whole part then takes, leaves and meets. */
function Tried({
  words,
  comparison,
  goals,
  title,
  tried,
}: Omit<Props, "row"> & { readonly title: string; readonly tried: TriedChange }) {
  const { c, t } = words;
  const { achieved } = comparison.own;
  const better = betterOf(achieved, tried);
  const difference = tried.seconds - achieved.seconds;
  const lost = tried.missed.filter((goal) => !achieved.missed.some((own) => isSameData(own, goal)));
  const sign = difference < 0 ? "−" : "+";
  return (
    <div className="plans-tried" data-better={better}>
      <span className="small soft">{c.tried[tried.kind]}</span>
      <b>
        <Icon name={better === "same" ? "info" : "check"} /> {c.tried.better[better]}
      </b>
      <span className="small number">
        {c.tried.time(timeWords(words, tried.seconds), `${sign}${timeWords(words, Math.abs(difference))}`)}
        {" · "}
        {c.tried.changes(tried.changes)}
        {" · "}
        {tried.left < LEAST ? c.tried.clean : c.tried.left(areaWords(words, tried.left))}
      </span>
      {lost.length > 0 && (
        <span className="small plans-missed">
          <Icon name="warning" /> {c.missed(goals(lost))}
        </span>
      )}
      {better === "other" && (
        <button
          type="button"
          className="button"
          aria-label={`${t.result.open}: ${title}, ${c.tried[tried.kind]}`}
          onClick={() => openTried(tried.text)}
        >
          {t.result.open}
        </button>
      )}
    </div>
  );
}

/** Smaller areas are none, mm². */
const LEAST = 0.05;

/** Operations that take the same stock, side by side, with their differences and what these came to. */
export function PlanRowItem({ words, comparison, row, goals }: Props) {
  const { t, c, language } = words;
  const { mine, theirs } = sidesOf(comparison, row);
  const planned = theirs.map(({ tried }) => t.kinds[tried.action.kind]).join(" + ");
  const title = planned || mine.map(({ cycle }) => cycleName(words, cycle)).join(" + ");
  const why = theirs.flatMap((step) => step.why.map((reason) => reasonWords(words, reason, step.tried.action)));
  const values = otherValues(comparison, row);
  const action = theirs[0]?.tried.action;
  const takes = (cut: number, isThread: boolean) => (isThread ? c.thread : t.steps.takes(areaWords(words, cut)));
  return (
    <li className="plans-row">
      <h3>{title}</h3>
      <ul className="plans-differs">
        {differenceWords(words, comparison, row).map((each) => (
          <li key={each} className="small">
            {each}
          </li>
        ))}
      </ul>
      <div className="plans-sides">
        <Side
          words={words}
          name={c.yours}
          shown={mine.map((each, i) => ({
            ...each,
            number: (row.own[i] ?? 0) + 1,
            takes: takes(each.cut, each.thread !== null),
          }))}
        />
        <Side
          words={words}
          name={c.planner}
          shown={theirs.map(({ tried, seconds }, i) => ({
            number: (row.other[i] ?? 0) + 1,
            cycle: tried.action.cycle,
            tool: tried.action.tool.T,
            seconds,
            takes: takes(tried.cut, tried.action.threads.length > 0),
          }))}
        />
      </div>
      {row.tried.map((tried) => (
        <Tried key={tried.kind} words={words} comparison={comparison} goals={goals} title={title} tried={tried} />
      ))}
      {(why.length > 0 || values.length > 0) && (
        <details className="plans-why">
          <summary>{c.why}</summary>
          {why.length > 0 && <p className="small">{why.join(" · ")}</p>}
          {action && values.length > 0 && (
            <table className="plans-values">
              <caption>{c.values.title}</caption>
              <thead>
                <tr>
                  <th scope="col">{c.values.value}</th>
                  <th scope="col">{c.yours}</th>
                  <th scope="col">{c.planner}</th>
                  <th scope="col">{c.values.reason}</th>
                </tr>
              </thead>
              <tbody>
                {values.map(({ own, planned }) => {
                  const { name, label } = settableWords(words, action, planned);
                  return (
                    <tr key={planned.q}>
                      <th scope="row">
                        <span className="number">{name}</span> <span className="soft small">{label}</span>
                      </th>
                      <td className="number">{formatNumber(language, own)}</td>
                      <td className="number">{formatNumber(language, planned.value)}</td>
                      <td>{planned.reason && <ValueReason of={planned.reason} />}</td>
                    </tr>
                  );
                })}
              </tbody>
            </table>
          )}
        </details>
      )}
    </li>
  );
}
