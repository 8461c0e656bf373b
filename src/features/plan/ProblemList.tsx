import type { FinishedPart } from "../../planning/part/finished-part.ts";
import type { PartProblem } from "../../planning/part/part-problem.ts";
import { Message } from "../../app/base/Message.tsx";
import { goToElement } from "../../app/place/contour-place.ts";
import { showSide, showTab } from "./plan-place.ts";
import { SIDES, tableId } from "./part-rows.ts";
import { problemWords, type PlanWords } from "../../app/fields/plan/plan-words.ts";

/** What is wrong with a part; a problem of an element leads to it. */
export function ProblemList({
  words,
  part,
  problems,
}: {
  readonly words: PlanWords;
  readonly part: FinishedPart;
  readonly problems: readonly PartProblem[];
}) {
  const { t } = words;
  if (problems.length === 0) return null;
  const isError = problems.some(({ severity }) => severity === "error");
  const numberOf = (id: string) => 1 + Math.max(...SIDES.map((side) => part[side].findIndex((row) => row.id === id)));
  return (
    <ul className="plan-problems" aria-label={isError ? t.run.problems : t.run.remarks}>
      {problems.map((problem, i) => {
        const { row, side } = problem,
          text = problemWords(words, problem, numberOf);
        const isOfRow = row !== undefined && (side === "outside" || side === "inside");
        return (
          <Message key={i} as="li" tone={problem.severity}>
            {isOfRow ? (
              <button
                type="button"
                className="plan-link"
                onClick={() => {
                  showTab("part");
                  showSide(side);
                  goToElement(tableId(row));
                }}
              >
                {text}
              </button>
            ) : (
              text
            )}
          </Message>
        );
      })}
    </ul>
  );
}
