import { useId, useMemo, useState } from "react";
import type { SecondSideTexts } from "../../../i18n/en/second-side.ts";
import { boxAround } from "../../../kernel/area/box.ts";
import type { Ring } from "../../../kernel/geometry/point.ts";
import { radius, toDiameter } from "../../../kernel/units.ts";
import { parse } from "../../../nc/parse.ts";
import { anyNumber, readText } from "../../../program/values/field.ts";
import { secondSide } from "../../../program/edits/second-side.ts";
import { verdictOf } from "../../../report/verdict.ts";
import { leftPieces } from "../../../sim/left-pieces.ts";
import { NumberInput } from "../number/NumberInput.tsx";
import { useOutcome, type Outcome, type OutcomeState } from "../../calculation/outcome.ts";
import { fileNameOf } from "../../base/file-name.ts";
import { openProgram } from "../open/open-program.ts";
import { ModalDialog } from "../../base/ModalDialog.tsx";
import { Message } from "../../base/Message.tsx";
import { useLengths } from "../../calculation/lengths.ts";
import { programName } from "../../document/printed.ts";
import { useTextsOrNull } from "../../base/settings/use-texts.ts";
import { openContent } from "../../document/store.ts";
import { onlyBundle } from "../../document/work.ts";
import { outputInUse } from "../../document/output.ts";
import "./turn-round.css";

/** Largest allowance on a face, mm. */
const MOST_ALLOWANCE = 100;

/** Creates the program for the second clamping from the stock that the open one leaves; `text`: the open one. */
export function SecondSideDialog({ text, done }: { readonly text: string; readonly done: () => void }) {
  const words = useTextsOrNull("second-side");
  return words && <Opened words={words} text={text} done={done} />;
}

type Lack = keyof SecondSideTexts["lack"];

/** Result of the open program, if it is current and usable; otherwise the reason why not. */
function usableOutcome({ newest, planned, paused, stage }: OutcomeState, text: string): Outcome | Lack {
  if (paused) return "older";
  if (!newest || newest.text !== text || planned || stage !== null) return "beginning";
  if (verdictOf(newest.run, newest.simulation).verdict === "faults") return "faults";
  return newest.run.blank.length === 0 ? "noBlank" : newest;
}

interface Props {
  readonly words: SecondSideTexts;
  readonly text: string;
  readonly done: () => void;
}

function Opened({ words: t, text, done }: Props) {
  const left = useOutcome((s) => usableOutcome(s, text));
  const pieces = useMemo(() => (typeof left === "string" ? null : leftPieces(left.simulation)), [left]);
  const lack = typeof left === "string" ? left : pieces?.held ? null : "nothingLeft";
  return (
    <ModalDialog title={t.title} done={done}>
      <p>{t.lead}</p>
      {typeof left === "string" || !pieces?.held ? (
        <>
          <p role="status">{lack && t.lack[lack]}</p>
          <div className="modal-ways">
            <button type="button" className="button primary" disabled>
              {t.open}
            </button>
          </div>
        </>
      ) : (
        <Choice words={t} outcome={left} held={pieces.held} off={pieces.off} />
      )}
    </ModalDialog>
  );
}

interface ChoiceProps {
  readonly words: SecondSideTexts;
  readonly outcome: Outcome;
  readonly held: readonly Ring[];
  readonly off: readonly (readonly Ring[])[];
}

/** Opens the new program as a new work with the tools and output settings of the previous one. */
function openTurned(text: string): void {
  const before = openContent();
  openProgram({
    name: fileNameOf(text),
    text,
    encoding: "utf-8",
    ...onlyBundle(before ?? {}),
    ...(before?.output && { output: before.output }),
    ...(before?.material !== undefined && { material: before.material }),
  });
}

function Choice({ words: t, outcome: { run, simulation, text }, held, off }: ChoiceProps) {
  const group = useId(),
    hint = useId(),
    lengths = useLengths(run),
    { unit, per } = lengths;
  const pieces = useMemo(() => [held, ...off], [held, off]);
  // The cut-off piece is the default; the piece left in the chuck is then the rest of the bar.
  const [chosen, choose] = useState(off.length > 0 ? 1 : 0),
    [typed, type] = useState("0");
  const { value, issue } = readText({ ...anyNumber, optional: false, range: [0, MOST_ALLOWANCE / per] }, typed);
  const made = useMemo(() => {
    const output = outputInUse();
    return secondSide(parse(text), pieces[chosen] ?? held, { allowance: (value ?? 0) * per, output });
  }, [text, pieces, chosen, held, value, per]);
  const size = (piece: readonly Ring[]) => {
    const { left, right, high } = boxAround([...piece]);
    return `⌀${lengths.number(toDiameter(radius(high)))} × ${lengths.number(right - left)} ${unit}`;
  };
  return (
    <>
      {pieces.length > 1 && (
        <fieldset className="turn-round">
          <legend>{t.piece}</legend>
          {pieces.map((piece, i) => (
            <label key={i}>
              <input type="radio" name={group} checked={chosen === i} onChange={() => choose(i)} />
              {i === 0 ? t.held(size(piece)) : t.off(size(piece))}
            </label>
          ))}
        </fieldset>
      )}
      <label className="turn-round-allowance">
        <span>{t.allowance(unit)}</span>
        <NumberInput
          text={typed}
          onText={type}
          signed={false}
          aria-label={t.allowance(unit)}
          aria-invalid={issue !== null}
          aria-describedby={hint}
        />
        {issue ? (
          <Message as="span" id={hint} tone="warning">
            {t.allowanceWrong(`${lengths.number(MOST_ALLOWANCE)} ${unit}`)}
          </Message>
        ) : (
          <span id={hint} className="small soft">
            {t.allowanceHint}
          </span>
        )}
      </label>
      <dl className="modal-facts">
        <div>
          <dt>{t.name}</dt>
          <dd>{programName(made)}</dd>
        </div>
        <div>
          <dt>{t.blank}</dt>
          <dd>{size(pieces[chosen] ?? held)}</dd>
        </div>
      </dl>
      {run.plane.length > 0 && <Message tone="warning">{t.milling}</Message>}
      {simulation.proof.unproved.length > 0 && <Message tone="warning">{t.unproved}</Message>}
      <div className="modal-ways">
        <button type="button" className="button primary" disabled={value === null} onClick={() => openTurned(made)}>
          {t.open}
        </button>
      </div>
    </>
  );
}
