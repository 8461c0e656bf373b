import { formatNumber } from "../../../i18n/number.ts";
import { dayText, momentWriter, timeText } from "../../../app/base/clock-text.ts";
import { useSettings } from "../../../app/base/settings/settings.ts";
import type { RerunOutcome, ResultColumn, ResultRow } from "../../../app/records/course/result-rows.ts";
import { useTexts } from "../../../app/base/settings/use-texts.ts";

const MINUTE = 60;

/** Local day and time as spreadsheets of any language read them: 2026-11-23 14:05. */
function sheetDay(made: number): string {
  const day = new Date(made);
  return `${dayText(day)} ${timeText(day)}`;
}

/** The texts of result cells, on the screen and in the export. */
export function useResultCells(again: ReadonlyMap<string, RerunOutcome>) {
  const { results: words } = useTexts("course-teach");
  const language = useSettings((s) => s.language);
  const day = momentWriter(language);
  const heads: Readonly<Record<ResultColumn, string>> = {
    name: words.name,
    made: words.made,
    task: words.task,
    state: words.state,
    again: words.again,
    tries: words.tries,
    hints: words.hints,
    solution: words.solution,
    time: words.time,
    steps: words.steps,
    machining: words.machining,
    score: words.score,
  };
  const told: Readonly<Record<RerunOutcome, string>> = {
    passes: words.againPasses,
    fails: words.againFails,
    unknown: words.unknown,
    predicted: words.predicted,
    none: words.none,
    stopped: words.stopped,
  };
  const number = (value: number) => formatNumber(language, value, 0);
  const text = ({ key, name, made, state, result }: ResultRow): Readonly<Record<ResultColumn, string>> => {
    const is = again.get(key);
    return {
      name: name === "" ? words.noName : name,
      made: day(made),
      task: result.title,
      state: words.states[state],
      again: is ? told[is] : "…",
      tries: number(result.tries),
      hints: number(result.hints),
      solution: result.solution ? words.yes : words.no,
      time:
        result.worked < MINUTE ? words.seconds(number(result.worked)) : words.minutes(number(result.worked / MINUTE)),
      steps: number(result.steps),
      machining: result.seconds === null ? "–" : words.seconds(number(result.seconds)),
      score: result.score === null ? "–" : number(result.score),
    };
  };
  /** The cell of the export: numbers stay numbers. */
  const plain = (row: ResultRow, column: ResultColumn): string | number | null => {
    const { result } = row;
    const cells: Partial<Record<ResultColumn, string | number | null>> = {
      name: row.name,
      made: sheetDay(row.made),
      tries: result.tries,
      hints: result.hints,
      time: Math.round(result.worked),
      steps: result.steps,
      machining: result.seconds,
      score: result.score,
    };
    const cell = cells[column];
    return cell === undefined ? text(row)[column] : cell;
  };
  return { day, heads, text, plain };
}
