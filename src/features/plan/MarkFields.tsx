import type { FinishedPart, RowMark } from "../../planning/part/finished-part.ts";
import type { PartProblem } from "../../planning/part/part-problem.ts";
import { LabelledInput } from "../../app/fields/number/LabelledInput.tsx";
import { Message } from "../../app/base/Message.tsx";
import { closeStep } from "../../app/document/steps.ts";
import { goToElement } from "../../app/place/contour-place.ts";
import { showSide } from "./plan-place.ts";
import { SIDES, tableId, withMark, type Side } from "./part-rows.ts";
import { problemWords, type PlanWords } from "../../app/fields/plan/plan-words.ts";
import { ValueField } from "./ValueField.tsx";

interface Props {
  readonly words: PlanWords;
  readonly part: FinishedPart;
  readonly side: Side;
  /** Index of the selected row of the contour table. */
  readonly row: number | null;
  readonly problems: readonly PartProblem[];
  readonly onPart: (part: FinishedPart, place: string) => void;
}

/** Range of a roughness, µm. */
export const ROUGHNESS = [0.01, 1000] as const;

const markText = ({ thread, undercut, tolerance, ra }: RowMark): string =>
  [thread, undercut, tolerance, ra !== undefined && `Ra ${ra}`].filter(Boolean).join(" · ");

/** What the drawing says about the selected element, and the list of all marks. */
export function MarkFields({ words, part, side, row, problems, onPart }: Props) {
  const { mark: t } = words.t;
  const own = row === null ? undefined : part[side][row];
  const mark = (own && part.marks[own.id]) ?? {};
  const change = (name: keyof RowMark, value: string | number | undefined) =>
    own && onPart(withMark(part, own.id, { [name]: value }), `mark ${own.id} ${name}`);
  const found = problems.filter((p) => p.code !== "row" && p.row === own?.id);
  const numberOf = (id: string) => 1 + Math.max(...SIDES.map((each) => part[each].findIndex((r) => r.id === id)));
  const said = (codes: readonly string[]) =>
    found
      .filter(({ code }) => codes.includes(code))
      .map((problem) => (
        <Message key={problem.code} tone={problem.severity}>
          {problemWords(words, problem, numberOf)}
        </Message>
      ));
  const field = (name: "thread" | "tolerance" | "undercut", label: string, hint: string, codes: readonly string[]) => (
    <LabelledInput
      className="setup-field plan-text"
      label={label}
      kind="text"
      text={mark[name] ?? ""}
      placeholder={hint}
      maxLength={60}
      onText={(text) => change(name, text)}
      onLeave={closeStep}
      aria-invalid={found.some(({ code }) => codes.includes(code))}
      messages={said(codes)}
    />
  );
  const listed = SIDES.flatMap((each) =>
    part[each].flatMap(({ id }, i) => {
      const of = part.marks[id];
      return of ? [{ side: each, id, number: i + 1, text: markText(of) }] : [];
    }),
  );
  return (
    <fieldset className="setup-group plan-marks">
      <legend>{own && row !== null ? t.title(row + 1) : t.listed}</legend>
      {own && row !== null ? (
        <div key={own.id}>
          {field("thread", t.thread, t.threadHint, ["threadName", "threadPlace"])}
          {field("tolerance", t.tolerance, t.toleranceHint, ["toleranceText", "tolerancePlace"])}
          {own.kind !== "UDC" && field("undercut", t.undercut, t.undercutHint, ["undercutName"])}
          <ValueField
            name={t.roughness}
            unit={t.micron}
            range={ROUGHNESS}
            value={mark.ra}
            onValue={(value) => change("ra", value)}
          />
        </div>
      ) : (
        <p className="small soft">{t.none}</p>
      )}
      {listed.length > 0 && (
        <ul className="plan-marked" aria-label={t.listed}>
          {listed.map((each) => (
            <li key={each.id}>
              <button
                type="button"
                className="button small"
                aria-label={t.go(each.number, each.text)}
                aria-pressed={each.id === own?.id}
                onClick={() => {
                  showSide(each.side);
                  goToElement(tableId(each.id));
                }}
              >
                <b className="number">{each.number}</b> {each.text}
              </button>
            </li>
          ))}
        </ul>
      )}
    </fieldset>
  );
}
