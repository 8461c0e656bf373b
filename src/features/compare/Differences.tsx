import { useState, type KeyboardEvent } from "react";
import type { ComparedOperation } from "../../program/compare/by-operation.ts";
import type { BlockDifference } from "../../program/compare/compare.ts";
import { isListed, isFormattingOnly, type ComparedFile, type Consequences } from "./compared.ts";
import { blockLabel, effectTexts, operationTitle, shownLines, wordTexts, type Wording } from "./compare-words.ts";

/** Differences listed at first, before "more". */
const FIRST = 300;

interface Props {
  readonly wording: Wording;
  readonly files: readonly ComparedFile[];
  readonly consequences: Consequences | null;
  readonly withWriting: boolean;
  readonly onChoose: (file: ComparedFile, difference: BlockDifference) => void;
}

/** The rows of the list of differences. */
export const rowsIn = (list: ParentNode | null): readonly HTMLButtonElement[] => [
  ...(list?.querySelectorAll<HTMLButtonElement>(".difference") ?? []),
];

/** Up and down move focus between differences. */
function onKeys(event: KeyboardEvent<HTMLElement>): void {
  const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
  if (by === undefined || !(event.target instanceof HTMLButtonElement) || !event.target.matches(".difference")) return;
  const rows = rowsIn(event.currentTarget);
  const next = rows[rows.indexOf(event.target) + by];
  if (!next) return;
  event.preventDefault();
  next.focus();
  next.scrollIntoView({ block: "nearest" });
}

function Lines({ of, side }: { readonly of: readonly string[]; readonly side: "was" | "is" }) {
  return (
    <span className={`difference-text number ${side}`}>
      {of.map((line, i) => (
        <span key={i}>{line}</span>
      ))}
    </span>
  );
}

function Row({
  wording,
  file,
  difference,
  choose,
}: Pick<Props, "wording"> & {
  readonly file: ComparedFile;
  readonly difference: BlockDifference;
  readonly choose: () => void;
}) {
  const { words } = wording;
  const label = blockLabel(wording, file, difference);
  const said = wordTexts(wording, file, difference);
  const kind = words.kinds[difference.kind];
  const [was, is] = [
    shownLines(file.before, difference.a, difference),
    shownLines(file.after, difference.b, difference),
  ];
  return (
    <li>
      <button
        type="button"
        className={`difference difference-${difference.kind}`}
        onClick={choose}
        aria-label={[`${label}, ${kind}`, ...(said.length > 0 ? said : [...is, ...was].slice(0, 1))].join(": ")}
      >
        <span className="difference-head">
          <b className="number">{label}</b> <span className="difference-kind">{kind}</span>
          {said.map((text) => (
            <span key={text} className="difference-word number">
              {text}
            </span>
          ))}
        </span>
        <span className="difference-sides">
          <Lines of={was} side="was" />
          <Lines of={is} side="is" />
        </span>
      </button>
    </li>
  );
}

/** An operation with its listed differences. */
interface Listed {
  readonly key: string;
  readonly file: ComparedFile;
  readonly operation: ComparedOperation;
  readonly effects: ReturnType<typeof effectTexts>;
  readonly differences: readonly BlockDifference[];
}

/** The listed differences, by operation. */
const listedOperations = ({ wording, files, consequences, withWriting }: Omit<Props, "onChoose">): readonly Listed[] =>
  files.flatMap((file, f) =>
    file.operations.flatMap((operation, o): readonly Listed[] => {
      const consequence = consequences?.operations[f]?.[o];
      if (!isListed(operation, consequence, withWriting)) return [];
      const differences = operation.differences.filter((each) => withWriting || !isFormattingOnly(each));
      const key = `${f} ${operation.a?.place ?? -1} ${operation.b?.place ?? -1}`;
      return [
        {
          key,
          file,
          operation,
          effects: consequence ? effectTexts(wording, consequence, operation.outcome) : [],
          differences,
        },
      ];
    }),
  );

/** Limits the list to its first `most` differences. */
const firstOf = (told: readonly Listed[], most: number): readonly Listed[] =>
  told.reduce<{ readonly list: readonly Listed[]; readonly left: number }>(
    ({ list, left }, each) => {
      const { length } = each.differences;
      if (left <= 0 && length > 0) return { list, left };
      return { list: [...list, { ...each, differences: each.differences.slice(0, left) }], left: left - length };
    },
    { list: [], left: most },
  ).list;

/** All differences, by operation, with their effects. */
export function Differences({ onChoose, ...told }: Props) {
  const { words } = told.wording;
  const [most, show] = useState(FIRST);
  const all = listedOperations(told);
  const left = all.reduce((sum, { differences }) => sum + differences.length, 0) - most;
  return (
    <div className="differences" role="group" aria-label={words.list} onKeyDown={onKeys}>
      {firstOf(all, most).map(({ key, file, operation, effects, differences }) => {
        const fate = words.fates[operation.outcome];
        return (
          <section key={key} className="compared-operation">
            <h3>
              {file.isMain ? "" : `${file.name}: `}
              {operationTitle(told.wording, operation)} {fate !== "" && <span className="difference-kind">{fate}</span>}
            </h3>
            {effects.length > 0 && (
              <ul className="compared-effects">
                {effects.map(({ name, text }) => (
                  <li key={name} className="number">
                    {text}
                  </li>
                ))}
              </ul>
            )}
            {differences.length > 0 && (
              <ol className="difference-list">
                {differences.map((each) => (
                  <Row
                    key={`${each.kind} ${each.a} ${each.b}`}
                    wording={told.wording}
                    file={file}
                    difference={each}
                    choose={() => onChoose(file, each)}
                  />
                ))}
              </ol>
            )}
          </section>
        );
      })}
      {left > 0 && (
        <button type="button" className="button" onClick={() => show(most + FIRST)}>
          {words.more(Math.min(FIRST, left))}
        </button>
      )}
    </div>
  );
}
