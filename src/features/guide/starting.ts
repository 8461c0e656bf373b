import type { Cycle } from "../../cycles/define.ts";
import type { CutMaterial } from "../../program/tools/cutting-table.ts";
import { SPINDLE } from "../../report/advice/advise.ts";

/** A starting value of a material, and the prompt, or the spindle, that it is for. */
export interface StartingValue {
  readonly at: string;
  readonly of: "roughSpeed" | "roughFeed" | "finishFeed";
  /** m/min, or mm per revolution. */
  readonly value: number;
}

/** Starting values of a material for the speed and the feeds of a cycle. */
export function startingValues({ params }: Pick<Cycle, "params">, material: CutMaterial): readonly StartingValue[] {
  const promptOf = (shown: string) => Object.entries(params).find(([, param]) => param.shown === shown)?.[0];
  const feeds = [
    ["roughingFeed", "roughFeed"],
    ["finishingFeed", "finishFeed"],
  ] as const;
  return [
    { at: SPINDLE, of: "roughSpeed", value: material.roughSpeed },
    ...feeds.flatMap(([shown, of]): StartingValue[] => {
      const at = promptOf(shown);
      return at === undefined ? [] : [{ at, of, value: material[of] }];
    }),
  ];
}
