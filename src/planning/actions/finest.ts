import { rzOf } from "../values/turning-values.ts";
import type { WantedRoughness } from "../values/values-request.ts";
import type { Chain } from "../types.ts";

/** The finest surface of a section, by Ra or Rz as its mark states; undefined without a mark. */
export function finestOf({ marks }: Pick<Chain, "marks">): WantedRoughness | undefined {
  const wanted = marks.flatMap(({ roughness, rz }): readonly WantedRoughness[] => [
    ...(roughness === undefined ? [] : [{ kind: "Ra", value: roughness } as const]),
    ...(rz === undefined ? [] : [{ kind: "Rz", value: rz } as const]),
  ]);
  return wanted.toSorted((a, b) => rzOf(a) - rzOf(b))[0];
}

/** Whether a section has a toleranced surface: that is finished by itself, when nothing else moves the part any more. */
export const isToleranced = ({ marks }: Pick<Chain, "marks">): boolean =>
  marks.some(({ tolerance }) => tolerance !== undefined);
