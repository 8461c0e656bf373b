import { useEffect, useMemo } from "react";
import type { Answer, TaskMark } from "../../../course/judge/judgement.ts";
import type { Task } from "../../../course/task.ts";
import { answerKindOf, typedPlace, type ComparedAnswer } from "../../../course/predicted-answers.ts";
import type { CourseTaskTexts } from "../../../i18n/en/course-task.ts";
import type { Language } from "../../../i18n/languages.ts";
import { formatFixed } from "../../../i18n/number.ts";
import { at, type Pt, type Ring } from "../../../kernel/geometry/point.ts";
import { axial, radius, toDiameter } from "../../../kernel/units.ts";
import { useOutcome } from "../../../app/calculation/outcome.ts";
import { boundsRound } from "../../../app/findings/spots.ts";
import type { PicturePlace } from "../../../app/pictures/lathe/places.ts";
import { useTaskMarks, type TaskMarks } from "../../../app/pictures/lathe/task-marks.ts";
import { useEditor } from "../../../app/document/store.ts";
import { placeWords } from "./mark-words.ts";
import { markId, momentOf } from "./show-mark.ts";
import { useTaskView } from "./task-view.ts";
import { setPrediction, taskOfWork } from "../../../app/document/work-task.ts";

/** Decimals of a pointed place, mm. */
const POINTED = 1;
const NO_RINGS: readonly Ring[] = [];
const NO_TEXTS: readonly string[] = [];

type Shown = Omit<PicturePlace, "issue">;
const lookAt = (shown: Shown): PicturePlace => ({ ...shown, issue: null });

/** The places of the marks, with the numbers of the list. */
export function markPlaces(
  marks: readonly TaskMark[],
  { run }: Answer,
  say: (mark: TaskMark) => string,
): readonly PicturePlace[] {
  const all = marks.flatMap(({ rings = NO_RINGS }) => rings);
  return marks.flatMap((mark, i) =>
    mark.place
      ? [
          lookAt({
            id: markId(i),
            kind: mark.rule === "residue" ? "residual" : "finding",
            mark: String(i + 1),
            place: mark.place,
            // A slip explains the others: it is seen in what they show.
            bounds: boundsRound(mark.rings ?? (mark.slip ? all : NO_RINGS), mark.place),
            line: say(mark),
            position: momentOf(mark, run),
          }),
        ]
      : [],
  );
}

const START = { step: 0, fraction: 0 } as const;

/** A predicted place as a mark in the picture. */
const predictedPlace = (place: Pt, question: number, line: string): PicturePlace =>
  lookAt({
    id: `told ${question}`,
    kind: "told",
    mark: "?",
    place,
    bounds: boundsRound(NO_RINGS, place),
    line,
    position: START,
  });

/** Predicted and actual places. */
function comparedPlaces(
  compared: readonly ComparedAnswer[],
  t: CourseTaskTexts,
  reveals: boolean,
): Omit<TaskMarks, "onPoint"> {
  const { shown } = useOutcome.getState();
  const shownTruths = compared.filter(({ right, isKept }) => !isKept && (reveals || right));
  const places = compared.flatMap((each, i): readonly PicturePlace[] => {
    const { prediction, predicted, truth } = each;
    if (truth.kind !== "place") return [];
    const said =
      predicted !== null && typeof predicted === "object" ? [predictedPlace(predicted, i, t.predict.yours)] : [];
    if (!truth.place || !shownTruths.includes(each)) return said;
    const stays = prediction.ask === "residuePlace";
    const found = shown?.simulation.findings.find(
      ({ place }) => place.z === truth.place?.z && place.r === truth.place.r,
    );
    const position = found ? { step: found.step, fraction: prediction.ask === "rapidPlace" ? 0 : 1 } : null;
    return [
      ...said,
      lookAt({
        id: `truth ${i}`,
        kind: stays ? "residual" : "finding",
        mark: stays ? "A" : "1",
        place: truth.place,
        bounds: boundsRound(truth.rings, truth.place),
        line: t.predict.truth,
        position: position ?? { step: shown?.run.steps.length ?? 0, fraction: 0 },
      }),
    ];
  });
  const rings = (stays: boolean) =>
    shownTruths.flatMap(({ prediction, truth }) =>
      truth.kind === "place" && (prediction.ask === "residuePlace") === stays ? [...truth.rings] : [],
    );
  return { places, missing: rings(false), left: rings(true) };
}

/** Shows the places of the panel in the picture: predicted places, actual places, or the marks of a check. */
export function useTaskPicture(
  task: Task,
  t: CourseTaskTexts,
  language: Language,
  marks: readonly TaskMark[] | null,
  say: (mark: TaskMark) => string,
): void {
  const veiled = useEditor((s) => taskOfWork(s)?.veiled ?? false);
  const told = useEditor((s) => taskOfWork(s)?.told ?? NO_TEXTS);
  const { checked, stale, comparedAnswers, question } = useTaskView();
  const picture = useMemo((): TaskMarks | null => {
    const predict = task.predict ?? [];
    if (veiled) {
      const asked = predict[question];
      const take = (place: Pt) =>
        setPrediction(
          question,
          `${formatFixed(language, toDiameter(radius(Math.abs(place.r))), POINTED)} ${formatFixed(language, place.z, POINTED)}`,
        );
      const places = predict.flatMap((prediction, i) => {
        const place = answerKindOf(prediction) === "place" ? typedPlace(told[i] ?? "") : null;
        return place ? [predictedPlace(place, i, t.where.at(t.predict.yours, ...placeWords(language, place)))] : [];
      });
      const asks = asked !== undefined && answerKindOf(asked) === "place";
      return {
        places,
        missing: NO_RINGS,
        left: NO_RINGS,
        onPoint: asks ? ({ z, r }) => take(at(axial(z), radius(r))) : null,
      };
    }
    if (marks && checked && !stale) {
      const rings = (stays: boolean) =>
        marks.flatMap(({ rule, rings: all = [] }) => ((rule === "residue") === stays ? [...all] : []));
      return {
        places: markPlaces(marks, checked.answer, say),
        missing: rings(false),
        left: rings(true),
        onPoint: null,
      };
    }
    if (comparedAnswers?.some(({ truth }) => truth.kind === "place") && !checked)
      return { ...comparedPlaces(comparedAnswers, t, task.kind === "predict"), onPoint: null };
    return null;
  }, [task, t, language, marks, say, veiled, told, question, checked, stale, comparedAnswers]);
  useEffect(() => {
    useTaskMarks.setState({ told: picture });
    return () => useTaskMarks.setState({ told: null });
  }, [picture]);
}
