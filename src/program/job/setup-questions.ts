import type { Cycle } from "../../cycles/define.ts";
import type { Issue } from "../../kernel/plan/issue.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { diameter, radius, rounded, toDiameter, toRadius } from "../../kernel/units.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { anyNumber, readText } from "../values/field.ts";
import { programIssue, type ProgramIssue } from "../state/issue.ts";
import type { BlankDraft, SetJob } from "./job.ts";
import type { SetupPlace } from "./setup-places.ts";
import type { EstimatedWork } from "../values/estimated-work.ts";
import type { Setup } from "./setup.ts";
import { endInFront, endsAlong, endsExchangedAlong, startInFront } from "../values/dimension-slips.ts";
import type { DraftReading } from "./read-draft.ts";

/** Largest part of a contour in front of the blank without a question: cuts begin in the air. */
const MOST_AHEAD = 0.5;

/** A job as typed, with its set-up. */
export interface QuestionInput {
  readonly cycle: Cycle;
  readonly job: Pick<SetJob, "blank" | "tool">;
  readonly setup: Setup;
  readonly partial: DraftReading["partial"];
  readonly tools: readonly Tool[];
}

const numberAt = (blank: BlankDraft, field: keyof BlankDraft) => readText(anyNumber, blank[field]).value;

/** Questions a sign or an order along Z, as far as tool, blank and start are chosen. */
function slips({ cycle, job, setup, partial, tools }: QuestionInput, { from, to }: EstimatedWork): Issue[] {
  const front = setup.proposed.has("blank.allowance") ? null : numberAt(job.blank, "allowance");
  const tool = setup.proposed.has("tool") ? null : (tools.find(({ T }) => T === job.tool) ?? null);
  const startZ = setup.proposed.has("start.z") ? null : readText(anyNumber, setup.start.z).value;
  const blank = front === null ? null : { front };
  const found =
    endInFront({ cycle, values: partial, from: from.z, to: to.z, blank, tool }) ??
    startInFront({ cycle, values: partial, to: to.z, blank }) ??
    (tool || !blank ? endsExchangedAlong(cycle, partial, tool, startZ) : null);
  return found ? [found] : [];
}

/** Reports a set blank that contradicts the contour, which is cut in the air or out of the blank. */
function blankQuestions({ cycle, job, setup, partial }: QuestionInput, work: EstimatedWork): ProgramIssue[] {
  const { box, inside, shape } = work;
  const { blank } = job;
  const free = cycle.contour === "free";
  const [across, along] = [endsAlong(cycle, "diameter"), endsAlong(cycle, "axial")];
  const typed = (q: string) => typeof partial[q] === "number";
  const isSet = (place: SetupPlace) => !setup.proposed.has(place);
  const [outside, bore, length, front] = (["outside", "bore", "length", "allowance"] as const).map((field) =>
    numberAt(blank, field),
  );
  const proposal = (field: keyof BlankDraft) => numberAt(setup.proposal.blank, field) ?? 0;
  const of = (r: number) => rounded(toDiameter(radius(r)));
  const at = (wanted: number) => across.find((q) => partial[q] === wanted);
  const found: ProgramIssue[] = [];
  const ask = (
    place: "outside" | "bore" | "length" | "allowance",
    contour: number,
    has: number,
    other = at(contour),
    thread = false,
  ) => {
    const data = {
      place: thread ? ("thread" as const) : place,
      contour,
      blank: has,
      nearest: proposal(place),
      ...(other !== undefined && { other }),
    };
    found.push(programIssue("blankAgainstContour", "warning", data, `blank.${place}`));
  };
  if (free ? work.hasContour : across.some(typed)) {
    const radiusOf = (d: number) => toRadius(diameter(d));
    if (isSet("blank.outside") && typeof outside === "number" && outside > 0) {
      const largest = free
        ? of(box.high)
        : Math.max(...across.flatMap((q) => (typed(q) ? [partial[q] as number] : [])));
      if (largest > outside + SAME) ask("outside", largest, outside);
      else if (shape === "thread" && !work.across && !inside && box.high < radiusOf(outside) - SAME)
        ask("outside", of(box.high), outside, undefined, true);
    }
    if (
      isSet("blank.bore") &&
      inside &&
      shape !== "thread" &&
      typeof bore === "number" &&
      box.high <= radiusOf(bore) + SAME
    )
      ask("bore", of(box.high), bore);
  }
  if (typeof front === "number" && (free ? work.hasContour : along.every(typed)) && work.to.z <= work.from.z) {
    const ahead = box.right - front;
    const end = along.find((q) => partial[q] === box.left);
    const begin = along.find((q) => partial[q] === box.right);
    if (isSet("blank.allowance") && ahead > MOST_AHEAD * (box.right - box.left) + SAME)
      ask("allowance", box.right, front, begin);
    else if (isSet("blank.length") && typeof length === "number" && box.left < front - length - SAME)
      ask("length", box.left, front - length, end);
  }
  return found;
}

/** Questions where values and set-up disagree, each with a correction. None is an error: both may be intended. */
export function setupQuestions(asked: QuestionInput): readonly (Issue | ProgramIssue)[] {
  const { work } = asked.setup;
  if (!work) return [];
  const questioned = slips(asked, work);
  const blank = blankQuestions(asked, work);
  // A start in front of the blank is either a sign or the blank; the sign is asked first.
  const isFront = ({ at }: ProgramIssue) => at === "blank.allowance";
  return [...questioned, ...(questioned.length > 0 ? blank.filter((each) => !isFront(each)) : blank)];
}
