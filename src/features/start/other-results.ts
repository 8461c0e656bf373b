import type { ExampleId } from "../../examples/index.ts";
import { withoutAccents } from "../../app/fields/chooser/search.ts";
import type { WorkSummary } from "../../app/records/device.ts";

/** Search results besides the cycles. */
export interface OtherResults {
  readonly works: readonly WorkSummary[];
  readonly examples: readonly ExampleId[];
}

/** Most works shown by a search; the newest come first. */
const MOST = 12;

/** Works and examples that contain every search word, in their name or their cycle. */
export function findOtherResults(
  sought: string,
  works: readonly WorkSummary[],
  examples: Readonly<Record<ExampleId, string>>,
): OtherResults {
  const words = withoutAccents(sought)
    .split(/[\s,;]+/)
    .filter((word) => word !== "");
  const fits = (text: string) => words.length > 0 && words.every((word) => withoutAccents(text).includes(word));
  return {
    works: works.filter(({ name, cycle }) => fits(`${name} ${cycle ?? ".h"}`)).slice(0, MOST),
    examples: (Object.keys(examples) as ExampleId[]).filter((id) => fits(`${examples[id]} ${id}`)),
  };
}
