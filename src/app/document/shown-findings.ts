import { fileKey } from "../../program/state/program-files.ts";
import type { Operation, RunFinding } from "../../program/state/run-types.ts";

/** Where something stands: in the program that runs, or in a file that it calls. */
type Placed = Pick<RunFinding, "block" | "line"> & { readonly inFile?: RunFinding["inFile"] | undefined };

/** True when a place is in the text of a file, null being the program that runs. */
export const isIn = ({ inFile }: Pick<Placed, "inFile">, file: string | null): boolean =>
  file === null ? !inFile : inFile !== undefined && fileKey(inFile.file) === fileKey(file);

/** A place as the text of its own file counts it. */
export const ownPlace = ({ block, line, inFile }: Placed): Pick<RunFinding, "block" | "line"> =>
  inFile ?? { block, line };

/**
 * The findings that belong to the text that is shown, at their places in it. In the program that runs those of a called
 * one stand at the call, and still say where they are.
 */
export function findingsShown(findings: readonly RunFinding[], file: string | null): readonly RunFinding[] {
  if (file === null) return findings;
  return findings
    .filter((found) => isIn(found, file))
    .map(({ issue, operation, ...at }) => ({ issue, operation, ...ownPlace(at) }));
}

/** True when the cycle of an operation is defined in the text of a file, null being the program that runs. */
export const isDefinedIn = ({ definedFile }: Pick<Operation, "definedFile">, file: string | null): boolean =>
  file === null ? definedFile === undefined : definedFile !== undefined && fileKey(definedFile) === fileKey(file);

/** Findings of a list that stand in the text of a file, null being the program that runs. */
export const findingsHere = <F extends Pick<Placed, "inFile">>(
  findings: readonly F[],
  file: string | null,
): readonly F[] => findings.filter((found) => isIn(found, file));
