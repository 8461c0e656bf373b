import type { AnyIssue } from "../../i18n/message-texts.ts";
import { parse } from "../../nc/parse.ts";
import { weightOf, type FindingEntry } from "./entry.ts";

type Found = Omit<FindingEntry, "id">;
type Codes = readonly AnyIssue["code"][];

/** Codes of a tool that cannot do the work at all: another contour or value would not help. */
const WRONG_TOOL: ReadonlySet<string> = new Set<AnyIssue["code"]>(["toolUnfit", "toolCannotCutSideways"]);
const OF_WRONG_TOOL: Codes = [
  "angleNotFollowed",
  "cornerSmallerThanInsert",
  "recessNarrowerThanTool",
  "nothingToCut",
  "depthOverCutLength",
  "nothingCut",
];

/** "Not verified from this block" says more than that the block is not simulated, or not understood. */
const OF_UNPROVED: Codes = ["cycleNotSimulated", "notSimulated", "notUnderstood", "wordNotUnderstood"];

/** Findings in the block of a typing slip: with the right spelling they are gone. */
const OF_SLIP: Codes = ["notProved", "notSimulated", "wordMissing", "feedMissing", "spindleMissing"];
/** Findings elsewhere that follow from a block that is not read, by the kind of the block. */
const OF_UNREAD: Readonly<Record<string, Codes>> = {
  toolCall: ["noToolCalled", "betterTool"],
  cycle: ["noCycleDefined"],
  cycleCall: ["cycleNeverCalled"],
  mode: ["notInTurnMode"],
  spin: ["spindleMissing", "spindleStopped"],
  label: ["labelMissing"],
  blankCylinder: ["blankMissing"],
  blankRotation: ["blankMissing"],
};

const fixText = ({ issue }: Found): string | null =>
  (issue.code === "notUnderstood" || issue.code === "wordNotUnderstood") && "fix" in issue && issue.fix
    ? issue.fix.text
    : null;

const placeOf = ({ block, inFile }: Found): string => (inFile ? `${inFile.file} ${inFile.line}` : `${block}`);

const NOWHERE = (): boolean => false;

/** The findings elsewhere that follow from one, or repeat it. */
function followersOf(cause: Found): (other: Found) => boolean {
  const { issue, block } = cause;
  const text = fixText(cause);
  if (text !== null) {
    const kind = parse(text).blocks[0]?.statement.kind ?? "";
    const codes: readonly string[] = issue.code === "notUnderstood" ? (OF_UNREAD[kind] ?? []) : [];
    return codes.length > 0 ? ({ issue: { code } }) => codes.includes(code) : NOWHERE;
  }
  switch (issue.code) {
    case "contourMissing":
      return issue.data.label === ""
        ? (other) =>
            other.issue.code === "contourTooShort" ||
            other.issue.code === "nothingToCut" ||
            (other.issue.code === "contourMissing" && other.at !== "contour")
        : NOWHERE;
    case "toolUnknown":
    case "toolIndexUnknown":
      return (other) => other.issue.code === "betterTool" && (other.block ?? 0) >= (block ?? 0);
    case "feedUnlikely":
      // One M136 is missing, however many feeds are in mm/min.
      return issue.data.unit === "mm/min"
        ? (other) => other.issue.code === "feedUnlikely" && other.issue.data.unit === issue.data.unit
        : NOWHERE;
    default:
      return NOWHERE;
  }
}

/**
 * Removes findings that only follow from another one, or repeat it: one cause is one finding. A typing slip counts as
 * much as the gravest finding that follows from it.
 */
export function withoutConsequences(all: readonly Found[]): readonly Found[] {
  const unfit = new Set(
    all.flatMap(({ issue, operation }) =>
      issue.severity === "error" && WRONG_TOOL.has(issue.code) ? [operation] : [],
    ),
  );
  const at = (is: (found: Found) => boolean) => new Set(all.filter(is).map(placeOf));
  const slips = at((found) => fixText(found) !== null);
  const unproved = at((found) => found.issue.code === "notProved" && !slips.has(placeOf(found)));
  const follows = new Map(all.map((found) => [found, followersOf(found)]));
  const gone = new Map<Found, Found>();
  for (const [cause, follower] of follows) {
    if (follower === NOWHERE || gone.has(cause)) continue;
    for (const other of all) if (other !== cause && follower(other)) gone.set(other, cause);
  }
  const isRepeat = (found: Found): boolean => {
    const { issue, operation } = found;
    const is = (codes: Codes) => codes.includes(issue.code);
    return (
      (unfit.has(operation) && issue.severity !== "error" && is(OF_WRONG_TOOL)) ||
      (is(OF_UNPROVED) && fixText(found) === null && unproved.has(placeOf(found))) ||
      (is(OF_SLIP) && slips.has(placeOf(found)))
    );
  };
  const raised = (slip: Found): Found => {
    const followers = all.filter(
      (each) => gone.get(each) === slip || (isRepeat(each) && placeOf(each) === placeOf(slip)),
    );
    const severity = [slip, ...followers]
      .map(({ issue }) => issue.severity)
      .toSorted((a, b) => weightOf(a) - weightOf(b))[0];
    return { ...slip, issue: { ...slip.issue, severity } as AnyIssue };
  };
  return all
    .filter((found) => !gone.has(found) && !isRepeat(found))
    .map((found) => (fixText(found) === null ? found : raised(found)));
}
