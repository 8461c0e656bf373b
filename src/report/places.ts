import type { AnyCode, AnyIssue } from "../i18n/message-texts.ts";
import type { Operation, RunFinding } from "../program/state/run-types.ts";

/** A finding with the key of its operation, as a block with its cycle. */
export interface FindingOfWork {
  readonly issue: AnyIssue;
  readonly work: string;
}

/** A finding that may represent several, listed in order; block and place are those of the first. */
export type JoinedFinding<T extends FindingOfWork> = T & { readonly joined?: readonly T[] };

/** Findings in the stock: each has its own place, and all other data defines the kind. */
const IN_STOCK: ReadonlySet<AnyCode> = new Set<AnyCode>([
  "materialLeft",
  "gouge",
  "threadOverruns",
  "rapidInStock",
  "holderContact",
  "clampContact",
  "cutBelowContour",
  "intendedCut",
  "cutBehindLimit",
  "behindBlank",
  "startInMaterial",
  "cameLoose",
  "cutOnLoosePiece",
  "toolLimit",
]);

/** The kind of a finding: equal data for the same operation, except place and area. Intended cuts are all one kind. */
function kindOf({ issue, work }: FindingOfWork): string {
  if (issue.code === "intendedCut") return issue.code;
  const {
    x: _x,
    z: _z,
    area: _area,
    ...rest
  } = issue.data as { readonly x?: number; readonly z?: number; readonly area?: number };
  return JSON.stringify([
    issue.code,
    issue.severity,
    issue.at ?? "",
    work,
    IN_STOCK.has(issue.code) ? rest : issue.data,
  ]);
}

/** The operation key of a finding: its block, in its file, and the definition of its operation. */
export function operationKey(
  { block, inFile }: Pick<RunFinding, "block"> & { readonly inFile?: RunFinding["inFile"] | undefined },
  operation: Pick<Operation, "cycle" | "definedLine" | "definedFile"> | undefined,
): string {
  const place = inFile ? `${inFile.file} ${inFile.line}` : `${block ?? ""}`;
  return operation
    ? `${place} cycle ${operation.cycle} ${operation.definedFile ?? ""} ${operation.definedLine}`
    : place;
}

const areaOf = ({ issue }: FindingOfWork): number =>
  "area" in issue.data && typeof issue.data.area === "number" ? issue.data.area : 0;

const blocksOf = ({ issue }: FindingOfWork): readonly number[] =>
  issue.code === "intendedCut" ? issue.data.blocks : [];

function joinedOf<T extends FindingOfWork>(first: T, joined: readonly T[]): JoinedFinding<T> {
  const area = joined.reduce((sum, each) => sum + areaOf(each), 0);
  const data = {
    ...first.issue.data,
    places: joined.length,
    ...(IN_STOCK.has(first.issue.code) && "area" in first.issue.data && { area }),
    ...(first.issue.code === "intendedCut" && { blocks: [...new Set(joined.flatMap(blocksOf))] }),
  };
  return { ...first, issue: { ...first.issue, data } as AnyIssue, joined };
}

/**
 * Joins findings of one kind and operation, where there are more than `few`. The joined finding takes the position of
 * the first, `data.places` counts them, and `data.area` is their sum. A loop over a cycle is one operation.
 */
export function joinPlaces<T extends FindingOfWork>(found: readonly T[], few = 1): JoinedFinding<T>[] {
  const kinds = new Map<string, T[]>();
  for (const each of found) {
    const kind = kindOf(each),
      known = kinds.get(kind);
    if (known) known.push(each);
    else kinds.set(kind, [each]);
  }
  const many = new Map<T, readonly T[]>();
  for (const together of kinds.values())
    if (together.length > few) {
      for (const each of together) many.set(each, together);
    }
  return found.flatMap((each): JoinedFinding<T>[] => {
    const together = many.get(each);
    return together === undefined ? [each] : together[0] === each ? [joinedOf(each, together)] : [];
  });
}
