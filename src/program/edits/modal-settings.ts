import type { Block } from "../../nc/program.ts";
import type { Statement } from "../../nc/statement.ts";
import { wordsOf } from "../blocks/flow.ts";
import { KEPT_ON, namesContour } from "./operations.ts";

/** Modal settings between two blocks, as the statements that set them; by name, so that states can be compared. */
export interface ModalSettings {
  readonly spin: Statement | null;
  readonly feedUnit: number | null;
  readonly contour: readonly Statement[];
  readonly functions: readonly (number | null)[];
}

export const NO_MODAL_SETTINGS: ModalSettings = {
  spin: null,
  feedUnit: null,
  contour: [],
  functions: KEPT_ON.map(() => null),
};

/** Modal settings after a block. */
function after(now: ModalSettings, { statement: s }: Block): ModalSettings {
  const functions = wordsOf(s)?.functions ?? [];
  const isTool = s.kind === "toolCall" && s.tool !== null;
  const kept = KEPT_ON.map(({ on, off }, i) => {
    const before = isTool ? null : (now.functions[i] ?? null);
    return functions.reduce<number | null>(
      (m, each) => (on.includes(each) ? each : off.includes(each) ? null : m),
      before,
    );
  });
  const names = namesContour(s);
  const begins = names && !(s.kind === "cycleLine" && s.line > 0);
  return {
    spin: s.kind === "spin" ? s : now.spin,
    feedUnit: functions.findLast((m) => m === 136 || m === 137) ?? now.feedUnit,
    contour: names ? [...(begins ? [] : now.contour), s] : now.contour,
    functions: kept,
  };
}

/** Modal settings after some blocks. */
export const modalSettingsAfter = (blocks: readonly Block[], from: ModalSettings): ModalSettings =>
  blocks.reduce(after, from);
