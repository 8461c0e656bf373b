import { fileKey } from "../../program/state/program-files.ts";
import type { Operation, RunFinding } from "../../program/state/run-types.ts";

/** A place in the main program, or in a file that it calls. */
type Placed = Pick<RunFinding, "block" | "line"> & { readonly inFile?: RunFinding["inFile"] | undefined };

/** True if a place is in a file, null being the main program. */
export const isIn = ({ inFile }: Pick<Placed, "inFile">, file: string | null): boolean =>
  file === null ? !inFile : inFile !== undefined && fileKey(inFile.file) === fileKey(file);

/** A place by the lines and blocks of its own file. */
export const ownPlace = ({ block, line, inFile }: Placed): Pick<RunFinding, "block" | "line"> =>
  inFile ?? { block, line };

/**
 * The findings of the shown text, at their places in it. In the main program those of a called file are at the call,
 * and still name their file.
 */
export function findingsShown(findings: readonly RunFinding[], file: string | null): readonly RunFinding[] {
  if (file === null) return findings;
  return findings
    .filter((found) => isIn(found, file))
    .map(({ issue, operation, ...at }) => ({ issue, operation, ...ownPlace(at) }));
}

/** True if the cycle of an operation is defined in a file, null being the main program. */
export const isDefinedIn = ({ definedFile }: Pick<Operation, "definedFile">, file: string | null): boolean =>
  file === null ? definedFile === undefined : definedFile !== undefined && fileKey(definedFile) === fileKey(file);

/** The findings of a list that are in a file, null being the main program. */
export const findingsHere = <F extends Pick<Placed, "inFile">>(
  findings: readonly F[],
  file: string | null,
): readonly F[] => findings.filter((found) => isIn(found, file));
